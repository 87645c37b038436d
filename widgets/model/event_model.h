// SPDX-License-Identifier: GPL-3.0-or-later
// What happened in a log, as an item model in order of time: events found in its frames together with its
// notes. The window gives it each view; new rows come at the end, or in between where a person marked an
// earlier place. Looking through a long log is done in bounded pieces: while isLooking(), call look() again
// soon.
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "model/event_text.h"

namespace deckpipe {

class EventModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { When, Bus, What, ColumnCount };
  enum Role {
    TimeRole = Qt::UserRole,  // log time, qint64 ns
    WeightRole,               // EventWeight, as int
  };
  // A look at so many frames takes about two milliseconds.
  static constexpr std::uint64_t kFramesAtOnce = 100'000;

  explicit EventModel(QObject* parent = nullptr);

  void setView(const LogView& view);
  void look();
  bool isLooking() const { return m_isLooking; }
  // More happened than is listed.
  bool isCut() const { return m_events.isFull(); }
  // The last row that has happened at the cursor; -1 where none has.
  int rowAtCursor() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

 private:
  struct Row {
    Instant time;
    std::uint64_t frame = 0;
    bool isNote = false;
    std::size_t index = 0;  // in the events or the notes
    friend bool operator==(const Row&, const Row&) = default;
  };
  void merge();
  QString busText(const Row& row) const;
  QString whatText(const Row& row) const;
  EventWeight weight(const Row& row) const;

  LogView m_view;
  Events m_events;
  std::vector<Note> m_notes;
  std::vector<Row> m_rows;
  std::size_t m_merged = 0;  // events among the rows
  bool m_isLooking = false;
};

}  // namespace deckpipe
