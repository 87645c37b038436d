// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/decode_model.h"

#include <algorithm>
#include <bit>

#include "model/trace_rows.h"

namespace deckpipe {

DecodeModel::DecodeModel(QObject* parent)
    : TableModel(
          {{tr("Field")},
           {tr("Value")},
           {tr("Raw")},
           {tr("Where"), tr("Byte and bit as the manuals count: bytes from 1, bits 8 to 1; ID: bits of the "
                            "identifier")}},
          parent) {}

void DecodeModel::setView(const LogView& view) {
  if (m_log != view.document) {
    m_log = view.document;
    m_index.reset();
  }
  read();
}

void DecodeModel::setFrame(std::optional<std::uint64_t> frame) {
  m_index = frame;
  read();
}

void DecodeModel::read() {
  std::optional<Frame> content;
  Classified what;
  if (m_log && m_index && *m_index < m_log->frames.count()) {
    content = m_log->frames[*m_index];
    what = classifyAt(*m_log, *m_index);
  }
  if (content == m_content && what == m_what) return;
  std::vector<DecodeRow> rows;
  if (content) rows = decodeRows(*content, what);
  // Stepping through frames of one message keeps the rows, and with them the field that a person looks at.
  const bool sameRows =
      std::equal(rows.begin(), rows.end(), m_rows.begin(), m_rows.end(),
                 [](const DecodeRow& a, const DecodeRow& b) { return a.kind == b.kind && a.name == b.name; });
  m_content = content;
  m_what = what;
  if (sameRows) {
    m_rows = std::move(rows);
    sayChanged(Name, Place);
  } else {
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
  }
  Q_EMIT frameChanged();
}

int DecodeModel::rowOfBit(BitSet64 bit) const {
  int best = -1, bestWidth = 65;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const int width = std::popcount(m_rows[i].bits);
    if ((m_rows[i].bits & bit) == 0 || width >= bestWidth) continue;
    best = static_cast<int>(i);
    bestWidth = width;
  }
  return best;
}

QVariant DecodeModel::cell(int at, int column, int role) const {
  const DecodeRow& row = m_rows[static_cast<std::size_t>(at)];
  switch (role) {
    case Qt::DisplayRole:
      switch (column) {
        case Name: return row.name;
        case Value: return row.value;
        case Raw: return row.raw;
        case Place: return row.place;
        default: return {};
      }
    case Qt::ToolTipRole: return row.tip.isEmpty() ? QVariant() : row.tip;
    case Qt::AccessibleTextRole: return column == Name ? tr("%1: %2").arg(row.name, row.value) : QVariant();
    case KindRole: return static_cast<int>(row.kind);
    case BitsRole: return QVariant::fromValue<quint64>(row.bits);
    case SignBitsRole: return QVariant::fromValue<quint64>(row.signBits);
    case QuietRole: return row.isQuiet;
    default: return {};
  }
}

}  // namespace deckpipe
