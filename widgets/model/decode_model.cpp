// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/decode_model.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <bit>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "model/field_text.h"
#include "model/message_text.h"
#include "model/trace_cells.h"
#include "protocol/catalogue.h"
#include "protocol/decode.h"
#include "protocol/sdo.h"
#include "text/catalogue_text.h"

namespace deckpipe {

DecodeModel::DecodeModel(QObject* parent)
    : TableModel(
          {{tr("Field")},
           {tr("Value")},
           {tr("Raw")},
           {tr("Where"), tr("Byte and bit as the manuals count: bytes from 1, bits 8 to 1; ID: bits of the "
                            "identifier")}},
          parent) {}

void DecodeModel::setView(const LogView& view) {
  if (m_log != view.document) {
    m_log = view.document;
    m_index.reset();
  }
  read();
}

void DecodeModel::setFrame(std::optional<std::uint64_t> frame) {
  m_index = frame;
  read();
}

void DecodeModel::read() {
  std::optional<Frame> content;
  Classified what;
  if (m_log && m_index && *m_index < m_log->frames.count()) {
    content = m_log->frames[*m_index];
    what = classifyAt(*m_log, *m_index);
  }
  if (content == m_content && what == m_what) return;
  std::vector<DecodeRow> rows;
  if (content) rows = decodeRows(*content, what);
  // Stepping through frames of one message keeps the rows, and with them the field that a person looks at.
  const bool sameRows =
      std::equal(rows.begin(), rows.end(), m_rows.begin(), m_rows.end(),
                 [](const DecodeRow& a, const DecodeRow& b) { return a.kind == b.kind && a.name == b.name; });
  m_content = content;
  m_what = what;
  if (sameRows) {
    m_rows = std::move(rows);
    sayChanged(Name, Place);
  } else {
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
  }
  Q_EMIT frameChanged();
}

int DecodeModel::rowOfBit(BitSet64 bit) const {
  int best = -1, bestWidth = 65;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const int width = std::popcount(m_rows[i].bits);
    if ((m_rows[i].bits & bit) == 0 || width >= bestWidth) continue;
    best = static_cast<int>(i);
    bestWidth = width;
  }
  return best;
}

QVariant DecodeModel::cell(int at, int column, int role) const {
  const DecodeRow& row = m_rows[static_cast<std::size_t>(at)];
  switch (role) {
    case Qt::DisplayRole:
      switch (column) {
        case Name: return row.name;
        case Value: return row.value;
        case Raw: return row.raw;
        case Place: return row.place;
        default: return {};
      }
    case Qt::ToolTipRole: return row.tip.isEmpty() ? QVariant() : row.tip;
    case Qt::AccessibleTextRole: return column == Name ? tr("%1: %2").arg(row.name, row.value) : QVariant();
    case KindRole: return static_cast<int>(row.kind);
    case BitsRole: return QVariant::fromValue<quint64>(row.bits);
    case SignBitsRole: return QVariant::fromValue<quint64>(row.signBits);
    case QuietRole: return row.isQuiet;
    default: return {};
  }
}

