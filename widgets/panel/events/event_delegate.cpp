// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/events/event_delegate.h"

#include <QPainter>
#include <algorithm>
#include <optional>
#include <utility>

#include "model/event_model.h"
#include "paint/app_style.h"
#include "paint/event_mark.h"
#include "paint/figures.h"
#include "paint/severity_look.h"
#include "panel/common/flat_header.h"

namespace deckpipe {
namespace {

constexpr int kSign = 16, kGap = 6;

}  // namespace

bool EventDelegate::setLastRow(int row) { return std::exchange(m_lastRow, row) != row; }

QSize EventDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return {120, std::max(targetHeight(option.widget), option.fontMetrics.height() + 10)};
}

void EventDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  const Colours& c = coloursOf(option.widget);
  const bool isSelected = (option.state & QStyle::State_Selected) != 0;
  const bool hasHappened = index.row() <= m_lastRow;
  const QColor ground = index.row() % 2 != 0 ? c.surfaceAlternate : c.surface;
  painter->fillRect(option.rect, isSelected ? c.accent.fill : ground);
  QColor ink = index.column() == EventModel::What ? c.text : c.textSecondary;
  if (!hasHappened) ink = c.stale.ink;
  if (isSelected) ink = c.accent.onFill;
  QRect area = option.rect.adjusted(FlatHeader::kPadding, 0, -FlatHeader::kPadding, 0);
  const QString text = index.data().toString();
  if (index.column() == EventModel::When) {
    drawFigures(*painter, QRectF(area), {text, {}, option.font, option.font, ink, ink});
    return;
  }
  if (index.column() == EventModel::What) {
    const QRect mark(area.left(), area.center().y() - kSign / 2, kSign, kSign);
    const auto group = static_cast<EventGroup>(index.data(EventModel::GroupRole).toInt());
    const auto weight = static_cast<Severity>(index.data(EventModel::WeightRole).toInt());
    drawEventMark(*painter, QRectF(mark).adjusted(3, 3, -3, -3), group,
                  isSelected || !hasHappened ? ink : eventInk(weight, c));
    const QRect sign(mark.right() + 1 + kGap, mark.top(), kSign, kSign);
    const QColor signInk = isSelected || !hasHappened ? ink : inkOf(c, inkOf(weight));
    if (const auto glyph = glyphOf(weight))
      drawGlyph(*painter, sign.adjusted(1, 1, -1, -1), *glyph, signInk, Qt::transparent, c.stroke);
    area.setLeft(sign.right() + 1 + kGap);
  }
  painter->setFont(option.font);
  painter->setPen(ink);
  painter->drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                    option.fontMetrics.elidedText(text, Qt::ElideRight, area.width()));
}

}  // namespace deckpipe
