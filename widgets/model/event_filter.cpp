// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_filter.h"

namespace deckpipe {

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
