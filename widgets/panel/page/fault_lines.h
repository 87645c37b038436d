// SPDX-License-Identifier: GPL-3.0-or-later
// Why a device is as it is, in sentences, the worst first, each with its sign. Two lines are kept whatever
// there is to say, so that nothing below moves; a button unfolds what has no room. Used by DevicePage alone.
#pragma once

#include <QWidget>
#include <vector>

#include "model/device_page_values.h"

class QLabel;
class QToolButton;

namespace deckpipe {

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
