// SPDX-License-Identifier: GPL-3.0-or-later
// A joystick's stick or its grip, drawn and in numbers beneath.
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
  static constexpr int kWidth = 240;

  // `key` names the box and its parts, never shown: "stick", "grip".
  explicit StickBox(const QString& key, QWidget* parent = nullptr);

  void setStick(const PageStick& stick);
  void setColours(const Colours& colours);

 private:
  Colours m_colours;
  SectionTitle* m_title;
  StickView* m_view;
  std::vector<QLabel*> m_names;
  QLabel* m_x;
  QLabel* m_y;
  QLabel* m_theta;  // hidden where there is none
};

}  // namespace deckpipe
