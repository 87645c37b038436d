// SPDX-License-Identifier: GPL-3.0-or-later
// A decoded value: what a field of a message says, free of bits. Exact: numbers with a resolution stay
// integers with a count of decimals.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/ids.h"
#include "protocol/field.h"

namespace deckpipe {

class Value {
 public:
  enum class Type : std::uint8_t {
    Null,     // not available, not valid, or not in the frame
    Integer,  // number()
    Decimal,  // number() / 10^decimals()
    Real,     // real()
    Flag,     // flag()
    Word,     // text(): a key
    Text,     // text(): a PIN or a version
    Bytes,    // bytes()
    Names,    // the words() whose bit is set in mask()
    Numbers,  // the numbers of the bits set in mask()
  };

  constexpr Value() = default;
  static constexpr Value integer(std::int64_t n) { return Value(Type::Integer, n); }
  static constexpr Value decimal(std::int64_t n, std::uint8_t decimals) {
    Value v(decimals == 0 ? Type::Integer : Type::Decimal, n);
    v.m_size = decimals;
    return v;
  }
  static constexpr Value real(double d) {
    Value v(Type::Real, 0);
    v.m_real = d;
    return v;
  }
  static constexpr Value flag(bool on) { return Value(Type::Flag, on ? 1 : 0); }
  static constexpr Value word(std::string_view key) {
    Value v(Type::Word, 0);
    v.m_word = key;
    return v;
  }
  static Value pin(const Pin& pin);                // text
  static Value version(std::uint16_t majorMinor);  // text: "2.6" of 0206 hex
  static Value bytes(std::span<const std::uint8_t> bytes);
  static constexpr Value names(std::uint32_t mask, std::span<const ValueName> words) {
    Value v(Type::Names, mask);
    v.m_words = words;
    return v;
  }
  static constexpr Value numbers(std::uint32_t mask) { return Value(Type::Numbers, mask); }

  constexpr Type type() const { return m_type; }
  constexpr bool isNull() const { return m_type == Type::Null; }
  constexpr std::int64_t number() const { return m_number; }
  constexpr std::uint8_t decimals() const { return m_type == Type::Decimal ? m_size : std::uint8_t{0}; }
  constexpr double real() const { return m_real; }
  constexpr bool flag() const { return m_number != 0; }
  constexpr std::uint32_t mask() const { return static_cast<std::uint32_t>(m_number); }
  constexpr std::span<const ValueName> words() const { return m_words; }
  std::string_view text() const;
  std::span<const std::uint8_t> bytes() const { return {m_inline.data(), m_size}; }

  bool operator==(const Value& other) const;

 private:
  constexpr Value(Type type, std::int64_t number) : m_type(type), m_number(number) {}
  template <std::size_t kMaxLength>
  static Value text(std::string_view characters);

  Type m_type = Type::Null;
  std::uint8_t m_size = 0;
  std::int64_t m_number = 0;
  double m_real = 0;
  std::string_view m_word;
  std::span<const ValueName> m_words;
  std::array<std::uint8_t, 16> m_inline{};
};

// The value as a person reads it in a list: "47.3", "on", "PIN", "41 3F", "internal_fuse, 12", "" for null.
// Words stay keys; widgets/text translates them where a sentence is wanted.
void appendText(std::string& out, const Value& value);
std::string toText(const Value& value);

}  // namespace deckpipe
