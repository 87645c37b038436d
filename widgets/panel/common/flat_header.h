// SPDX-License-Identifier: GPL-3.0-or-later
// The column titles of lists: flat, and aligned with the cells below them. For the trace and the decode
// detail, whose cells have the same padding.
#pragma once

#include <QHeaderView>
#include <QList>

namespace deckpipe {

class FlatHeader : public QHeaderView {
  Q_OBJECT

 public:
  static constexpr int kPadding = 6;  // at either side of titles and cells
  static constexpr int kMinHeight = 32;

  explicit FlatHeader(QWidget* parent = nullptr);
  // So much at the left belongs to no column; sections begin behind it and are scrolled under it.
  void setGutter(int width);
  void scrollTo(int offset) { setOffset(offset - m_gutter); }
  // Every column as wide as this. Told again, for other letters, a column that a person made wider or
  // narrower keeps its share.
  void setUsualWidths(const QList<int>& widths);
  // All columns shown, in their order, as wide as usual.
  void showUsual();
  // Widths, order and which are hidden, for settings; fits larger and smaller letters than it was saved in.
  QByteArray saveColumns() const;
  bool restoreColumns(const QByteArray& state);

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  int m_gutter = 0;
  QList<int> m_usual;
};

}  // namespace deckpipe
