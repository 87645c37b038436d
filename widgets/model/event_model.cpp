// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_model.h"

#include <algorithm>
#include <set>
#include <utility>

#include "model/field_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

// Notes among which the question is looked for that an answer belongs to.
constexpr std::size_t kQuestionRows = 256;

bool isOfOneQuestion(const DeviceKey& device, Request request, const Note& ended) {
  const auto* end = std::get_if<note::RequestEnded>(&ended.value);
  return end != nullptr && end->request == request && keyOf(ended) == device;
}

}  // namespace

EventModel::EventModel(QObject* parent)
    : TableModel({{tr("Time"), tr("Since the log's begin"), true},
                  {tr("Bus")},
                  {tr("Device")},
                  {tr("What happened")}},
                 parent) {}

void EventModel::setView(const LogView& view) {
  const unsigned generation = view.document == nullptr ? 0 : view.document->events.generation();
  if (view.document != m_view.document || generation != m_generation) {
    beginResetModel();
    m_view = view;
    m_generation = generation;
    m_events.clear();
    m_notes.clear();
    m_rows.clear();
    endResetModel();
  }
  m_view = view;
  if (m_view.document == nullptr) return;
  const bool hasNotes = m_view.document->notes.count() != m_notes.size();
  if (hasNotes || m_view.document->events.count() != m_events.size()) merge();
}

void EventModel::setLabels(const DeviceLabels& labels) {
  if (labels == m_labels) return;
  m_labels = labels;
  sayChanged(Who, Who);
}

// A question that has ended is told by its end. An end like the last one of that question is one more of it.
std::vector<EventModel::Row> EventModel::noteRows(const std::vector<Note>& notes) const {
  std::vector<Row> rows;
  rows.reserve(notes.size());
  const auto last = [&](std::size_t i, Request request) {
    const DeviceKey device = keyOf(notes[i]);
    const auto end = rows.rbegin() + static_cast<std::ptrdiff_t>(std::min(rows.size(), kQuestionRows));
    const auto found = std::find_if(rows.rbegin(), end, [&](const Row& row) {
      const auto* asked = std::get_if<note::Asked>(&notes[row.index].value);
      return (asked != nullptr && asked->request == request && keyOf(notes[row.index]) == device) ||
             isOfOneQuestion(device, request, notes[row.index]);
    });
    return found == end ? rows.rend() : found;
  };
  for (std::size_t i = 0; i < notes.size(); ++i) {
    if (!isEvent(notes[i].value)) continue;
    const auto* ended = std::get_if<note::RequestEnded>(&notes[i].value);
    if (ended != nullptr) {
      auto before = last(i, ended->request);
      if (before != rows.rend() && std::holds_alternative<note::Asked>(notes[before->index].value)) {
        rows.erase(std::next(before).base());
        before = last(i, ended->request);
      }
      if (before != rows.rend() && notes[before->index].value == notes[i].value) {
        ++before->times;
        continue;
      }
    }
    rows.push_back({notes[i].time, notes[i].frame, true, i, 1});
  }
  return rows;
}

