// SPDX-License-Identifier: GPL-3.0-or-later
// A group of lamps that came with one message: its title with the age, the lamps in as many columns as have
// room. The lamps stay the same widgets while only values change.
#pragma once

#include <QWidget>

#include <vector>

#include "model/device_page_values.h"

class QGridLayout;
class QLabel;

namespace deckpipe {

class SectionTitle;
class StatusLamp;

class LampGrid : public QWidget {
  Q_OBJECT

 public:
  explicit LampGrid(QWidget* parent = nullptr);

  void setGroup(const PageLampGroup& group);

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  int columns(int width) const;
  int lampHeight() const;
  void layOut();

  PageLampGroup m_group;
  SectionTitle* m_title;
  std::vector<StatusLamp*> m_lamps;
};

// What a page says of a lamp, for the widget.
void setLamp(StatusLamp& lamp, const PageLamp& values, bool isStale, const QString& groupKey);

// The hard stops: a line an axis, its name and its two sides in the words of the device's type.
class SectionTitle;
class StatusLamp;

class StopsGrid : public QWidget {
  Q_OBJECT

 public:
  explicit StopsGrid(QWidget* parent = nullptr);

  void setStops(const PageStops& stops);

 private:
  struct Line {
    QLabel* axis;
    StatusLamp* minus;
    StatusLamp* plus;
  };
  void addLine();

  PageStops m_stops;
  SectionTitle* m_title;
  QGridLayout* m_grid;
  std::vector<Line> m_lines;
};

}  // namespace deckpipe
