// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/id_model.h"

#include <QLocale>

#include <algorithm>
#include <iterator>
#include <utility>

#include "bus/j1939.h"
#include "log/time_grain.h"
#include "model/field_text.h"
#include "model/frame_test.h"
#include "model/message_text.h"
#include "model/trace_cells.h"
#include "protocol/catalogue.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

QString milliseconds(std::optional<Duration> duration) {
  if (!duration) return {};
  return IdModel::tr("%1 ms").arg(
      QLocale().toString(static_cast<double>(duration->count()) / 1e6, 'f', *duration < 10s ? 1 : 0));
}

TableColumn countColumn(bool isFiltered) {
  return {IdModel::tr("Count"),
          isFiltered ? IdModel::tr("Frames since the log's begin that pass the filter")
                     : IdModel::tr("Frames since the log's begin"),
          true};
}

}  // namespace

IdModel::IdModel(QObject* parent)
    : TableModel({{tr("Channel")},
                  {tr("ID")},
                  {tr("From→To")},
                  {tr("Name")},
                  countColumn(false),
                  {tr("Period"), tr("Mean time between frames, since the last long pause"), true},
                  {tr("Jitter"), tr("The worst that a period was beside the mean"), true},
                  {tr("Age"), tr("Time from the last frame to the cursor"), true},
                  {tr("Data"), tr("The last data; bytes that changed are bold and underlined")},
                  {tr("Decoded")}},
                 parent),
      m_table(std::make_shared<const IdTable>()) {}

IdModel::~IdModel() = default;

void IdModel::setFilter(const TraceFilter& filter) {
  beginResetModel();
  m_filter = filter;
  begin();
  endResetModel();
  setColumn(Count, countColumn(!m_filter.isEmpty()));
}

void IdModel::begin() {
  m_walker = m_view.document ? std::make_unique<IdTableWalker>(m_view.document, m_filter) : nullptr;
  m_table = std::make_shared<const IdTable>();
  m_words.clear();
}

void IdModel::setView(const LogView& view) {
  if (view.document != m_view.document) {
    beginResetModel();
    m_view = view;
    begin();
    endResetModel();
  }
  const bool isLater = view.cursor.time != m_view.cursor.time;
  m_view = view;
  if (!m_walker) return;
  m_walker->request(view.cursor.frames);
  const auto table = m_walker->latest();
  const std::size_t before = m_table->rows().size(), now = table->rows().size();
  if (now < before) {
    beginResetModel();
    m_table = table;
    m_words.resize(now);
    endResetModel();
    return;
  }
  const bool isNew = table != m_table;
  if (now > before) beginInsertRows({}, static_cast<int>(before), static_cast<int>(now) - 1);
  m_table = table;
  m_words.resize(now);
  if (now > before) endInsertRows();
  if (before > 0 && (isNew || isLater))
    Q_EMIT dataChanged(index(0, Count), index(static_cast<int>(before) - 1, Decoded));
}

const IdModel::Words& IdModel::words(int row) const {
  Words& words = m_words[static_cast<std::size_t>(row)];
  const std::uint64_t last = m_table->rows()[static_cast<std::size_t>(row)].lastFrame;
  if (words.isMade && words.frame == last) return words;
  const Frame& frame = m_view.document->frames[last];
  const Classified what = classifyAt(*m_view.document, last);
  TraceRow at;
  at.frame = frame;
  at.what = what;
  at.title = frameTitle(frame, what);
  at.summary = summaryText(frame, what);
  words = {last, true, at.title, at.summary, detailText(at)};
  return words;
}

unsigned IdModel::changedBytes(const IdRow& row) const {
  if (row.count < 2) return 0;
  const Frame& frame = m_view.document->frames[row.lastFrame];
  unsigned changed = 0;
  for (unsigned i = 0; i < frame.bytes().size(); ++i) {
    if (i >= row.lengthBefore || frame.data[i] != row.before[i]) changed |= 1u << i;
  }
  return changed;
}