// What is new is one run of rows: at the end, or where a note was put in between. Where both came in the same
// tick, rows behind the first are taken out and in again.
void EventModel::merge() {
  std::vector<Note> notes = m_view.document->notes.all();
  const std::vector<Event> more = m_view.document->events.after(m_events.size());
  m_events.insert(m_events.end(), more.begin(), more.end());
  std::vector<Row> events;
  events.reserve(m_events.size());
  for (std::size_t i = 0; i < m_events.size(); ++i)
    events.push_back({m_events[i].time, m_events[i].frame, false, i, 1});
  const std::vector<Row> noted = noteRows(notes);
  std::vector<Row> rows(events.size() + noted.size());
  // A note stands behind what had happened by then.
  std::merge(
      events.begin(), events.end(), noted.begin(), noted.end(), rows.begin(),
      [](const Row& a, const Row& b) { return std::pair(a.time, a.frame) < std::pair(b.time, b.frame); });

  const auto same = [](const Row& a, const Row& b) {
    return a.isNote == b.isNote && a.frame == b.frame && a.time == b.time && a.times == b.times &&
           (a.isNote || a.index == b.index);
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
  if (added > 0) endInsertRows();
}

QString EventModel::busText(const Row& row) const {
  const FrameStore& frames = m_view.document->frames;
  const auto channel =
      row.isNote ? channelOf(m_notes[row.index].value) : std::optional(m_events[row.index].channel);
  return channel ? toQString(frames.channelName(channel->value)) : QString();
}

QString EventModel::text(int row) const {
  const Row& r = at(row);
  if (!r.isNote) return eventText(m_events[r.index], m_view.begin);
  const QString text = noteText(*m_view.document, m_notes[r.index]);
  return r.times == 1 ? text : tr("%1, %2 times").arg(text).arg(r.times);
}

Severity EventModel::weight(int row) const {
  const Row& r = at(row);
  return r.isNote ? noteWeight(m_notes[r.index].value) : kEvents[m_events[r.index].kind].weight;
}

EventGroup EventModel::group(int row) const {
  const Row& r = at(row);
  return r.isNote ? EventGroup::Note : kEvents[m_events[r.index].kind].group;
}

DeviceKey EventModel::device(int row) const {
  const Row& r = at(row);
  return r.isNote ? keyOf(m_notes[r.index]) : keyOf(m_events[r.index]);
}

QString EventModel::deviceText(int row) const { return nameOf(device(row)); }

std::vector<DeviceKey> EventModel::devices() const {
  std::vector<DeviceKey> keys;
  std::set<DeviceKey> known;
  for (int row = 0; row < rowCount(); ++row) {
    const DeviceKey key = device(row);
    if (!key.isNull() && known.insert(key).second) keys.push_back(key);
  }
  return keys;
}

QString EventModel::whenText(int row) const {
  return m_view.hasTimes() ? elapsedText(time(row) - m_view.begin) : QString(QChar(0x2013));
}

QVariant EventModel::cell(int row, int column, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      switch (column) {
        case When: return whenText(row);
        case Bus: return busText(at(row));
        case Who: return deviceText(row);
        case What: return text(row);
        default: return {};
      }
    case Qt::ToolTipRole: return column == What ? text(row) : QVariant();
    case Qt::AccessibleTextRole:
      if (column != When) return {};
      return tr("%1: %2, %3, %4")
          .arg(whenText(row), eventWeightText(weight(row)), deviceText(row), text(row));
    case TimeRole: return QVariant::fromValue<qint64>(time(row).ns);
    case WeightRole: return static_cast<int>(weight(row));
    case GroupRole: return static_cast<int>(group(row));
    default: return {};
  }
}

EventFilter::EventFilter(EventModel* events, QObject* parent)
    : QSortFilterProxyModel(parent), m_events(events) {
  setSourceModel(events);
}

bool EventFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  if (m_events->weight(row) < m_least) return false;
  if (!m_groups.isEmpty() && !m_groups.has(m_events->group(row))) return false;
  if (!m_device.isNull() && m_events->device(row) != m_device) return false;
  return m_text.isEmpty() || m_events->text(row).contains(m_text, Qt::CaseInsensitive) ||
         m_events->deviceText(row).contains(m_text, Qt::CaseInsensitive);
}

Instant EventFilter::time(int row) const { return m_events->time(mapToSource(index(row, 0)).row()); }

int EventFilter::rowsUntil(Instant t, bool isIncluded) const {
  int first = 0, end = rowCount();
  while (first < end) {
    const int middle = first + (end - first) / 2;
    const Instant at = time(middle);
    if (at < t || (isIncluded && at == t)) {
      first = middle + 1;
    } else {
      end = middle;
    }
  }
  return first;
}

int EventFilter::rowAt(Instant cursor) const { return rowsUntil(cursor, true) - 1; }

int EventFilter::rowAfter(Instant cursor) const {
  const int row = rowsUntil(cursor, true);
  return row < rowCount() ? row : -1;
}

int EventFilter::rowBefore(Instant cursor) const { return rowsUntil(cursor, false) - 1; }

}  // namespace deckpipe
