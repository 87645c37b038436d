// SPDX-License-Identifier: GPL-3.0-or-later
// The hard stops: a line an axis, its name and its two sides in the words of the device's type.
#pragma once

#include <QWidget>
#include <vector>

#include "model/device_page_values.h"

class QGridLayout;
class QLabel;

namespace deckpipe {

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
