// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/decode_delegate.h"

#include <QFontDatabase>
#include <QFontInfo>

#include "model/decode_model.h"

namespace deckpipe {

DecodeDelegate::DecodeDelegate(QObject* parent)
    : QStyledItemDelegate(parent), m_colours(coloursOf(Theme::Light)) {}

void DecodeDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const auto line = static_cast<DecodeRow::Line>(index.data(DecodeModel::KindRole).toInt());
  // The current cell is the row: a second frame within the selection says nothing.
  option->state &= ~QStyle::State_HasFocus;
  QColor ink = m_colours.text;
  if (index.data(DecodeModel::QuietRole).toBool()) ink = m_colours.stale.ink;
  switch (index.column()) {
    case DecodeModel::Name:
      if (line != DecodeRow::Line::Field) ink = m_colours.textSecondary;
      break;
    case DecodeModel::Raw: {
      const int pixels = QFontInfo(option->font).pixelSize();
      option->font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
      option->font.setPixelSize(pixels);
      option->fontMetrics = QFontMetrics(option->font);
      ink = m_colours.textSecondary;
      break;
    }
    case DecodeModel::Place: ink = m_colours.textSecondary; break;
    default: break;
  }
  if (index.column() == DecodeModel::Value && line == DecodeRow::Line::Title) option->font.setBold(true);
  if (line == DecodeRow::Line::Certainty) {
    ink = m_colours.attend.ink;
    if (index.column() == DecodeModel::Value) option->features |= QStyleOptionViewItem::WrapText;
  }
  option->palette.setColor(QPalette::Text, ink);
}

}  // namespace deckpipe
