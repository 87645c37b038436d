// SPDX-License-Identifier: GPL-3.0-or-later
// The events that a person wants to see: of one device, of a weight and above, of some groups, with words in
// them. Stands between an EventModel and the list.
#pragma once

#include <QSortFilterProxyModel>

#include "model/event_model.h"

namespace deckpipe {

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
