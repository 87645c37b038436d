// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/encode.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/part_state.h"
#include "bus/j1939.h"

namespace deckpipe {
namespace {

using Bits = Result<std::uint64_t, EncodeError>;

constexpr std::uint64_t kNoDeflection = 0x3FF;  // axis not fitted
constexpr std::uint64_t kNoAngle = 0xFFF;

Bits fail(EncodeError error) { return Failure{error}; }

std::optional<unsigned> status2Of(std::string_view word) {
  for (const Status2 status : kAllOf<Status2>) {
    if (word == kStatus2Keys[status]) return static_cast<unsigned>(status);
  }
  return {};
}

// The integer a scaled field holds: 47.3 may be given as integer 47, decimal 473/10, or with fewer decimals.
std::optional<std::int64_t> scaledTo(const Value& value, unsigned decimals) {
  if (value.type() != Value::Type::Integer && value.type() != Value::Type::Decimal) return {};
  if (value.decimals() > decimals) return {};
  std::int64_t n = value.number();
  for (unsigned i = value.decimals(); i < decimals; ++i) {
    if (__builtin_mul_overflow(n, 10, &n)) return {};
  }
  return n;
}

Bits unsignedBits(std::optional<std::int64_t> n, BitRange bits) {
  if (!n) return fail(EncodeError::WrongType);
  if (*n < 0 || static_cast<std::uint64_t>(*n) > bits.mask()) return fail(EncodeError::OutOfRange);
  return static_cast<std::uint64_t>(*n);
}

Bits signedBits(std::optional<std::int64_t> n, BitRange bits) {
  if (!n) return fail(EncodeError::WrongType);
  const std::int64_t limit = std::int64_t{1} << (bits.width - 1);
  if (*n < -limit || *n >= limit) return fail(EncodeError::OutOfRange);
  return static_cast<std::uint64_t>(*n) & bits.mask();
}

Bits wordBits(const Field& field, const Value& value) {
  if (value.type() == Value::Type::Integer) return unsignedBits(value.number(), field.bits);
  if (value.type() != Value::Type::Word) return fail(EncodeError::WrongType);
  for (const ValueName& name : field.words) {
    if (name.word == value.text()) return std::uint64_t{name.value};
  }
  return fail(EncodeError::NotInvertible);
}

Bits versionBits(const Value& value) {
  const std::string_view text = value.text();
  const std::size_t dot = text.find('.');
  unsigned major = 0, minor = 0;
  if (value.type() != Value::Type::Text || dot == std::string_view::npos) return fail(EncodeError::WrongType);
  const auto a = std::from_chars(text.data(), text.data() + dot, major);
  const auto b = std::from_chars(text.data() + dot + 1, text.data() + text.size(), minor);
  if (a.ec != std::errc() || b.ec != std::errc()) return fail(EncodeError::WrongType);
  if (major > 255 || minor > 255) return fail(EncodeError::OutOfRange);
  return std::uint64_t{major << 8 | minor};
}

Bits pinBits(const Value& value) {
  const auto pin = Pin::parse(value.text());
  if (!pin) return fail(EncodeError::WrongType);
  Payload data{};
  writeBits(data, akron::kPinType, pin->deviceType());
  writeBits(data, akron::kPinLetter5, static_cast<std::uint8_t>(pin->text()[4]));
  writeBits(data, akron::kPinLetter6, static_cast<std::uint8_t>(pin->text()[5]));
  writeBits(data, akron::kPinSerial, pin->serial());
  return readBits(data, fieldOf(akron::kAddressAnnouncementFields, "pin").bits);
}

Bits bitsOf(const Field& field, const Value& value) {
  const auto magnitude = [&](std::uint64_t none) -> Bits {
    if (value.isNull()) return none;
    const auto n = scaledTo(value, field.decimals);
    return unsignedBits(n ? std::optional(std::abs(*n)) : std::nullopt, field.bits);
  };
  switch (field.kind) {
    case Kind::AxisPercent: return magnitude(kNoDeflection);
    case Kind::Position: return magnitude(kNoAngle);
    default: break;
  }
  if (value.isNull()) return fail(EncodeError::NotInvertible);
  switch (field.kind) {
    case Kind::Number: return unsignedBits(scaledTo(value, field.decimals), field.bits);
    case Kind::Signed: return signedBits(scaledTo(value, field.decimals), field.bits);
    case Kind::Flag:
      if (value.type() != Value::Type::Flag) return fail(EncodeError::WrongType);
      return std::uint64_t{value.flag()};
    case Kind::Status2: {
      const auto status = status2Of(value.text());
      if (!status) return fail(EncodeError::WrongType);
      return std::uint64_t{*status};
    }
    case Kind::Word: return wordBits(field, value);
    case Kind::Version: return versionBits(value);
    case Kind::Float32:
      if (value.type() != Value::Type::Real) return fail(EncodeError::WrongType);
      return std::uint64_t{std::bit_cast<std::uint32_t>(static_cast<float>(value.real()))};
    case Kind::Pin: return pinBits(value);
    case Kind::FaultNames:
    case Kind::FaultNumbers:
      if (value.type() != Value::Type::Names && value.type() != Value::Type::Numbers)
        return fail(EncodeError::WrongType);
      return std::uint64_t{value.mask()};
    default: return fail(EncodeError::NotInvertible);
  }
}

std::optional<EncodeError> put(Encoded& out, const Field& field, const Value& value) {
  // Open-ended fields: their width follows from the length or the specifier.
  if (field.kind == Kind::Bytes) {
    if (value.type() != Value::Type::Bytes) return EncodeError::WrongType;
    const unsigned at = field.bits.offset / 8u;
    if (at + value.bytes().size() != out.length) return EncodeError::WrongLength;
    for (std::size_t i = 0; i < value.bytes().size(); ++i) out.data[at + i] = value.bytes()[i];
    return {};
  }
  BitRange bits = field.bits;
  if (field.kind == Kind::Tail || field.kind == Kind::SdoValue) {
    const unsigned width =
        field.kind == Kind::Tail ? 8u * out.length - bits.offset : 8u * sdo::valueSize(out.data[0]);
    bits = {ByteOrder::Little, bits.offset, static_cast<std::uint8_t>(width)};
    const Bits raw = unsignedBits(scaledTo(value, 0), bits);
    if (!raw) return raw.error();
    writeBits(out.data, bits, raw.value());
    return {};
  }
  // Two fields may share their bits (named and unnamed faults): each adds its own.
  const Bits raw = bitsOf(field, value);
  if (!raw) return raw.error();
  const bool shares = field.kind == Kind::FaultNames || field.kind == Kind::FaultNumbers;
  writeBits(out.data, bits, shares ? raw.value() | readBits(out.data, bits) : raw.value());
  return {};
}

// A value that only repeats what another field says.
bool isDerived(const Field& field) {
  return field.kind == Kind::TailSize || field.kind == Kind::SdoSize || field.kind == Kind::PositionState ||
         field.kind == Kind::AbortText || (field.view && field.kind != Kind::FaultNumbers) ||
         field.sdoObject != 0;
}

const Field* find(const Message& message, std::string_view key, unsigned length) {
  for (const Field& field : message.fields) {
    if (field.kind != Kind::Reserved && field.key == key &&
        (field.lengths == 0 || allows(field.lengths, length))) {
      return &field;
    }
  }
  return nullptr;
}

}  // namespace

Result<Encoded, EncodeError> encode(const Message& message, std::span<const FieldValue> values,
                                    unsigned length, std::uint8_t specifier) {
  if (length == 0) length = message.maxLength();
  if (!allows(message.lengths, length)) return Failure{EncodeError::WrongLength};
  Encoded out;
  out.length = static_cast<std::uint8_t>(length);
  if (message.firstByte >= 0) out.data[0] = static_cast<std::uint8_t>(message.firstByte);
  if (specifier != 0) out.data[0] = specifier;
  for (const FieldValue& given : values) {
    const Field* field = find(message, given.key, length);
    if (field == nullptr) return Failure{EncodeError::UnknownKey};
    if (isDerived(*field)) continue;
    const bool fits = field->bits.bytesNeeded() <= length || field->kind == Kind::SdoValue;
    if (!fits && given.value.isNull()) continue;
    if (!fits) return Failure{EncodeError::WrongLength};
    if (const auto error = put(out, *field, given.value)) return Failure{*error};
  }
  return out;
}

Frame j1939Frame(const Message& message, const Encoded& data, Address source, Address destination) {
  Frame frame;
  frame.id = J1939Id{message.priority, message.selector, source, destination}.frameId();
  frame.data = data.data;
  frame.length = data.length;
  return frame;
}

}  // namespace deckpipe
