// SPDX-License-Identifier: GPL-3.0-or-later
// A joystick's stick or its grip, drawn and in numbers beneath.
#pragma once

#include <QWidget>
#include <vector>

#include "model/device_page_values.h"

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

 private:
  SectionTitle* m_title;
  StickView* m_view;
  QLabel* m_x;
  QLabel* m_y;
  QLabel* m_theta;  // hidden where there is none
  QLabel* m_thetaName = nullptr;
};

}  // namespace deckpipe
