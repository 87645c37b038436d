// SPDX-License-Identifier: GPL-3.0-or-later
// What one device answered up to the cursor, oldest first, in words, and what each answer changed against the
// one of its kind before. Read from the log, so live and of a file alike. The request panel asks for it on
// every tick; new rows are appended, another device or an earlier cursor starts anew.
#pragma once

#include <optional>
#include <vector>

#include "control/request.h"
#include "model/table_model.h"
#include "protocol/lists.h"
#include "state/log_view.h"

namespace deckpipe {

class AnswerHistory : public TableModel {
  Q_OBJECT

 public:
  enum Column { When, What, Answer, Changed, ColumnCount };
  enum Role { FrameRole = Qt::UserRole };  // place in the log, quint64
  // Older ones are left out, but for the last of each message: what was answered once stays answered.
  static constexpr std::size_t kMaxRows = 500;

  explicit AnswerHistory(QObject* parent = nullptr);

  void setView(const LogView& view, const DeviceKey& device);

  struct Row {
    std::uint64_t frame = 0;
    Instant time;
    Request request = Request::Fault;
    MessageId message = MessageId::Count;
    QString answer;
    QString changed;  // empty: nothing, or the first of its kind
    bool isFirst = true;
  };
  const std::vector<Row>& rows() const { return m_rows; }
  // The last row of a kind; null where none came.
  const Row* latest(Request request) const;
  // The last answer in words; of one that takes two messages both, a line each.
  QString latestText(Request request) const;

 private:
  std::size_t count() const override { return m_rows.size(); }
  QVariant cell(int row, int column, int role) const override;
  Row read(const Exchange& exchange);
  bool isLatest(const Row& row) const;
  // So many rows, but for the latest of each message; what could not be dropped is given back.
  std::size_t dropOldest(std::size_t surplus);

  LogView m_view;
  DeviceKey m_device;
  std::shared_ptr<const Exchanges::List> m_exchanges;
  std::size_t m_taken = 0;  // of them
  Cursor m_cursor;
  std::vector<Row> m_rows;
  EnumArray<MessageId, std::optional<std::uint64_t>> m_last;  // place in the log, by message
};

}  // namespace deckpipe
