// SPDX-License-Identifier: GPL-3.0-or-later
// The traffic by identifier as an item model, as it stands at the cursor: a row for each channel and
// identifier, of PGN EF00 for each type byte as well. Fed on each tick while it is shown; the tables come
// from a worker (id_table.h). Words are made for the rows that are looked at, once a frame.
#pragma once

#include <memory>
#include <vector>

#include "model/id_table.h"
#include "model/table_model.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

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
