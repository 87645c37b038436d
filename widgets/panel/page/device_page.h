// SPDX-License-Identifier: GPL-3.0-or-later
// The page of one device: a monitor's dial with stops and outputs, a joystick's stick, a riser's or node's
// own facts. The window tells it which device and gives it each new view; it draws devicePageOf() and sends
// nothing. It scrolls where there is too little room, and puts everything under one another where it is
// narrow. A double click on the dial, or F11, spreads it over the window.
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

#include "model/device_page_values.h"
#include "panel/common/panel_view.h"

class QLabel;
class QScrollArea;

namespace deckpipe {

class Dial;
class FactList;
class FaultLines;
class FullDial;
class LampGrid;
class PageContent;
class PageHeader;
class StickBox;
class StopsGrid;

class DevicePage : public QWidget {
  Q_OBJECT

 public:
  explicit DevicePage(QWidget* parent = nullptr);
  ~DevicePage() override;

  void setView(const PanelView& view);

  const DevicePageValues& values() const { return m_values; }
  // The expression that lets only the device's frames through; empty without a device or address.
  bool hasDial() const { return m_values.isFound && m_values.dial.has_value(); }
  QString traceFilter() const { return m_values.isFound ? m_values.traceFilter : QString(); }

  // Over what the dial spreads, instead of the window: what else is there must be seen with it.
  void setStage(QWidget* stage) { m_stage = stage; }
  // The dial over the whole stage, until Esc, a second double click or this again. Nothing without a dial.
  void toggleFull();
  FullDial* full() const;

  QSize sizeHint() const override { return {1032, 560}; }
  QSize minimumSizeHint() const override { return {320, 120}; }

 Q_SIGNALS:
  // Its frames are wanted in the trace.
  void traceRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void refresh();
  void showValues();
  void showParts();
  void explain();
  QString missingText() const;

  PanelView m_view;
  DevicePageValues m_values;

  PageHeader* m_header;
  QLabel* m_message;  // instead of a page
  PageContent* m_content;
  QScrollArea* m_scroll;
  QWidget* m_stage = nullptr;
  DeviceKey m_explained;
  QPointer<FullDial> m_full;  // the window owns it, and may end before this page does
  Dial* m_dial;
  FaultLines* m_reasons;
  std::vector<StickBox*> m_sticks;  // a joystick's stick and its grip
  StopsGrid* m_stops;
  std::vector<LampGrid*> m_lamps;
  std::vector<FactList*> m_facts;
};

}  // namespace deckpipe
