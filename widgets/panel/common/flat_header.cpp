// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/flat_header.h"

#include <QDataStream>
#include <QEvent>
#include <QIODevice>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "paint/app_style.h"

namespace deckpipe {

FlatHeader::FlatHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
  setHighlightSections(false);
  setSectionsClickable(false);
  setFixedHeight(std::max(kMinHeight, fontMetrics().height() + 12));
}

void FlatHeader::changeEvent(QEvent* event) {
  QHeaderView::changeEvent(event);
  if (event->type() == QEvent::FontChange) setFixedHeight(std::max(kMinHeight, fontMetrics().height() + 12));
}

void FlatHeader::setGutter(int width) {
  const int scrolled = offset() + m_gutter;
  m_gutter = width;
  scrollTo(scrolled);
}

void FlatHeader::setUsualWidths(const QList<int>& widths) {
  for (int column = 0; column < widths.size(); ++column) {
    const int usual = m_usual.value(column), now = isSectionHidden(column) ? usual : sectionSize(column);
    const bool isChosen = usual > 0 && now != usual;
    resizeSection(column, isChosen ? qRound(1.0 * now * widths[column] / usual) : widths[column]);
  }
  m_usual = widths;
}

void FlatHeader::showUsual() {
  for (int column = 0; column < count(); ++column) {
    setSectionHidden(column, false);
    moveSection(visualIndex(column), column);
  }
  for (int column = 0; column < m_usual.size(); ++column) resizeSection(column, m_usual[column]);
}

QByteArray FlatHeader::saveColumns() const {
  QByteArray state;
  QDataStream out(&state, QIODevice::WriteOnly);
  out << m_usual << saveState();
  return state;
}

bool FlatHeader::restoreColumns(const QByteArray& state) {
  QDataStream in(state);
  QList<int> usual;
  QByteArray columns;
  in >> usual >> columns;
  if (in.status() != QDataStream::Ok || usual.size() != m_usual.size() || !restoreState(columns))
    return false;
  const QList<int> here = std::exchange(m_usual, usual);
  setUsualWidths(here);
  return true;
}

void FlatHeader::paintEvent(QPaintEvent* event) {
  const Colours& c = coloursOf(this);
  const auto fill = [&](int width) {
    QPainter p(viewport());
    p.fillRect(QRect(0, 0, width, viewport()->height()), c.window);
    p.fillRect(QRect(0, viewport()->height() - 1, width, 1), c.outline);
  };
  fill(viewport()->width());
  QHeaderView::paintEvent(event);
  fill(m_gutter);
}

void FlatHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  const Colours& c = coloursOf(this);
  painter->fillRect(rect, c.window);
  painter->fillRect(QRect(rect.left(), rect.bottom(), rect.width(), 1), c.outline);
  // A short line where a column can be taken and made wider.
  painter->fillRect(QRect(rect.right(), rect.top() + 8, 1, rect.height() - 16), c.outline);
  const QRect text = rect.adjusted(kPadding, 0, -kPadding, 0);
  const auto wanted =
      model()->headerData(section, Qt::Horizontal, Qt::TextAlignmentRole).value<Qt::Alignment>();
  const Qt::Alignment alignment = (wanted & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter;
  QString title = model()->headerData(section, Qt::Horizontal).toString();
  if (isSortIndicatorShown() && sortIndicatorSection() == section)
    title += sortIndicatorOrder() == Qt::AscendingOrder ? QStringLiteral(" ▲") : QStringLiteral(" ▼");
  painter->setFont(font());
  painter->setPen(c.textSecondary);
  painter->drawText(text, static_cast<int>(alignment) | Qt::TextSingleLine,
                    fontMetrics().elidedText(title, Qt::ElideRight, text.width()));
}

}  // namespace deckpipe
