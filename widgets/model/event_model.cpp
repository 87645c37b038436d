// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_model.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/field_text.h"
#include "text/elapsed_text.h"

namespace deckpipe {

EventModel::EventModel(QObject* parent) : QAbstractTableModel(parent) {}

void EventModel::setView(const LogView& view) {
  if (view.document != m_view.document) {
    beginResetModel();
    m_view = view;
    m_events = {};
    m_notes.clear();
    m_rows.clear();
    m_merged = 0;
    endResetModel();
  }
  m_view = view;
  look();
}

void EventModel::look() {
  if (m_view.document == nullptr) return;
  m_isLooking = !m_events.take(*m_view.document, m_view.frameCount, kFramesAtOnce);
  const bool hasNotes = m_view.document->notes.count() != m_notes.size();
  if (hasNotes || m_events.list().size() != m_merged) merge();
}

// What is new is one run of rows: at the end, or where a note was put in between. Where both came in the same
// tick, rows behind the first are taken out and in again.
void EventModel::merge() {
  std::vector<Note> notes = m_view.document->notes.all();
  std::vector<Row> rows;
  rows.reserve(notes.size() + m_events.list().size());
  std::size_t note = 0;
  const auto takeNotes = [&](std::uint64_t before) {
    for (; note < notes.size() && notes[note].frame <= before; ++note)
      rows.push_back({notes[note].time, notes[note].frame, true, note});
  };
  for (std::size_t i = 0; i < m_events.list().size(); ++i) {
    const Event& event = m_events.list()[i];
    takeNotes(event.frame);
    rows.push_back({event.time, event.frame, false, i});
  }
  takeNotes(std::numeric_limits<std::uint64_t>::max());

  const auto same = [](const Row& a, const Row& b) {
    return a.isNote == b.isNote && a.frame == b.frame && a.time == b.time && (a.isNote || a.index == b.index);
  };
  const auto front = std::mismatch(m_rows.begin(), m_rows.end(), rows.begin(), rows.end(), same);
  const auto back = std::mismatch(m_rows.rbegin(), std::make_reverse_iterator(front.first), rows.rbegin(),
                                  std::make_reverse_iterator(front.second), same);
  const auto first = static_cast<int>(front.first - m_rows.begin());
  const auto removed = static_cast<int>(back.first.base() - front.first);
  const auto added = static_cast<int>(back.second.base() - front.second);
  if (removed > 0) {
    beginRemoveRows({}, first, first + removed - 1);
    m_rows.erase(front.first, back.first.base());
    endRemoveRows();
  }
  if (added > 0) beginInsertRows({}, first, first + added - 1);
  m_rows = std::move(rows);
  m_notes = std::move(notes);
  m_merged = m_events.list().size();
  if (added > 0) endInsertRows();
}

int EventModel::rowAtCursor() const {
  const auto past = std::upper_bound(m_rows.begin(), m_rows.end(), m_view.cursor.time,
                                     [](Instant t, const Row& row) { return t < row.time; });
  return static_cast<int>(past - m_rows.begin()) - 1;
}

int EventModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int EventModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString EventModel::busText(const Row& row) const {
  const FrameStore& frames = m_view.document->frames;
  const auto channel =
      row.isNote ? channelOf(m_notes[row.index].value) : std::optional(m_events.list()[row.index].channel);
  return channel ? toQString(frames.channelName(channel->value)) : QString();
}

QString EventModel::whatText(const Row& row) const {
  return row.isNote ? noteText(*m_view.document, m_notes[row.index]) : eventText(m_events.list()[row.index]);
}

EventWeight EventModel::weight(const Row& row) const {
  return row.isNote ? weightOf(m_notes[row.index]) : weightOf(m_events.list()[row.index]);
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) return {};
  const Row& row = m_rows[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      switch (index.column()) {
        case When: return elapsedText(row.time - m_view.begin);
        case Bus: return busText(row);
        case What: return whatText(row);
        default: return {};
      }
    case Qt::AccessibleTextRole:
      return index.column() == When ? tr("%1: %2").arg(elapsedText(row.time - m_view.begin), whatText(row))
                                    : QVariant();
    case TimeRole: return QVariant::fromValue<qint64>(row.time.ns);
    case WeightRole: return static_cast<int>(weight(row));
    default: return {};
  }
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return QAbstractTableModel::headerData(section, orientation, role);
  if (role == Qt::TextAlignmentRole)
    return QVariant::fromValue(Qt::Alignment(section == When ? Qt::AlignRight : Qt::AlignLeft) |
                               Qt::AlignVCenter);
  if (role == Qt::ToolTipRole && section == When) return tr("Since the log's begin");
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case When: return tr("Time");
    case Bus: return tr("Bus");
    case What: return tr("What happened");
    default: return {};
  }
}

}  // namespace deckpipe
