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
class QToolButton;

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

// Why a device is as it is, in sentences, the worst first, each with its sign. Two lines are kept whatever
// there is to say, so that nothing below moves; a button unfolds what has no room. Used by DevicePage alone.
class GlyphLabel;

class FaultLines : public QWidget {
  Q_OBJECT

 public:
  explicit FaultLines(QWidget* parent = nullptr);

  void setReasons(const std::vector<PageReason>& reasons);

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override { return {480, heightForWidth(480)}; }
  QSize minimumSizeHint() const override { return {160, foldedHeight()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Line {
    GlyphLabel* sign;
    QLabel* words;
  };
  void addLine();
  int lineHeight() const;
  int foldedHeight() const;
  int wrappedHeight(const QString& text, int width) const;
  QString elidedLines(const QString& text, int width) const;
  int buttonWidth() const;
  // Whether two lines hold all in this width.
  bool fits(int width) const;
  void arrange();

  std::vector<PageReason> m_reasons;
  std::vector<Line> m_lines;
  QToolButton* m_more;
  bool m_isUnfolded = false;
};

}  // namespace deckpipe
