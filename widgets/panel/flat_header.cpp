// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/flat_header.h"

#include <QPainter>
#include <algorithm>

namespace deckpipe {

FlatHeader::FlatHeader(QWidget* parent)
    : QHeaderView(Qt::Horizontal, parent), m_colours(coloursOf(Theme::Light)) {
  setHighlightSections(false);
  setSectionsClickable(false);
  setFixedHeight(std::max(kLeastHeight, fontMetrics().height() + 12));
}

void FlatHeader::setColours(const Colours& colours) {
  m_colours = colours;
  viewport()->update();
}

void FlatHeader::setGutter(int width) {
  const int scrolled = offset() + m_gutter;
  m_gutter = width;
  scrollTo(scrolled);
}

void FlatHeader::paintEvent(QPaintEvent* event) {
  const auto fill = [this](int width) {
    QPainter p(viewport());
    p.fillRect(QRect(0, 0, width, viewport()->height()), m_colours.window);
    p.fillRect(QRect(0, viewport()->height() - 1, width, 1), m_colours.outline);
  };
  fill(viewport()->width());
  QHeaderView::paintEvent(event);
  fill(m_gutter);
}

void FlatHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  painter->fillRect(rect, m_colours.window);
  painter->fillRect(QRect(rect.left(), rect.bottom(), rect.width(), 1), m_colours.outline);
  // A short line where a column can be taken and made wider.
  painter->fillRect(QRect(rect.right(), rect.top() + 8, 1, rect.height() - 16), m_colours.outline);
  const QRect text = rect.adjusted(kPadding, 0, -kPadding, 0);
  const auto wanted =
      model()->headerData(section, Qt::Horizontal, Qt::TextAlignmentRole).value<Qt::Alignment>();
  const Qt::Alignment alignment = (wanted & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter;
  QString title = model()->headerData(section, Qt::Horizontal).toString();
  if (isSortIndicatorShown() && sortIndicatorSection() == section)
    title += sortIndicatorOrder() == Qt::AscendingOrder ? QStringLiteral(" ▲") : QStringLiteral(" ▼");
  painter->setFont(font());
  painter->setPen(m_colours.textSecondary);
  painter->drawText(text, static_cast<int>(alignment) | Qt::TextSingleLine,
                    fontMetrics().elidedText(title, Qt::ElideRight, text.width()));
}

}  // namespace deckpipe
