// SPDX-License-Identifier: GPL-3.0-or-later
// The trace as an item model: a window of rows over a log of any length. The view says which rows it shows
// (setWindow), the session's tick brings the log (setView, at most 30 times a second); rows of the model are
// rows of the window, so nothing is ever asked or told about the millions around it.
//
//   1. Row r of the model is frame windowFirst() + r of the log.
//   2. Rows are classified and put into words when the window or the log changes, never in data().
//   3. The number of rows changes at most once a call, however many frames came.
#pragma once

#include <QAbstractTableModel>
#include <cstdint>
#include <vector>

#include "model/trace_rows.h"
#include "state/log_view.h"

namespace deckpipe {

class TraceModel : public QAbstractTableModel {
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
    AtCursor = 1,     // the last frame that has happened
    AfterCursor = 2,  // has not happened yet
    TimeJump = 4,     // the clock jumped here
    Own = 8,          // sent by this console, or marked as sent in the log
    Error = 16,       // an error frame
    Remote = 32,      // a remote frame
    Malformed = 64,   // known, and of a wrong length
    Presumed = 128,   // decoded on a presumption
    Ambiguous = 256,  // several readings, none decided
  };
  Q_DECLARE_FLAGS(Marks, Mark)

  explicit TraceModel(QObject* parent = nullptr);

  void setView(const LogView& view);
  const LogView& view() const { return m_view; }
  // Rows of the log, not of the model.
  std::uint64_t logRows() const { return m_logRows; }

  // Moves the window; rows beyond the log's end come as the log grows.
  void setWindow(std::uint64_t first, int rows);
  std::uint64_t windowFirst() const { return m_first; }

  // What is out of the ordinary with a row, and a list of it in words.
  Marks marks(const TraceRow& row) const;
  static QString marksText(Marks marks);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

 Q_SIGNALS:
  // After every setView(): the log, its length or its cursor may be another.
  void viewChanged();

 private:
  QString text(const TraceRow& row, int column) const;
  QString toolTip(const TraceRow& row, int column) const;
  QString sentence(const TraceRow& row) const;
  std::vector<TraceRow> read(std::uint64_t first, std::uint64_t end) const;
  void take(std::uint64_t first, std::vector<TraceRow> rows);
  void sayMarksChanged(const Cursor& before);

  LogView m_view;
  std::uint64_t m_logRows = 0;
  std::uint64_t m_first = 0;
  int m_wanted = 0;
  std::vector<TraceRow> m_rows;
};
Q_DECLARE_OPERATORS_FOR_FLAGS(TraceModel::Marks)

}  // namespace deckpipe
