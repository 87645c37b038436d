// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/decode_delegate.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QPainter>

#include "model/decode_model.h"
#include "paint/app_style.h"
#include "panel/common/flat_header.h"

namespace deckpipe {
namespace {

DecodeRow::Line lineOf(const QModelIndex& index) {
  return static_cast<DecodeRow::Line>(index.data(DecodeModel::KindRole).toInt());
}

QFont fontOf(const QFont& base, const QModelIndex& index) {
  QFont font = base;
  if (index.column() == DecodeModel::Raw) {
    font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPixelSize(QFontInfo(base).pixelSize());
  } else if (index.column() == DecodeModel::Value && lineOf(index) == DecodeRow::Line::Title) {
    font.setBold(true);
  }
  return font;
}

QColor inkFor(const QModelIndex& index, const Colours& c) {
  if (lineOf(index) == DecodeRow::Line::Certainty) return c.warning.ink;
  const bool isValue = index.column() == DecodeModel::Name || index.column() == DecodeModel::Value;
  if (!isValue) return c.textSecondary;
  if (index.data(DecodeModel::QuietRole).toBool()) return c.stale.ink;
  const bool isField = lineOf(index) == DecodeRow::Line::Field;
  return index.column() == DecodeModel::Name && !isField ? c.textSecondary : c.text;
}

}  // namespace

void DecodeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
  const Colours& c = coloursOf(option.widget);
  const bool isSelected = (option.state & QStyle::State_Selected) != 0;
  const QColor ground = index.row() % 2 != 0 ? c.surfaceAlternate : c.surface;
  painter->fillRect(option.rect, isSelected ? c.accent.fill : ground);
  if (index.row() == m_pointed && !isSelected) {
    // Lines above and below each cell make one frame of the row.
    for (const int y : {option.rect.top(), option.rect.bottom() - 1})
      painter->fillRect(option.rect.left(), y, option.rect.width(), 2, c.accent.ink);
  }
  const QFont font = fontOf(option.font, index);
  const QRect area = option.rect.adjusted(FlatHeader::kPadding, 0, -FlatHeader::kPadding, 0);
  const QString text = index.data().toString();
  const QFontMetrics metrics(font);
  const bool isSentence = lineOf(index) == DecodeRow::Line::Certainty;
  painter->setFont(font);
  painter->setPen(isSelected ? c.accent.onFill : inkFor(index, c));
  painter->drawText(area,
                    Qt::AlignLeft | Qt::AlignVCenter | (isSentence ? Qt::TextWordWrap : Qt::TextSingleLine),
                    isSentence ? text : metrics.elidedText(text, Qt::ElideRight, area.width()));
}

}  // namespace deckpipe
