// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/bit_place.h"

#include <QStringList>
#include <algorithm>

#include "model/field_text.h"
#include "protocol/catalogue.h"
#include "protocol/sdo.h"

namespace deckpipe {
namespace {

constexpr QChar kTo(0x2013);  // en dash
constexpr unsigned kWidestBinary = 16;

QString byteName(unsigned byte) { return QStringLiteral("B%1").arg(byte); }

QString bitsWithin(unsigned byte, unsigned high, unsigned low) {
  if (high == 8 && low == 1) return byteName(byte);
  QString text = QStringLiteral("%1.%2").arg(byteName(byte)).arg(high);
  return high == low ? text : text + kTo + QString::number(low);
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

}  // namespace deckpipe
