// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/answer_history.h"

#include <algorithm>
#include <iterator>

#include "model/field_text.h"
#include "model/message_text.h"
#include "protocol/decode.h"
#include "text/catalogue_text.h"
#include "text/service_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

Classified asAkron(MessageId message) { return {.family = Family::Akron, .message = message}; }

}  // namespace

AnswerHistory::AnswerHistory(QObject* parent)
    : TableModel({{tr("Time")}, {tr("Asked")}, {tr("Answer")}, {tr("Changed")}}, parent) {}

void AnswerHistory::setView(const LogView& view, const DeviceKey& device) {
  const auto exchanges = view.document != nullptr ? view.document->exchanges.list() : nullptr;
  const bool isOther = exchanges != m_exchanges || device != m_device;
  if (isOther || view.cursor.frames < m_cursor.frames) {
    beginResetModel();
    m_rows.clear();
    m_last = {};
    m_taken = 0;
    m_device = device;
    m_exchanges = exchanges;
    endResetModel();
  }
  m_view = view;
  m_cursor = view.cursor;
  if (m_exchanges == nullptr) return;
  std::vector<Row> fresh;
  for (; m_taken < m_exchanges->size() && (*m_exchanges)[m_taken].frame < m_cursor.frames; ++m_taken) {
    const Exchange& exchange = (*m_exchanges)[m_taken];
    if (exchange.device == m_device && exchange.isFromDevice && requestAnsweredBy(exchange.message))
      fresh.push_back(read(exchange));
  }
  if (fresh.empty()) return;
  const std::size_t all = m_rows.size() + fresh.size();
  std::size_t surplus = dropOldest(all - std::min(all, kMaxRows));
  std::erase_if(fresh, [&](const Row& row) {
    const bool goes = surplus > 0 && !isLatest(row);
    if (goes) --surplus;
    return goes;
  });
  beginInsertRows({}, static_cast<int>(m_rows.size()), static_cast<int>(m_rows.size() + fresh.size()) - 1);
  std::ranges::move(fresh, std::back_inserter(m_rows));
  endInsertRows();
}

bool AnswerHistory::isLatest(const Row& row) const { return m_last[row.message] == row.frame; }

std::size_t AnswerHistory::dropOldest(std::size_t surplus) {
  for (std::size_t i = 0; surplus > 0 && i < m_rows.size(); ++i) {
    const auto first = m_rows.begin() + static_cast<std::ptrdiff_t>(i);
    const auto most = first + static_cast<std::ptrdiff_t>(std::min(surplus, m_rows.size() - i));
    const auto last = std::find_if(first, most, [this](const Row& row) { return isLatest(row); });
    if (first == last) continue;
    surplus -= static_cast<std::size_t>(last - first);
    beginRemoveRows({}, static_cast<int>(i), static_cast<int>(last - m_rows.begin()) - 1);
    m_rows.erase(first, last);
    endRemoveRows();
  }
  return surplus;
}

AnswerHistory::Row AnswerHistory::read(const Exchange& exchange) {
  const Frame& frame = m_view.document->frames[exchange.frame];
  const Message& message = messageOf(exchange.message);
  Row row;
  row.frame = exchange.frame;
  row.time = exchange.time;
  row.request = *requestAnsweredBy(exchange.message);
  row.message = exchange.message;
  row.answer = summaryText(frame, asAkron(exchange.message));
  if (row.answer.isEmpty()) row.answer = messageName(message.id);
  std::optional<std::uint64_t>& last = m_last[exchange.message];
  row.isFirst = !last.has_value();
  if (last) {
    const Frame& before = m_view.document->frames[*last];
    QStringList changes;
    for (const Field& field : message.fields) {
      if (field.key.empty() || !isPresent(field, frame)) continue;
      const QString now = valueText(field, valueOf(field, frame));
      const QString then = isPresent(field, before) ? valueText(field, valueOf(field, before)) : QString();
      if (now != then)
        changes.append(tr("%1 was %2").arg(fieldName(field), then.isEmpty() ? tr("not sent") : then));
    }
    row.changed = changes.join(QStringLiteral(", "));
  }
  last = exchange.frame;
  return row;
}

const AnswerHistory::Row* AnswerHistory::latest(Request request) const {
  for (auto row = m_rows.rbegin(); row != m_rows.rend(); ++row) {
    if (row->request == request) return &*row;
  }
  return nullptr;
}

QString AnswerHistory::latestText(Request request) const {
  const Row* last = latest(request);
  if (last == nullptr) return {};
  for (auto row = m_rows.rbegin(); row != m_rows.rend(); ++row) {
    if (row->request == request && row->message != last->message)
      return row->answer + QLatin1Char('\n') + last->answer;
  }
  return last->answer;
}

QVariant AnswerHistory::cell(int at, int column, int role) const {
  const Row& row = m_rows[static_cast<std::size_t>(at)];
  if (role == FrameRole) return static_cast<qulonglong>(row.frame);
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  switch (column) {
    case When: return m_view.hasTimes() ? elapsedText(row.time - m_view.begin) : QString(QChar(0x2013));
    case What: return requestText(row.request);
    case Answer: return row.answer;
    case Changed:
      return row.isFirst ? tr("first answer") : row.changed.isEmpty() ? tr("unchanged") : row.changed;
    default: return {};
  }
}

}  // namespace deckpipe