QString IdModel::text(int at, int column) const {
  const IdRow& row = m_table->rows()[static_cast<std::size_t>(at)];
  const Frame& frame = m_view.document->frames[row.lastFrame];
  const auto tellsPeriods = [&] { return timeGrainOf(m_view.document->frames) == TimeGrain::Fine; };
  switch (column) {
    case ChannelName: return toQString(m_view.document->frames.channelName(frame.channel));
    case Identifier: return identifierText(frame);
    case Ends: return endsText(frame);
    case Name: return words(at).title;
    case Count: return QLocale().toString(static_cast<qulonglong>(row.count));
    case Period: return tellsPeriods() ? milliseconds(row.period()) : QString();
    case Jitter:
      return row.jitter() && tellsPeriods() ? QStringLiteral("±") + milliseconds(row.jitter()) : QString();
    case Age:
      return m_view.hasTimes() ? calmAge(std::max(m_view.cursor.time - row.last, Duration(0))) : QString();
    case Data: return bytesText(frame);
    case Decoded: return words(at).summary;
    default: return {};
  }
}

QString IdModel::sentence(int row) const {
  QStringList parts{text(row, ChannelName), tr("identifier %1").arg(text(row, Identifier))};
  if (const QString& title = words(row).title; !title.isEmpty()) parts += title;
  if (const QString& summary = words(row).summary; !summary.isEmpty()) parts += summary;
  return parts.join(QStringLiteral(", "));
}