namespace {

constexpr QChar kTo(0x2013);  // en dash
constexpr unsigned kWidestBinary = 16;

QString byteName(unsigned byte) { return QStringLiteral("B%1").arg(byte); }

QString bitsWithin(unsigned byte, unsigned high, unsigned low) {
  if (high == 8 && low == 1) return byteName(byte);
  QString text = QStringLiteral("%1.%2").arg(byteName(byte)).arg(high);
  return high == low ? text : text + kTo + QString::number(low);
}

struct DecodeRows {
  Q_DECLARE_TR_FUNCTIONS(DecodeRows)
};
using Line = DecodeRow::Line;

// "80 hex (128)": how manuals write an address, and how other tools do.
QString hexAndDecimal(std::uint32_t number, int digits) {
  return DecodeRows::tr("%1 hex (%2)").arg(hexText(number, digits)).arg(number);
}

QString addressFieldText(Address address) {
  const QString text = hexAndDecimal(address.value, 2);
  if (address == kGlobalAddress) return DecodeRows::tr("%1, all").arg(text);
  if (address == kNullAddress) return DecodeRows::tr("%1, none: cannot claim").arg(text);
  return text;
}

QString functionText(std::uint16_t function) {
  switch (static_cast<CobFunction>(function)) {
    case CobFunction::Nmt: return DecodeRows::tr("network management");
    case CobFunction::Emergency: return DecodeRows::tr("emergency or SYNC");
    case CobFunction::Tpdo1: return QStringLiteral("TPDO1");
    case CobFunction::Rpdo1: return QStringLiteral("RPDO1");
    case CobFunction::Tpdo2: return QStringLiteral("TPDO2");
    case CobFunction::SdoResponse: return DecodeRows::tr("SDO, from the node");
    case CobFunction::SdoRequest: return DecodeRows::tr("SDO, to the node");
    case CobFunction::Heartbeat: return DecodeRows::tr("heartbeat, node guarding");
  }
  return {};
}

DecodeRow identifierRow(const QString& name, const QString& value, const QString& place = {}) {
  DecodeRow row;
  row.kind = Line::Identifier;
  row.name = name;
  row.value = value;
  row.place = place;
  return row;
}

void addIdentifier(std::vector<DecodeRow>& rows, const Frame& frame) {
  const std::uint32_t identifier = frame.identifier();
  if (frame.isError()) {
    rows.push_back(identifierRow(DecodeRows::tr("Error classes"), errorText(frame)));
    return;
  }
  if (frame.isExtended()) {
    const J1939Id id = J1939Id::of(identifier);
    rows.push_back(identifierRow(DecodeRows::tr("Identifier"),
                                 DecodeRows::tr("%1, 29 bits").arg(identifierText(frame))));
    rows.push_back(
        identifierRow(DecodeRows::tr("Priority"), QString::number(id.priority), DecodeRows::tr("ID 28–26")));
    rows.push_back(
        identifierRow(DecodeRows::tr("PGN"), hexAndDecimal(id.pgn, 4),
                      id.hasDestination() ? DecodeRows::tr("ID 25–16") : DecodeRows::tr("ID 25–8")));
    if (id.hasDestination())
      rows.push_back(identifierRow(DecodeRows::tr("Destination"), addressFieldText(id.destination),
                                   DecodeRows::tr("ID 15–8")));
    if (!id.hasDestination())
      rows.push_back(identifierRow(DecodeRows::tr("Destination"), DecodeRows::tr("all, by its PGN")));
    rows.push_back(
        identifierRow(DecodeRows::tr("Source"), addressFieldText(id.source), DecodeRows::tr("ID 7–0")));
    return;
  }
  const CobId cob = CobId::of(identifier);
  rows.push_back(
      identifierRow(DecodeRows::tr("Identifier"), DecodeRows::tr("%1, 11 bits").arg(identifierText(frame))));
  const QString function = functionText(cob.function);
  rows.push_back(identifierRow(DecodeRows::tr("Function"),
                               function.isEmpty()
                                   ? hexText(cob.function, 3)
                                   : QStringLiteral("%1 (%2)").arg(hexText(cob.function, 3), function),
                               DecodeRows::tr("ID 10–7")));
  if (cob.hasNode())
    rows.push_back(
        identifierRow(DecodeRows::tr("Node"), hexAndDecimal(cob.node.value, 2), DecodeRows::tr("ID 6–0")));
}

void addByte(std::vector<DecodeRow>& rows, const Frame& frame, unsigned byte) {
  const BitRange range = big(byte, 8, 8);
  DecodeRow row;
  row.kind = Line::Byte;
  row.name = DecodeRows::tr("Byte %1").arg(byte);
  row.value = DecodeRows::tr("%1 hex (%2)").arg(hexText(frame.data[byte - 1], 2)).arg(frame.data[byte - 1]);
  row.raw = rawText(range, frame.data);
  row.place = placeText(range);
  row.bits = bitsOf(range);
  rows.push_back(row);
}

void addType(std::vector<DecodeRow>& rows, const Frame& frame, const Message& message) {
  const BitRange range = big(1, 8, 8);
  DecodeRow row;
  row.kind = Line::Type;
  row.name = message.family == Family::Copley    ? DecodeRows::tr("Command")
             : message.family == Family::Canopen ? DecodeRows::tr("Command specifier")
                                                 : DecodeRows::tr("Message type");
  row.value = DecodeRows::tr("%1 hex").arg(hexText(frame.data[0], 2));
  row.raw = rawText(range, frame.data);
  row.place = placeText(range);
  row.tip = toQString(message.source);
  row.bits = bitsOf(range);
  rows.push_back(row);
}

bool isQuiet(const Value& value) {
  switch (value.type()) {
    case Value::Type::Null: return true;
    case Value::Type::Flag: return !value.flag();
    case Value::Type::Word: return value.text() == "off" || value.text() == "na";
    case Value::Type::Names:
    case Value::Type::Numbers: return value.mask() == 0;
    default: return false;
  }
}

void addField(std::vector<DecodeRow>& rows, const Frame& frame, const Message& message, const Field& field) {
  const Value value = valueOf(field, frame);
  const BitRange range = rangeOf(field, frame);
  DecodeRow row;
  row.kind = Line::Field;
  row.name = fieldName(field);
  row.value = valueText(field, value);
  row.raw = field.kind == Kind::Bytes ? toQString(toText(value)) : rawText(range, frame.data);
  row.place = placeText(range);
  row.tip = toQString(message.source);
  row.bits = bitsOf(range);
  row.signBits = signBitsOf(field);
  row.isQuiet = isQuiet(value);
  rows.push_back(row);
}

}  // namespace

