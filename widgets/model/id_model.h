// SPDX-License-Identifier: GPL-3.0-or-later
// The traffic by identifier as an item model, as it stands at the cursor: a row for each channel and
// identifier, of PGN EF00 for each type byte as well. Fed on each tick while it is shown; the tables come
// from a worker (IdTable). Words are made for the rows that are looked at, once a frame.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/latest_request_worker.h"
#include "base/time.h"
#include "bus/frame.h"
#include "log/frame_store.h"
#include "model/frame_test.h"
#include "model/table_model.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

// The traffic of a log up to a cursor, by identifier: how often, how regular, what came last. A pure function
// of frames, so it is the same live, in replay and after seeking. Copyable: copies are kept every so many
// frames (IdTableWalker), so that the table at any cursor is a short walk away. With a filter it is the
// table of the frames that pass, as if there were no others.
//
//   1. A row is a channel and an identifier; of PGN EF00, which carries many messages, also its type byte.
//   2. Periods are those of the present run: a pause of more than kPause times the mean, and of more than a
//      second, begins a new run, so that a device that was off does not spoil them for good.
//   3. After kMax rows further identifiers are only counted.
class FrameTest;

struct IdRow {
  std::uint64_t key = 0;
  std::uint64_t count = 0;      // since the log's begin
  std::uint64_t lastFrame = 0;  // in the log
  Instant last{};               // log time
  Payload before{};             // the data of the frame before the last …
  std::uint8_t lengthBefore = 0;
  // Of the present run.
  std::uint32_t periods = 0;
  Instant begin{};
  Duration shortest{Duration::max()}, longest{0};

  std::optional<Duration> period() const {
    if (periods == 0) return {};
    return (last - begin) / static_cast<std::int64_t>(periods);
  }
  // The worst that a period was beside the mean.
  std::optional<Duration> jitter() const {
    if (periods < 2) return {};
    return std::max(longest - *period(), *period() - shortest);
  }
  friend bool operator==(const IdRow&, const IdRow&) = default;
};

class IdTable {
 public:
  static constexpr std::size_t kMax = 2048;
  static constexpr int kPause = 10;

  // The frames of the log that are behind what the table has seen, up to `end`; with a test those that pass.
  void walk(const FrameStore& frames, std::uint64_t end, FrameTest* test = nullptr);

  std::uint64_t frames() const { return m_frames; }          // that were looked at
  std::uint64_t passed() const { return m_passed; }          // of them
  const std::vector<IdRow>& rows() const { return m_rows; }  // in the order in which they came first
  std::uint64_t others() const { return m_others; }          // frames that have no row

  static std::uint64_t keyOf(const Frame& frame);

 private:
  IdRow* rowOf(std::uint64_t key);

  std::vector<IdRow> m_rows;
  std::vector<std::uint16_t> m_slots;  // open addressing: 0 free, otherwise row + 1
  std::uint64_t m_frames = 0;
  std::uint64_t m_passed = 0;
  std::uint64_t m_others = 0;
};

// Finds the table of identifiers at a cursor on a thread of its own. It keeps a copy of the table every
// kEvery frames it passes, so that a cursor that goes back, or jumps, costs the walk from the copy before it:
// a few milliseconds, wherever in a log. The model asks on its tick and takes what is there.
class IdTableWalker {
 public:
  static constexpr std::uint64_t kEvery = 131'072;

  explicit IdTableWalker(std::shared_ptr<const LogDocument> log, const TraceFilter& filter = {});

  // The table behind so many frames is wanted; the newest intent wins.
  void request(std::uint64_t frames);
  // The last table that was reached; never null.
  std::shared_ptr<const IdTable> latest() const { return m_worker.latest(); }

 private:
  // A table and the test that stands behind the same frame.
  struct Stand {
    IdTable table;
    std::optional<FrameTest> test;
  };
  using Worker = LatestRequestWorker<std::uint64_t, IdTable>;
  Stand begin() const;
  // Where the walk to `wanted` frames is shortest: where the table stands, or the nearest copy.
  void goToNearest(std::uint64_t wanted);
  void walk(std::uint64_t wanted, const Worker::Turn& turn);

  const std::shared_ptr<const LogDocument> m_log;
  const TraceFilter m_filter;
  std::pair<std::uint64_t, std::size_t> m_asked;  // frames, and notes where the filter needs them
  // The worker's own:
  Stand m_now;
  std::size_t m_notes = 0;  // of the log, that m_now knows
  std::map<std::uint64_t, std::shared_ptr<const Stand>> m_kept;
  Worker m_worker;  // last: it uses all of the above
};

class IdTableWalker;

class IdModel : public TableModel {
  Q_OBJECT

 public:
  enum Column { ChannelName, Identifier, Ends, Name, Count, Period, Jitter, Age, Data, Decoded, ColumnCount };
  enum Role {
    FrameRole = Qt::UserRole,  // the last frame, quint64
    SortRole,                  // what the column is sorted by
    ChangedRole,               // bytes that differ from the frame before: bit 0 is byte 1, unsigned
    FilterRole,                // an expression for these frames
  };

  explicit IdModel(QObject* parent = nullptr);
  ~IdModel() override;

  void setView(const LogView& view);
  // Rows and counts are of the frames that pass.
  void setFilter(const TraceFilter& filter);
  // The table is that of an earlier cursor, or not there yet.
  bool isBehind() const { return m_table->frames() != m_view.cursor.frames; }
  std::uint64_t otherFrames() const { return m_table->others(); }
  // Frames that were looked at, and how many of them passed.
  std::uint64_t lookedAt() const { return m_table->frames(); }
  std::uint64_t passed() const { return m_table->passed(); }

 private:
  std::size_t count() const override { return m_table->rows().size(); }
  QVariant cell(int row, int column, int role) const override;
  struct Words {
    std::uint64_t frame = 0;
    bool isMade = false;
    QString title, summary, detail;
  };
  void begin();
  const Words& words(int row) const;
  QString text(int row, int column) const;
  QString sentence(int row) const;
  QVariant sortKey(int row, int column) const;
  unsigned changedBytes(const IdRow& row) const;

  LogView m_view;
  TraceFilter m_filter;
  std::shared_ptr<const IdTable> m_table;
  std::unique_ptr<IdTableWalker> m_walker;
  mutable std::vector<Words> m_words;  // by row
};

}  // namespace deckpipe
