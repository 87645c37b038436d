// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_model.h"

#include <QStringList>
#include <algorithm>
#include <numeric>
#include <utility>

#include "bus/j1939.h"
#include "model/field_text.h"
#include "model/filter_worker.h"
#include "model/trace_cells.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

TableColumn timeColumn(TraceModel::TimeMode mode) {
  switch (mode) {
    case TraceModel::TimeMode::SinceBegin:
      return {TraceModel::tr("Since begin"), TraceModel::tr("Log time since the log's begin, in seconds"),
              true};
    case TraceModel::TimeMode::SinceRowBefore:
      return {TraceModel::tr("Since row"), TraceModel::tr("Log time since the row before, in seconds"), true};
    case TraceModel::TimeMode::Clock:
      return {TraceModel::tr("Local time"), TraceModel::tr("Local time of what the adapter or the log says"),
              true};
    case TraceModel::TimeMode::Stamp:
    case TraceModel::TimeMode::Count: break;
  }
  return {TraceModel::tr("Stamp"), TraceModel::tr("What the adapter or the log says, in seconds"), true};
}

}  // namespace

TraceModel::TraceModel(QObject* parent)
    : TableModel({timeColumn(TimeMode::SinceBegin),
                  {tr("Δ"), tr("Log time since the row before, in seconds"), true},
                  {tr("Channel")},
                  {tr("Dir"), tr("Rx received, Tx sent")},
                  {tr("ID")},
                  {tr("PGN"), tr("Parameter group of a 29-bit identifier, in hex")},
                  {tr("From→To"), tr("Source and destination address, or CANopen node, in hex")},
                  {tr("Len"), tr("Data bytes"), true},
                  {tr("Data")},
                  {tr("Name")},
                  {tr("Decoded")}},
                 parent) {}

TraceModel::~TraceModel() = default;

QString TraceModel::modeText(TimeMode mode) {
  switch (mode) {
    case TimeMode::SinceBegin: return tr("Time since the begin");
    case TimeMode::Clock: return tr("Local time");
    case TimeMode::Stamp: return tr("Stamp as in the log");
    case TimeMode::SinceRowBefore: return tr("Time since the row before");
    case TimeMode::Count: break;
  }
  return {};
}

void TraceModel::setView(const LogView& view) {
  const bool isSame = view.document == m_view.document;
  const std::uint64_t passedBefore = m_passed;
  m_view = view;
  if (!isSame) startFilter();
  if (m_filterWorker) m_filterWorker->wake();
  const bool isAddedNews = readAdded() && isSame;
  const std::uint64_t rows = countRows();
  if (!isSame || rows < m_count) {
    beginResetModel();
    m_count = rows;
    countPassed();
    m_first = std::min(m_first, rows);
    m_rows.clear();
    m_rows = read(m_first, windowEnd());
    endResetModel();
  } else {
    m_count = rows;
    countPassed();
    take(m_first, read(m_first, windowEnd()));
    if (passedBefore != m_passed) sayMarksChanged(passedBefore);
    if (isAddedNews) sayChanged(0, ColumnCount - 1);
  }
  Q_EMIT viewChanged();
}

void TraceModel::setFilter(const TraceFilter& filter) {
  beginResetModel();
  m_filter = filter;
  startFilter();
  m_rows.clear();
  m_first = m_count = m_passed = 0;
  m_lastPassed.reset();
  endResetModel();
  Q_EMIT filterChanged();
  refresh();
}

void TraceModel::startFilter() {
  m_filterWorker.reset();
  if (m_view.document && isFiltered())
    m_filterWorker = std::make_unique<FilterWorker>(m_view.document, m_filter);
}

// A sidecar's notes come once all frames are there.
bool TraceModel::readAdded() {
  const std::size_t notes = m_view.document ? m_view.document->notes.count() : 0;
  if (std::exchange(m_addedNotes, notes) == notes) return false;
  const auto before = std::exchange(m_added, {});
  if (notes > 0) {
    for (const Note& note : m_view.document->notes.all()) {
      if (const auto* added = std::get_if<note::Added>(&note.value))
        m_added.emplace_back(note.frame, note.frame + added->count);
    }
  }
  return m_added != before;
}

bool TraceModel::isAdded(std::uint64_t frame) const {
  return std::ranges::any_of(m_added,
                             [frame](const auto& run) { return frame >= run.first && frame < run.second; });
}

// How many rows there are, and how far the filter has looked: of one and the same moment.
std::uint64_t TraceModel::countRows() {
  m_filteredFrames = m_view.frameCount;
  if (!m_view.document) return 0;
  const std::uint64_t frames = std::min(m_view.frameCount, m_view.document->frames.count());
  if (!m_filterWorker) return frames;
  m_filteredFrames = std::min(frames, m_filterWorker->rows().scanned());
  return m_filterWorker->rows().rowOf(m_filteredFrames);
}

std::uint64_t TraceModel::rowOf(std::uint64_t frame) const {
  return std::min(m_count, m_filterWorker ? m_filterWorker->rows().rowOf(frame) : frame);
}

