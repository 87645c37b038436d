// SPDX-License-Identifier: GPL-3.0-or-later
// A group of facts as lines of sign, label, value and age: faults, versions, address and NAME.
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "model/device_page_values.h"

class QGridLayout;
class QLabel;

namespace deckpipe {

class GlyphLabel;
class SectionTitle;

class FactList : public QWidget {
  Q_OBJECT

 public:
  explicit FactList(QWidget* parent = nullptr);

  void setGroup(const PageFactGroup& group);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Line {
    GlyphLabel* sign;
    QLabel* label;
    QLabel* value;
    QLabel* age;
  };
  void addLine();
  static void fitAge(QLabel& age);
  void show(const Line& line, const PageFact& fact);

  PageFactGroup m_group;
  SectionTitle* m_title;
  QGridLayout* m_grid;
  std::vector<Line> m_lines;
  QTimer m_calm;  // holds back figures that run
  std::optional<PageFactGroup> m_heldBack;
};

}  // namespace deckpipe
