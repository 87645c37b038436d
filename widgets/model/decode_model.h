// SPDX-License-Identifier: GPL-3.0-or-later
// The detail of one frame of a log as an item model: a row for each part of its identifier and each field,
// with value, raw bits and place. The decode panel gives it the frame that is selected in the trace and the
// log on each tick: what is learned of a node later never changes an earlier frame, but the index of roles
// may be built later than the frame is looked at.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/decode_rows.h"
#include "model/table_model.h"
#include "state/log_view.h"

namespace deckpipe {

class DecodeModel : public TableModel {
  Q_OBJECT

 public:
  enum Column { Name, Value, Raw, Place, ColumnCount };
  enum Role {
    KindRole = Qt::UserRole,  // DecodeRow::Line, as int
    BitsRole,                 // BitSet64, quint64
    SignBitsRole,             // BitSet64, quint64
    QuietRole,                // bool
  };

  explicit DecodeModel(QObject* parent = nullptr);

  void setView(const LogView& view);
  // Nothing: no frame is selected.
  void setFrame(std::optional<std::uint64_t> frame);

  std::optional<std::uint64_t> frame() const { return m_index; }
  // The bytes that the rows speak of; null where there is no such frame.
  const Frame* content() const { return m_content ? &*m_content : nullptr; }
  // The row that says most exactly what a bit of the payload means; -1 where none does.
  int rowOfBit(BitSet64 bit) const;

 Q_SIGNALS:
  // Another frame, or another reading of it. The rows have changed by then.
  void frameChanged();

 private:
  std::size_t count() const override { return m_rows.size(); }
  QVariant cell(int row, int column, int role) const override;
  void read();

  std::shared_ptr<const LogDocument> m_log;
  std::optional<std::uint64_t> m_index;
  std::optional<Frame> m_content;
  Classified m_what;
  std::vector<DecodeRow> m_rows;
};

}  // namespace deckpipe