std::optional<std::uint64_t> TraceModel::frameOf(std::uint64_t row) const {
  const std::vector<std::uint64_t> frames = framesOf(row, 1);
  return frames.empty() ? std::nullopt : std::optional(frames.front());
}

std::vector<std::uint64_t> TraceModel::framesOf(std::uint64_t firstRow, std::size_t count) const {
  if (firstRow >= m_count) return {};
  count = static_cast<std::size_t>(std::min<std::uint64_t>(count, m_count - firstRow));
  if (m_filterWorker) return m_filterWorker->rows().frames(firstRow, count);
  std::vector<std::uint64_t> frames(count);
  std::iota(frames.begin(), frames.end(), firstRow);
  return frames;
}

void TraceModel::setTimeMode(TimeMode mode) {
  if (mode == m_timeMode) return;
  m_timeMode = mode;
  setColumn(Time, timeColumn(mode));
  sayChanged(Time, Time);
}

void TraceModel::countPassed() {
  m_passed = rowOf(m_view.cursor.frames);
  m_lastPassed = m_passed == 0 ? std::nullopt : frameOf(m_passed - 1);
}

std::uint64_t TraceModel::windowEnd() const {
  return std::min(m_count, m_first + static_cast<std::uint64_t>(m_wanted));
}

void TraceModel::setWindow(std::uint64_t first, int rows) {
  m_wanted = std::max(rows, 0);
  first = std::min(first, m_count);
  const std::uint64_t end = std::min(m_count, first + static_cast<std::uint64_t>(m_wanted));
  if (first == m_first && end - first == m_rows.size()) return;
  const bool overlaps = first < m_first + m_rows.size() && m_first < end;
  if (overlaps) {
    take(first, read(first, end));
  } else {
    beginResetModel();
    m_first = first;
    m_rows = read(first, end);
    endResetModel();
  }
}

std::vector<TraceRow> TraceModel::read(std::uint64_t first, std::uint64_t end) {
  if (!m_view.document || end <= first) return {};
  const LogDocument& log = *m_view.document;
  // A note in the past may say what frames behind it are.
  const std::size_t notes = log.notes.count();
  if (std::exchange(m_notes, notes) != notes) {
    for (TraceRow& row : m_rows) row.isSettled = false;
  }
  const bool hasBefore = first > 0;
  std::vector<std::uint64_t> frames =
      framesOf(hasBefore ? first - 1 : 0, static_cast<std::size_t>(end - first) + (hasBefore ? 1 : 0));
  std::optional<std::uint64_t> before;
  if (hasBefore && !frames.empty()) {
    before = frames.front();
    frames.erase(frames.begin());
  }
  return readTraceRows(log, frames, before, m_rows);
}

// Makes `rows`, which begin at `first` and share some with what is there, the rows of the model: what is no
// more in the window goes, what is new comes, and of the others those that differ are said to have changed.
void TraceModel::take(std::uint64_t first, std::vector<TraceRow> rows) {
  const std::uint64_t end = first + rows.size();
  const auto size = [this] { return static_cast<int>(m_rows.size()); };
  if (first > m_first) {
    const auto gone = static_cast<int>(std::min<std::uint64_t>(first - m_first, m_rows.size()));
    if (gone > 0) {
      beginRemoveRows({}, 0, gone - 1);
      m_rows.erase(m_rows.begin(), m_rows.begin() + gone);
      m_first = first;
      endRemoveRows();
    }
  }
  if (end < m_first + m_rows.size()) {
    const auto kept = static_cast<int>(end - m_first);
    beginRemoveRows({}, kept, size() - 1);
    m_rows.erase(m_rows.begin() + kept, m_rows.end());
    endRemoveRows();
  }
  if (first < m_first) {
    const auto come = static_cast<int>(m_first - first);
    beginInsertRows({}, 0, come - 1);
    m_rows.insert(m_rows.begin(), rows.begin(), rows.begin() + come);
    m_first = first;
    endInsertRows();
  }
  int firstChanged = size(), lastChanged = -1;
  for (int i = 0; i < size(); ++i) {
    TraceRow& old = m_rows[static_cast<std::size_t>(i)];
    const TraceRow& now = rows[static_cast<std::size_t>(i)];
    if (old.what == now.what) {
      old.isSettled = now.isSettled;
      continue;
    }
    firstChanged = std::min(firstChanged, i);
    lastChanged = i;
    old = now;
  }
  if (lastChanged >= 0) Q_EMIT dataChanged(index(firstChanged, 0), index(lastChanged, ColumnCount - 1));
  if (m_rows.size() < rows.size()) {
    beginInsertRows({}, size(), static_cast<int>(rows.size()) - 1);
    m_rows.insert(m_rows.end(), rows.begin() + size(), rows.end());
    endInsertRows();
  }
}

void TraceModel::sayMarksChanged(std::uint64_t passedBefore) {
  // The rows passed, and at their upper end the one that was, or now is, the last that has happened.
  const std::uint64_t low = std::min(passedBefore, m_passed), high = std::max(passedBefore, m_passed);
  const std::uint64_t first = std::max(m_first, low == 0 ? 0 : low - 1);
  const std::uint64_t end = std::min(m_first + m_rows.size(), high);
  if (first >= end) return;
  Q_EMIT dataChanged(index(static_cast<int>(first - m_first), 0),
                     index(static_cast<int>(end - m_first) - 1, ColumnCount - 1));
}