QVariant IdModel::sortKey(int at, int column) const {
  const IdRow& row = m_table->rows()[static_cast<std::size_t>(at)];
  const auto ns = [](std::optional<Duration> d) {
    return QVariant::fromValue<qlonglong>(d ? d->count() : -1);
  };
  switch (column) {
    case Identifier: return QVariant::fromValue<qulonglong>(row.key & 0xFFFF'FFFF);
    case Count: return QVariant::fromValue<qulonglong>(row.count);
    case Period: return ns(row.period());
    case Jitter: return ns(row.jitter());
    case Age: return ns(m_view.cursor.time - row.last);
    default: return text(at, column);
  }
}

QVariant IdModel::cell(int at, int column, int role) const {
  const IdRow& row = m_table->rows()[static_cast<std::size_t>(at)];
  switch (role) {
    case Qt::DisplayRole: return text(at, column);
    case Qt::ToolTipRole:
      if (column == Name || column == Decoded) return words(at).detail;
      return {};
    case Qt::WhatsThisRole: return words(at).detail;
    case Qt::AccessibleTextRole:
      if (column == 0) return sentence(at);
      if (column == Data && changedBytes(row) != 0) {
        QStringList bytes;
        for (int i = 0; i < 8; ++i) {
          if ((changedBytes(row) >> i & 1u) != 0) bytes += QString::number(i + 1);
        }
        return tr("%1; changed: byte %2").arg(text(at, Data), bytes.join(QStringLiteral(", ")));
      }
      return text(at, column);
    case FrameRole: return QVariant::fromValue<quint64>(row.lastFrame);
    case SortRole: return sortKey(at, column);
    case ChangedRole: return changedBytes(row);
    case FilterRole: {
      const Frame& frame = m_view.document->frames[row.lastFrame];
      if (frame.isError()) return QStringLiteral("err");
      QString expression =
          QStringLiteral("ch=\"%1\" and id=%2").arg(text(at, ChannelName), identifierText(frame));
      if ((row.key >> 40) != 0) expression += QStringLiteral(" and type=") + hexText(row.key >> 40 & 0xFF, 2);
      return expression;
    }
    default: return {};
  }
}

// Channel, type byte of EF00 where there is one, identifier with its bits for extended, remote and error.
std::uint64_t IdTable::keyOf(const Frame& frame) {
  std::uint64_t key = frame.id | static_cast<std::uint64_t>(frame.channel) << 32;
  if (frame.isExtended() && !frame.isError() && !frame.isRemote() && frame.length > 0 &&
      J1939Id::of(frame.identifier()).pgn == pgn::kProprietaryA)
    key |= (std::uint64_t{0x100} | frame.data[0]) << 40;
  return key;
}

IdRow* IdTable::rowOf(std::uint64_t key) {
  constexpr std::size_t kSlots = 4 * kMax;
  if (m_slots.empty()) m_slots.resize(kSlots);
  std::size_t at = key * 0x9E37'79B9'7F4A'7C15 >> 51;
  static_assert(kSlots == std::size_t{1} << 13);
  for (;; at = (at + 1) % kSlots) {
    if (m_slots[at] == 0) break;
    IdRow& row = m_rows[m_slots[at] - 1u];
    if (row.key == key) return &row;
  }
  if (m_rows.size() == kMax) return nullptr;
  m_rows.push_back({.key = key});
  m_slots[at] = static_cast<std::uint16_t>(m_rows.size());
  return &m_rows.back();
}

void IdTable::walk(const FrameStore& frames, std::uint64_t end, FrameTest* test) {
  end = std::min(end, frames.count());
  LogTimes times(frames);
  for (; m_frames < end; ++m_frames) {
    const Frame& frame = frames[m_frames];
    const Instant now = times.at(m_frames);
    if (test != nullptr && !test->passes(m_frames, now)) continue;
    ++m_passed;
    IdRow* row = rowOf(keyOf(frame));
    if (row == nullptr) {
      ++m_others;
      continue;
    }
    if (row->count == 0) {
      row->begin = now;
    } else {
      const Frame& before = frames[row->lastFrame];
      row->before = before.data;
      row->lengthBefore = before.length;
      const Duration gap = now - row->last;
      const bool isPause = gap > 1s && row->periods > 0 && gap / kPause > *row->period();
      if (isPause) {
        row->begin = now;
        row->periods = 0;
        row->shortest = Duration::max();
        row->longest = Duration(0);
      } else {
        ++row->periods;
        row->shortest = std::min(row->shortest, gap);
        row->longest = std::max(row->longest, gap);
      }
    }
    ++row->count;
    row->last = now;
    row->lastFrame = m_frames;
  }
}

IdTableWalker::IdTableWalker(std::shared_ptr<const LogDocument> log, const TraceFilter& filter)
    : m_log(std::move(log)),
      m_filter(filter),
      m_now(begin()),
      m_worker([this](std::uint64_t wanted, const Worker::Turn& turn) { walk(wanted, turn); },
               std::make_shared<const IdTable>()) {}

void IdTableWalker::request(std::uint64_t frames) {
  const std::pair asked(frames, m_filter.needsRoles() ? m_log->notes.count() : 0);
  if (std::exchange(m_asked, asked) != asked || latest()->frames() != frames) m_worker.request(frames);
}

IdTableWalker::Stand IdTableWalker::begin() const {
  Stand stand;
  if (!m_filter.isEmpty()) stand.test.emplace(m_log, m_filter);
  return stand;
}

void IdTableWalker::goToNearest(std::uint64_t wanted) {
  const auto after = m_kept.upper_bound(wanted);
  const auto* kept = after == m_kept.begin() ? nullptr : std::prev(after)->second.get();
  if (m_now.table.frames() > wanted || (kept != nullptr && kept->table.frames() > m_now.table.frames()))
    m_now = kept != nullptr ? *kept : begin();
}

void IdTableWalker::walk(std::uint64_t wanted, const Worker::Turn& turn) {
  wanted = std::min(wanted, m_log->frames.count());
  if (m_filter.needsRoles() && isPastChanged(*m_log, m_notes, m_log->frames.count())) {
    m_kept.clear();
    m_now = begin();
  }
  goToNearest(wanted);
  if (m_now.test) m_now.test->bind();
  // A far way is left for a newer intent; what was walked of it is kept.
  while (m_now.table.frames() < wanted && !turn.isGivenUp()) {
    const std::uint64_t next = (m_now.table.frames() / kEvery + 1) * kEvery;
    m_now.table.walk(m_log->frames, std::min(wanted, next), m_now.test ? &*m_now.test : nullptr);
    if (m_now.table.frames() == next && !m_kept.contains(next))
      m_kept.emplace(next, std::make_shared<const Stand>(m_now));
  }
  if (m_now.table.frames() == wanted || m_now.table.frames() > latest()->frames())
    turn.handOver(std::make_shared<const IdTable>(m_now.table));
}

}  // namespace deckpipe
