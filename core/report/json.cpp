// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json.h"

#include <charconv>

#include "bus/frame.h"

namespace deckpipe {
namespace {

constexpr char kHexDigits[] = "0123456789ABCDEF";

// Length of the UTF-8 sequence that starts at text[i]; 0 where none does.
std::size_t utf8Length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned first = byte(i);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  }
  if ((first == 0xE0 && byte(i + 1) < 0xA0) || (first == 0xED && byte(i + 1) >= 0xA0) ||
      (first == 0xF0 && byte(i + 1) < 0x90) || (first == 0xF4 && byte(i + 1) >= 0x90)) {
    return 0;  // overlong, surrogate, or beyond Unicode
  }
  return length;
}

}  // namespace

void appendHex(std::string& out, std::uint64_t value, unsigned digits) {
  char text[16];
  for (unsigned i = 0; i < digits; ++i) text[i] = kHexDigits[value >> 4 * (digits - 1 - i) & 15];
  out.append(text, digits);
}

void appendJsonString(std::string& out, std::string_view text) {
  const auto isPlain = [](char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; };
  out += '"';
  for (std::size_t i = 0; i < text.size();) {
    std::size_t plain = i;
    while (plain < text.size() && isPlain(text[plain])) ++plain;
    out.append(text, i, plain - i);
    i = plain;
    if (i == text.size()) break;
    const std::size_t length = utf8Length(text, i);
    const auto c = static_cast<unsigned char>(text[i]);
    if (length == 0 || c < 0x20) {
      out += "\\u";
      appendHex(out, c, 4);
      ++i;
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out.append(text, i, length);
      i += length;
    }
  }
  out += '"';
}

void appendJsonNumber(std::string& out, std::int64_t number) {
  char buffer[24];
  out.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
}

void appendJsonValue(std::string& out, const Value& value) {
  switch (value.type()) {
    case Value::Type::Null: out += "null"; break;
    case Value::Type::Flag: out += value.flag() ? "true" : "false"; break;
    case Value::Type::Integer:
    case Value::Type::Decimal:
    case Value::Type::Real: appendText(out, value); break;
    case Value::Type::Word:
    case Value::Type::Text: appendJsonString(out, value.text()); break;
    case Value::Type::Bytes:
      out += '"';
      for (const std::uint8_t byte : value.bytes()) appendHex(out, byte, 2);
      out += '"';
      break;
    case Value::Type::Names:
      out += '[';
      for (const ValueName& name : value.words()) {
        if ((value.mask() >> name.value & 1u) == 0) continue;
        if (out.back() != '[') out += ',';
        appendJsonString(out, name.word);
      }
      out += ']';
      break;
    case Value::Type::Numbers:
      out += '[';
      for (unsigned bit = 0; bit < 32; ++bit) {
        if ((value.mask() >> bit & 1u) == 0) continue;
        if (out.back() != '[') out += ',';
        appendJsonNumber(out, bit);
      }
      out += ']';
      break;
  }
}

void appendJsonSeconds(std::string& out, std::int64_t stampNs) {
  if (stampNs == kNoStamp) {
    out += "null";
    return;
  }
  // To the nearest microsecond; half a microsecond goes away from zero.
  const bool negative = stampNs < 0;
  const std::uint64_t magnitude =
      negative ? 0 - static_cast<std::uint64_t>(stampNs) : static_cast<std::uint64_t>(stampNs);
  const std::uint64_t micros = (magnitude + 500) / 1000;
  if (negative && micros != 0) out += '-';
  appendJsonNumber(out, static_cast<std::int64_t>(micros / 1'000'000));
  out += '.';
  char decimals[6];
  std::uint64_t rest = micros % 1'000'000;
  for (std::size_t i = sizeof decimals; i-- > 0; rest /= 10) decimals[i] = static_cast<char>('0' + rest % 10);
  out.append(decimals, sizeof decimals);
}

}  // namespace deckpipe