BitRange rangeOf(const Field& field, const Frame& frame) {
  BitRange range = field.bits;
  const auto endsAt = [&range](unsigned bit) {
    range.width = static_cast<std::uint8_t>(bit > range.offset ? bit - range.offset : 0u);
  };
  switch (field.kind) {
    case Kind::TailSize:
    case Kind::SdoSize: range.width = 0; break;
    case Kind::Bytes:
    case Kind::Tail: endsAt(8u * frame.length); break;
    case Kind::SdoValue: endsAt(range.offset + 8u * sdo::valueSize(frame.data[0])); break;
    default: break;
  }
  return range;
}

BitSet64 bitsOf(BitRange range) { return range.width == 0 ? 0 : checks::bitSet(range); }

BitSet64 signBitsOf(const Field& field) { return bitsOf(field.plus) | bitsOf(field.minus); }

QString placeText(BitRange range) {
  if (range.width == 0) return {};
  const unsigned first = range.offset, last = first + range.width - 1u;
  const unsigned firstByte = first / 8 + 1, lastByte = last / 8 + 1;
  if (first % 8 == 0 && range.width % 8 == 0)
    return firstByte == lastByte ? byteName(firstByte) : byteName(firstByte) + kTo + byteName(lastByte);
  if (range.order == ByteOrder::Big) {
    const unsigned high = 8 - first % 8, low = 8 - last % 8;
    if (firstByte == lastByte) return bitsWithin(firstByte, high, low);
    return QStringLiteral("%1.%2%3%4.%5")
        .arg(byteName(firstByte))
        .arg(high)
        .arg(kTo)
        .arg(byteName(lastByte))
        .arg(low);
  }
  QStringList parts;
  for (unsigned byte = firstByte; byte <= lastByte; ++byte) {
    const unsigned low = byte == firstByte ? first % 8 + 1 : 1;
    const unsigned high = byte == lastByte ? last % 8 + 1 : 8;
    parts += bitsWithin(byte, high, low);
  }
  return parts.join(QStringLiteral(", "));
}

QString rawText(BitRange range, const Payload& data) {
  if (range.width == 0) return {};
  const std::uint64_t raw = readBits(data, range);
  if (range.width > kWidestBinary) return hexText(raw, (range.width + 3) / 4);
  QString text = QString::number(raw, 2).rightJustified(range.width, QLatin1Char('0'));
  for (qsizetype at = text.size() - 4; at > 0; at -= 4) text.insert(at, QLatin1Char(' '));
  return text;
}

std::vector<DecodeRow> decodeRows(const Frame& frame, const Classified& what) {
  std::vector<DecodeRow> rows;
  const Message* message = what.message == MessageId::Count ? nullptr : &messageOf(what.message);
  DecodeRow title;
  title.kind = Line::Title;
  title.name = DecodeRows::tr("Message");
  title.value = frameTitle(frame, what);
  if (title.value.isEmpty()) title.value = DecodeRows::tr("unknown");
  if (message != nullptr) title.tip = toQString(message->source);
  rows.push_back(title);
  if (const QString sentence = certaintyText(frame, what); !sentence.isEmpty()) {
    DecodeRow certainty;
    certainty.kind = Line::Certainty;
    certainty.name = DecodeRows::tr("Note");
    certainty.value = sentence;
    certainty.tip = sentence;
    rows.push_back(certainty);
  }
  if (message != nullptr && what.isDecoded()) {
    for (const Field& field : message->fields) {
      if (isPresent(field, frame)) addField(rows, frame, *message, field);
    }
    if (message->firstByte >= 0) addType(rows, frame, *message);
    addIdentifier(rows, frame);
  } else {
    addIdentifier(rows, frame);
    for (unsigned byte = 1; byte <= frame.bytes().size(); ++byte) addByte(rows, frame, byte);
  }
  return rows;
}

}  // namespace deckpipe
