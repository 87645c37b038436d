// SPDX-License-Identifier: GPL-3.0-or-later
// What happened in a log, as an item model in order of time: events (state/events.h) together with its notes.
// The window gives it each view; new rows come at the end, or in between where a person marked an earlier
// place. A question and its answer are one row, and so are answers that repeat themselves.
#pragma once

#include <QSortFilterProxyModel>
#include <memory>
#include <vector>

#include "model/event_text.h"
#include "model/table_model.h"

namespace deckpipe {

class EventModel : public TableModel {
  Q_OBJECT

 public:
  enum Column { When, Bus, Who, What, ColumnCount };
  enum Role {
    TimeRole = Qt::UserRole,  // log time, qint64 ns
    WeightRole,               // Severity, as int
    GroupRole,                // EventGroup, as int
  };

  explicit EventModel(QObject* parent = nullptr);

  void setView(const LogView& view);
  void setLabels(const DeviceLabels& labels);
  // More happened than is listed.
  bool isCut() const { return m_view.document != nullptr && m_view.document->events.isFull(); }
  const LogView& view() const { return m_view; }

  Severity weight(int row) const;
  EventGroup group(int row) const;
  Instant time(int row) const { return at(row).time; }
  // Since the begin of the log; a dash in one without times.
  QString whenText(int row) const;
  // Null where the whole bus is concerned.
  DeviceKey device(int row) const;
  QString deviceText(int row) const;
  QString text(int row) const;
  // Each device that an event or note concerns, in order of the first one.
  std::vector<DeviceKey> devices() const;
  QString nameOf(const DeviceKey& key) const { return deviceNameText(key, m_labels); }
  const DeviceLabels& labels() const { return m_labels; }

 private:
  std::size_t count() const override { return m_rows.size(); }
  QVariant cell(int row, int column, int role) const override;
  struct Row {
    Instant time;
    std::uint64_t frame = 0;
    bool isNote = false;
    std::size_t index = 0;    // in the events or the notes
    std::uint32_t times = 1;  // that a note repeats itself
    friend bool operator==(const Row&, const Row&) = default;
  };
  void merge();
  std::vector<Row> noteRows(const std::vector<Note>& notes) const;
  const Row& at(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
  QString busText(const Row& row) const;

  LogView m_view;
  DeviceLabels m_labels;
  std::vector<Event> m_events;
  unsigned m_generation = 0;  // of the log's events
  std::vector<Note> m_notes;
  std::vector<Row> m_rows;
};

// The events that a person wants to see: of one device, of a weight and above, of some groups, with words in
// them. Stands between an EventModel and the list.
class EventFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit EventFilter(EventModel* events, QObject* parent = nullptr);

  // Null: of all devices and of the bus.
  void setDevice(const DeviceKey& device) { set(m_device, device); }
  void setLeast(Severity weight) { set(m_least, weight); }
  // Without any group all are shown.
  void setGroups(const EnumSet<EventGroup>& groups) { set(m_groups, groups); }
  // In the name of the device or in what happened; upper and lower case are the same.
  void setText(const QString& text) { set(m_text, text.trimmed()); }

  // The last row that has happened at `cursor`; -1 where none has.
  int rowAt(Instant cursor) const;
  // The first row that happens after `cursor`, the last one before; -1 where there is none.
  int rowAfter(Instant cursor) const;
  int rowBefore(Instant cursor) const;
  Instant time(int row) const;

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  template <typename Value>
  void set(Value& held, const Value& value) {
    if (value == held) return;
    held = value;
    invalidateFilter();
  }
  // How many rows happen before `t`, or with it.
  int rowsUntil(Instant t, bool isIncluded) const;

  EventModel* m_events;
  DeviceKey m_device;
  Severity m_least = Severity::Plain;
  EnumSet<EventGroup> m_groups;
  QString m_text;
};

}  // namespace deckpipe
