// SPDX-License-Identifier: GPL-3.0-or-later
// The detail of one frame of a log as an item model: a row for each part of its identifier and each field,
// with value, raw bits and place. The decode panel gives it the frame that is selected in the trace and the
// log on each tick: what is learned of a node later never changes an earlier frame, but the index of roles
// may be built later than the frame is looked at.
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

#include "bus/frame.h"
#include "model/table_model.h"
#include "protocol/classify.h"
#include "protocol/field.h"
#include "state/log_view.h"

namespace deckpipe {

// The bits of a payload as a set: byte 1 in the lowest eight, its bit 8 the highest of them.
using BitSet64 = std::uint64_t;

// The range that a field takes in this frame: open-ended ones end with the data. Width 0 where a value is not
// read from bits (the size of a value).
BitRange rangeOf(const Field& field, const Frame& frame);

BitSet64 bitsOf(BitRange range);
// The status bits that give a field its sign.
BitSet64 signBitsOf(const Field& field);

// "B2.8–B3.5", "B6.8–7", "B2–B3", "B1.8–7, B2" (low byte first: the low bits' byte first).
QString placeText(BitRange range);
// Up to 16 bits in binary, by four; more in hex.
QString rawText(BitRange range, const Payload& data);

struct DecodeRow {
  enum class Line : std::uint8_t {
    Title,       // the message's name
    Certainty,   // a sentence: why it is not plain what this is
    Identifier,  // a part of the identifier
    Type,        // the byte that selects the message
    Field,
    Byte,  // not decoded
  };
  Line kind = Line::Field;
  QString name;
  QString value;
  QString raw;
  QString place;
  QString tip;
  BitSet64 bits = 0;      // of the payload
  BitSet64 signBits = 0;  // further bits that the value is read from
  bool isQuiet = false;   // off, or no value: drawn lighter

  friend bool operator==(const DecodeRow&, const DecodeRow&) = default;
};

// The detail of one frame as lines: how sure its reading is, its fields, its identifier taken apart, and as bytes
// whatever is no field. Where a field stands is said as the manuals count (bytes from 1, bits 8..1), and as a set of
// bits to be drawn.
std::vector<DecodeRow> decodeRows(const Frame& frame, const Classified& what);

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
