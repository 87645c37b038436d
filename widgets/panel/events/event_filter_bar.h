// SPDX-License-Identifier: GPL-3.0-or-later
// Which events are listed: a button for each group, which is the legend of the marks too, a device, a weight,
// words. Stands above the list of EventPanel.
#pragma once

#include <QWidget>

#include "base/ids.h"
#include "paint/glyph.h"

class QComboBox;
class QLineEdit;
class QToolButton;

namespace deckpipe {

class EventFilter;
class EventModel;

class EventFilterBar : public QWidget {
  Q_OBJECT

 public:
  EventFilterBar(EventModel* events, EventFilter* filter, QWidget* parent = nullptr);

  // The devices of the events may be others, or have other names.
  void updateDevices();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void drawMarks();
  void takeGroups();

  EventModel* m_events;
  EventFilter* m_filter;
  EnumArray<EventGroup, QToolButton*> m_groups;
  QComboBox* m_device;
  QComboBox* m_weight;
  QLineEdit* m_words;
  std::vector<DeviceKey> m_devices;  // in the order of m_device, behind 'all devices'
};

}  // namespace deckpipe