TraceModel::Marks TraceModel::marks(const TraceRow& row) const {
  Marks marks;
  marks.setFlag(AtCursor, row.index == m_lastPassed);
  marks.setFlag(AfterCursor, row.index >= m_view.cursor.frames);
  marks.setFlag(TimeJump, (row.frame.flags & Frame::kTimeJump) != 0);
  marks.setFlag(Own, (row.frame.flags & Frame::kSent) != 0);
  marks.setFlag(Added, isAdded(row.index));
  marks.setFlag(Error, row.frame.isError());
  marks.setFlag(Remote, row.frame.isRemote());
  marks.setFlag(Malformed, row.what.malformed);
  marks.setFlag(Presumed, row.what.family == Family::Presumed);
  marks.setFlag(Ambiguous, row.what.family == Family::Ambiguous);
  return marks;
}

QString TraceModel::marksText(Marks marks) {
  QStringList words;
  const auto say = [&](Mark mark, const QString& word) {
    if (marks.testFlag(mark)) words += word;
  };
  say(AtCursor, tr("at the cursor"));
  say(AfterCursor, tr("after the cursor"));
  say(TimeJump, tr("the clock jumps here"));
  say(Own, tr("sent"));
  say(Added, tr("added when the log was saved"));
  say(Error, tr("error frame"));
  say(Remote, tr("remote frame"));
  say(Malformed, tr("malformed"));
  say(Presumed, tr("presumed"));
  say(Ambiguous, tr("ambiguous"));
  return words.join(QStringLiteral(", "));
}

QString TraceModel::timeText(const TraceRow& row) const {
  switch (m_timeMode) {
    case TimeMode::Stamp:
    case TimeMode::Count: break;
    case TimeMode::SinceBegin:
      if (!m_view.hasTimes()) break;
      return sinceText(m_view.document->frames.timeAt(row.index) - m_view.begin);
    case TimeMode::SinceRowBefore: return deltaText(row.delta);
    case TimeMode::Clock:
      if (row.frame.hasStamp() && isDate(row.frame.stamp)) return clockText(row.frame.stamp);
      break;
  }
  return m_view.hasTimes() ? stampText(row.frame) : QString(QChar(0x2013));
}

QString TraceModel::text(const TraceRow& row, int column) const {
  switch (column) {
    case Time: return timeText(row);
    case Delta: return deltaText(row.delta);
    case ChannelName: return toQString(m_view.document->frames.channelName(row.frame.channel));
    case Direction: return isAdded(row.index) ? tr("+", "a frame that was added") : directionText(row.frame);
    case Identifier: return identifierText(row.frame);
    case Pgn: return pgnText(row.frame);
    case Ends: return endsText(row.frame);
    case Length: return QString::number(row.frame.length);
    case Data: return bytesText(row.frame);
    case Name: return row.title;
    case Decoded: return row.summary;
    default: return {};
  }
}

QString TraceModel::toolTip(const TraceRow& row, int column) const {
  switch (column) {
    case Delta: return (row.frame.flags & Frame::kTimeJump) != 0 ? tr("The clock jumps here.") : QString();
    case Direction:
      return isAdded(row.index) ? tr("Not received here: it was added when the log was saved, since it tells "
                                     "who held which address.")
                                : QString();
    case Pgn: {
      if (pgnText(row.frame).isEmpty()) return {};
      return tr("PGN %1").arg(J1939Id::of(row.frame.identifier()).pgn);
    }
    case Name:
    case Decoded: return detailText(row);
    default: return {};
  }
}

QString TraceModel::sentence(const TraceRow& row) const {
  QStringList parts{tr("frame %1").arg(row.index + 1)};
  if (const QString marked = marksText(marks(row)); !marked.isEmpty()) parts += marked;
  parts += tr("time %1").arg(timeText(row));
  parts += text(row, ChannelName);
  parts += tr("identifier %1").arg(identifierText(row.frame));
  if (!row.title.isEmpty()) parts += row.title;
  if (!row.summary.isEmpty()) {
    parts += row.summary;
  } else if (!row.what.isDecoded() && row.frame.length > 0) {
    parts += tr("data %1").arg(bytesText(row.frame));
  }
  return parts.join(QStringLiteral(", "));
}

QVariant TraceModel::cell(int at, int column, int role) const {
  const TraceRow& row = m_rows[static_cast<std::size_t>(at)];
  switch (role) {
    case Qt::DisplayRole: return text(row, column);
    case Qt::ToolTipRole: {
      const QString tip = toolTip(row, column);
      return tip.isEmpty() ? QVariant() : tip;
    }
    case Qt::WhatsThisRole: return detailText(row);
    case Qt::AccessibleTextRole: return column == 0 ? sentence(row) : text(row, column);
    case FrameRole: return QVariant::fromValue<quint64>(row.index);
    case MarksRole: return static_cast<unsigned>(marks(row).toInt());
    default: return {};
  }
}

}  // namespace deckpipe
