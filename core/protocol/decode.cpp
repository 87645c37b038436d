// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/decode.h"

#include <bit>
#include <cmath>
#include <string>

namespace deckpipe {
namespace {

unsigned lengthOf(const Frame& frame) { return frame.length; }

Value wordOf(const Field& field, std::uint64_t raw) {
  for (const ValueName& name : field.words) {
    if (name.value == raw) return Value::word(name.word);
  }
  return field.otherwise.empty() ? Value::integer(static_cast<std::int64_t>(raw))
                                 : Value::word(field.otherwise);
}

Value abortText(const Field& field, std::uint64_t code) {
  for (const ValueName& name : field.words) {
    if (name.value == code) return Value::word(name.word);
  }
  return {};
}

std::uint32_t namedBits(const Field& field) {
  std::uint32_t mask = 0;
  for (const ValueName& name : field.words) mask |= 1u << name.value;
  return mask;
}

Value realOf(std::uint64_t raw) {
  const float value = std::bit_cast<float>(static_cast<std::uint32_t>(raw));
  return std::isfinite(value) ? Value::real(static_cast<double>(value)) : Value();
}

Value pinOf(const Frame& frame) {
  const auto part = [&](BitRange bits) { return static_cast<unsigned>(readBits(frame.data, bits)); };
  const auto pin = Pin::make(part(akron::kPinType), part(akron::kPinLetter5), part(akron::kPinLetter6),
                             part(akron::kPinSerial));
  return pin ? Value::pin(*pin) : Value();
}

// From the range's offset to the end of the data, low byte first.
Value tailOf(const Field& field, const Frame& frame) {
  const unsigned width = 8 * lengthOf(frame) - field.bits.offset;
  return Value::integer(static_cast<std::int64_t>(
      readBits(frame.data, {ByteOrder::Little, field.bits.offset, static_cast<std::uint8_t>(width)})));
}

bool hasItsBytes(const Field& field, const Frame& frame) {
  switch (field.kind) {
    case Kind::SdoValue:
    case Kind::SdoSize: return lengthOf(frame) >= 4 + sdo::valueSize(frame.data[0]);
    default: break;
  }
  // Of an SDO's value only as many bytes count as its specifier says.
  if (field.sdoObject != 0 && field.bits.bytesNeeded() != 4 + sdo::valueSize(frame.data[0])) return false;
  return field.bits.bytesNeeded() <= lengthOf(frame);
}

}  // namespace

bool isPresent(const Field& field, const Frame& frame) {
  if (field.kind == Kind::Reserved) return false;
  if (field.lengths != 0 && !allows(field.lengths, lengthOf(frame))) return false;
  if (field.sdoObject != 0) {
    const auto object =
        readBits(frame.data, gateway::kIndex.bits) << 8 | readBits(frame.data, gateway::kSubindex.bits);
    if (object != field.sdoObject) return false;
  }
  return field.missing == Missing::Null || hasItsBytes(field, frame);
}

Value valueOf(const Field& field, const Frame& frame) {
  if (!hasItsBytes(field, frame)) return {};
  const std::uint64_t raw = readBits(frame.data, field.bits);
  const auto plus = [&] { return static_cast<unsigned>(readBits(frame.data, field.plus)); };
  const auto minus = [&] { return static_cast<unsigned>(readBits(frame.data, field.minus)); };
  switch (field.kind) {
    case Kind::Number: return Value::decimal(static_cast<std::int64_t>(raw), field.decimals);
    case Kind::Signed: return Value::decimal(signExtend(raw, field.bits.width), field.decimals);
    case Kind::Flag: return Value::flag(raw != 0);
    case Kind::Status2: return Value::word(kStatus2Keys[static_cast<Status2>(raw)]);
    case Kind::Word: return wordOf(field, raw);
    case Kind::Version: return Value::version(static_cast<std::uint16_t>(raw));
    case Kind::Float32: return realOf(raw);
    case Kind::Bytes: return Value::bytes(frame.bytes().subspan(field.bits.offset / 8u));
    case Kind::Tail: return tailOf(field, frame);
    case Kind::TailSize: return Value::integer(lengthOf(frame) - field.bits.offset / 8u);
    case Kind::Reserved: return {};
    case Kind::AxisPercent: {
      const auto tenths = readAxis(static_cast<unsigned>(raw), plus(), minus());
      return tenths ? Value::decimal(*tenths, field.decimals) : Value();
    }
    case Kind::Position: {
      const PositionReading reading = readPosition(static_cast<unsigned>(raw), plus(), minus());
      return reading.state == PositionState::Ok ? Value::decimal(reading.tenths, field.decimals) : Value();
    }
    case Kind::PositionState:
      return Value::word(kPositionStateKeys[readPosition(static_cast<unsigned>(raw), plus(), minus()).state]);
    case Kind::Pin: return pinOf(frame);
    case Kind::FaultNames:
      return Value::names(static_cast<std::uint32_t>(raw) & namedBits(field), field.words);
    case Kind::FaultNumbers: return Value::numbers(static_cast<std::uint32_t>(raw) & ~namedBits(field));
    case Kind::SdoValue: {
      const unsigned width = 8 * sdo::valueSize(frame.data[0]);
      return Value::integer(static_cast<std::int64_t>(
          readBits(frame.data, {ByteOrder::Little, field.bits.offset, static_cast<std::uint8_t>(width)})));
    }
    case Kind::SdoSize: return Value::integer(sdo::valueSize(frame.data[0]));
    case Kind::AbortText: return abortText(field, raw);
  }
  return {};
}

}  // namespace deckpipe
