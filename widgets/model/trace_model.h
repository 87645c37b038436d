// SPDX-License-Identifier: GPL-3.0-or-later
// The trace as an item model: a window of rows over a log of any length. The view says which rows it shows
// (setWindow), the session's tick brings the log (setView, at most 30 times a second); rows of the model are
// rows of the window, so the view never asks about the millions around it.
//
// Without a filter each frame of the log is a row. With one, a worker finds the rows from the first frame on;
// isFiltering() is true until it is done, and the panel calls refresh() meanwhile.
//
//   1. Row r of the model is row windowFirst() + r of rows(); frameOf() and rowOf() convert between rows and
//      frames.
//   2. Rows are classified and put into words when the window or the log changes, never in data().
//   3. The number of rows changes at most once a call, however many frames came.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "model/table_model.h"
#include "model/trace_cells.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

class FilterWorker;

class TraceModel : public TableModel {
  Q_OBJECT

 public:
  enum Column {
    Time,
    Delta,
    ChannelName,
    Direction,
    Identifier,
    Pgn,
    Ends,
    Length,
    Data,
    Name,
    Decoded,
    ColumnCount,
  };
  enum Role {
    FrameRole = Qt::UserRole,  // place in the log, quint64
    MarksRole,                 // Marks, as unsigned
  };
  enum Mark : unsigned {
    AtCursor = 1,     // the last row that has happened
    AfterCursor = 2,  // has not happened yet
    TimeJump = 4,     // the clock jumped here
    Own = 8,          // sent by this console, or marked as sent in the log
    Error = 16,       // an error frame
    Remote = 32,      // a remote frame
    Malformed = 64,   // known, and of a wrong length
    Presumed = 128,   // decoded on a presumption
    Ambiguous = 256,  // several readings, none decided
    Added = 512,      // put there when the log was saved, not received there
  };
  Q_DECLARE_FLAGS(Marks, Mark)
  // How the Time column says time. A log whose stamps are no dates has no clock: there Clock says Stamp.
  enum class TimeMode : std::uint8_t { SinceBegin, Clock, Stamp, SinceRowBefore, Count };
  static QString modeText(TimeMode mode);

  explicit TraceModel(QObject* parent = nullptr);
  ~TraceModel() override;

  void setView(const LogView& view);
  const LogView& view() const { return m_view; }
  // Takes over rows that the filter has found since the last call.
  void refresh() { setView(m_view); }

  void setFilter(const TraceFilter& filter);
  bool isFiltered() const { return !m_filter.isEmpty(); }
  const TraceFilter& filter() const { return m_filter; }
  // Frames that the filter has looked at.
  std::uint64_t filteredFrames() const { return m_filteredFrames; }
  bool isFiltering() const { return m_filteredFrames < m_view.frameCount; }

  void setTimeMode(TimeMode mode);
  TimeMode timeMode() const { return m_timeMode; }

  // Rows there are, in the model or not.
  std::uint64_t rows() const { return m_count; }
  // How many rows stand before a frame; its own row where it has one.
  std::uint64_t rowOf(std::uint64_t frame) const;
  // The frame of a row; nullopt if there is no such row.
  std::optional<std::uint64_t> frameOf(std::uint64_t row) const;
  std::vector<std::uint64_t> framesOf(std::uint64_t firstRow, std::size_t count) const;

  // Moves the window. Rows that do not exist yet are added when their frames arrive.
  void setWindow(std::uint64_t first, int rows);
  std::uint64_t windowFirst() const { return m_first; }

  // What is out of the ordinary with a row, and a list of it in words.
  Marks marks(const TraceRow& row) const;
  static QString marksText(Marks marks);

 Q_SIGNALS:
  // After every setView(): the log, its length or its cursor may have changed.
  void viewChanged();
  // All rows have changed. A viewChanged() with their number follows.
  void filterChanged();

 private:
  std::size_t count() const override { return m_rows.size(); }
  QVariant cell(int row, int column, int role) const override;
  QString text(const TraceRow& row, int column) const;
  QString timeText(const TraceRow& row) const;
  QString toolTip(const TraceRow& row, int column) const;
  QString sentence(const TraceRow& row) const;
  std::vector<TraceRow> read(std::uint64_t first, std::uint64_t end);
  void take(std::uint64_t first, std::vector<TraceRow> rows);
  void sayMarksChanged(std::uint64_t passedBefore);
  void startFilter();
  std::uint64_t countRows();
  // Reads m_added anew; returns whether it has changed.
  bool readAdded();
  bool isAdded(std::uint64_t frame) const;
  std::uint64_t windowEnd() const;
  void countPassed();

  LogView m_view;
  TraceFilter m_filter;
  std::unique_ptr<FilterWorker> m_filterWorker;  // null where all frames are rows
  TimeMode m_timeMode = TimeMode::SinceBegin;
  std::uint64_t m_count = 0;  // of rows
  std::uint64_t m_filteredFrames = 0;
  std::uint64_t m_passed = 0;                 // rows at or before the cursor
  std::optional<std::uint64_t> m_lastPassed;  // the frame of the last of these rows
  std::size_t m_notes = 0;                    // of the log, when rows were last read
  // Frames [first, second) that were added, as the notes say; and notes of the log when that was read.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> m_added;
  std::size_t m_addedNotes = 0;
  std::uint64_t m_first = 0;
  int m_wanted = 0;
  std::vector<TraceRow> m_rows;
};
Q_DECLARE_OPERATORS_FOR_FLAGS(TraceModel::Marks)

}  // namespace deckpipe
