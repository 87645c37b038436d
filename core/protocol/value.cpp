// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/value.h"

#include <algorithm>
#include <charconv>
#include <tuple>

namespace deckpipe {

// Whoever makes a text says how long it can be: none is ever cut.
template <std::size_t kMaxLength>
Value Value::text(std::string_view characters) {
  static_assert(kMaxLength <= std::tuple_size_v<decltype(m_inline)>);
  Value v(Type::Text, 0);
  v.m_size = static_cast<std::uint8_t>(std::min(characters.size(), kMaxLength));
  std::copy_n(characters.begin(), v.m_size, v.m_inline.begin());
  return v;
}

Value Value::pin(const Pin& pin) { return text<Pin::kLength>(pin.text()); }

Value Value::version(std::uint16_t majorMinor) {
  constexpr std::size_t kLongest = std::string_view("255.255").size();
  return text<kLongest>(std::to_string(majorMinor >> 8) + '.' + std::to_string(majorMinor & 0xFF));
}

Value Value::bytes(std::span<const std::uint8_t> bytes) {
  Value v(Type::Bytes, 0);
  v.m_size = static_cast<std::uint8_t>(std::min(bytes.size(), v.m_inline.size()));
  std::copy_n(bytes.begin(), v.m_size, v.m_inline.begin());
  return v;
}

std::string_view Value::text() const {
  if (m_type == Type::Word) return m_word;
  return {reinterpret_cast<const char*>(m_inline.data()), m_size};
}

bool Value::operator==(const Value& other) const {
  if (m_type != other.m_type) return false;
  switch (m_type) {
    case Type::Null: return true;
    case Type::Real: return m_real == other.m_real;
    case Type::Word:
    case Type::Text: return text() == other.text();
    case Type::Bytes: return std::ranges::equal(bytes(), other.bytes());
    case Type::Decimal: return m_number == other.m_number && m_size == other.m_size;
    case Type::Integer:
    case Type::Flag:
    case Type::Names:
    case Type::Numbers: return m_number == other.m_number;
  }
  return false;
}

namespace {

void appendInteger(std::string& out, std::int64_t number) {
  char buffer[24];
  out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
}

void appendDecimal(std::string& out, std::int64_t number, unsigned decimals) {
  std::uint64_t magnitude =
      number < 0 ? 0 - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
  std::uint64_t scale = 1;
  for (unsigned i = 0; i < decimals; ++i) scale *= 10;
  std::uint64_t fraction = magnitude % scale;
  if (number < 0) out += '-';
  appendInteger(out, static_cast<std::int64_t>(magnitude / scale));
  if (fraction == 0) return;
  out += '.';
  for (scale /= 10; fraction != 0; scale /= 10) {
    out += static_cast<char>('0' + fraction / scale);
    fraction %= scale;
  }
}

}  // namespace

void appendText(std::string& out, const Value& value) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  const auto separate = [&out, begin = out.size()](const char* by) {
    if (out.size() != begin) out += by;
  };
  switch (value.type()) {
    case Value::Type::Null: break;
    case Value::Type::Integer: appendInteger(out, value.number()); break;
    case Value::Type::Decimal: appendDecimal(out, value.number(), value.decimals()); break;
    case Value::Type::Real: {
      char buffer[32];
      out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value.real()).ptr);
      break;
    }
    case Value::Type::Flag: out += value.flag() ? "on" : "off"; break;
    case Value::Type::Word:
    case Value::Type::Text: out += value.text(); break;
    case Value::Type::Bytes:
      for (const std::uint8_t byte : value.bytes()) {
        separate(" ");
        out += kHex[byte >> 4];
        out += kHex[byte & 15];
      }
      break;
    case Value::Type::Names:
      for (const ValueName& name : value.words()) {
        if ((value.mask() >> name.value & 1u) == 0) continue;
        separate(", ");
        out += name.word;
      }
      break;
    case Value::Type::Numbers:
      for (unsigned bit = 0; bit < 32; ++bit) {
        if ((value.mask() >> bit & 1u) == 0) continue;
        separate(", ");
        appendInteger(out, bit);
      }
      break;
  }
}

std::string toText(const Value& value) {
  std::string out;
  appendText(out, value);
  return out;
}

}  // namespace deckpipe
