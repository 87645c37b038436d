// SPDX-License-Identifier: GPL-3.0-or-later
// A joystick's stick, drawn and in numbers beneath.
#pragma once

#include <QWidget>
#include <vector>

#include "model/monitor_page_values.h"
#include "paint/palette.h"

class QLabel;

namespace deckpipe {

class SectionTitle;
class StickView;

class StickBox : public QWidget {
  Q_OBJECT

 public:
  explicit StickBox(QWidget* parent = nullptr);

  void setStick(const PageStick& stick);
  void setColours(const Colours& colours);

 private:
  Colours m_colours;
  SectionTitle* m_title;
  StickView* m_view;
  std::vector<QLabel*> m_names;
  QLabel* m_x;
  QLabel* m_y;
};

}  // namespace deckpipe
