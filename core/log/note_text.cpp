// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_text.h"

#include <charconv>
#include <type_traits>

#include "log/note_layout.h"

namespace deckpipe {
namespace {

// In the place of an angle that is not known.
constexpr std::string_view kNoAngleWord = "none";
constexpr std::string_view kHexDigits = "0123456789ABCDEF";

class TextWriter {
 public:
  explicit TextWriter(std::string& out) : m_out(out) {}

  template <typename T>
  requires std::is_unsigned_v<T>
  void put(T number) { m_out += std::to_string(number); }
  void put(bool flag) { m_out += flag ? '1' : '0'; }
  template <typename E>
  requires std::is_enum_v<E>
  void put(E value) { put(static_cast<std::uint8_t>(value)); }
  void put(Channel channel) { put(channel.value); }
  void put(Address address) {
    m_out += "0x";
    m_out += kHexDigits[address.value >> 4u];
    m_out += kHexDigits[address.value & 0xFu];
  }
  void put(const Pin& pin) { putQuoted(pin.text()); }
  void put(const NoteText& text) { putQuoted(text.str()); }
  void put(const note::NotedAngle& angle) {
    m_out += angle.tenths ? std::to_string(*angle.tenths) : std::string(kNoAngleWord);
  }

 private:
  // Control characters would end the line or hide; '\' and '"' would end the text.
  void putQuoted(std::string_view text) {
    m_out += '"';
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0x20 && byte != 0x7F && c != '"' && c != '\\') {
        m_out += c;
      } else {
        m_out += "\\x";
        m_out += kHexDigits[byte >> 4u];
        m_out += kHexDigits[byte & 0xFu];
      }
    }
    m_out += '"';
  }

  std::string& m_out;
};

class TextReader : public layouts::FieldReader<TextReader> {
 public:
  using FieldReader::take;

  explicit TextReader(std::string_view text) : m_text(text) {}

  void take(Address& address) {
    takeWord("0x");
    takeNumber(address.value, 16);
  }
  void take(NoteText& text) {
    std::string words = takeText();
    if (words.size() > NoteText::kMaxBytes) m_isDamaged = true;
    text = std::move(words);
  }
  void take(note::NotedAngle& angle) {
    if (m_text.starts_with(kNoAngleWord)) return takeWord(kNoAngleWord);
    takeNumber(angle.tenths.emplace());
  }
  template <typename Member, typename T>
  void take(const layouts::Field<Member>& field, T& value) {
    if (field.isLater && m_text.empty()) return;
    takeWord(" ");
    takeWord(field.name);
    takeWord("=");
    take(value);
  }
  // The word for people: what it says is in the number.
  void passWord() {
    takeWord(" ");
    m_text.remove_prefix(std::min(m_text.find(' '), m_text.size()));
  }
  template <typename T>
  void takeNumber(T& number, int base = 10) {
    const char* const end = m_text.data() + m_text.size();
    const auto [p, error] = std::from_chars(m_text.data(), end, number, base);
    if (error != std::errc()) m_isDamaged = true;
    if (!m_isDamaged) m_text.remove_prefix(static_cast<std::size_t>(p - m_text.data()));
  }
  std::string takeText() {
    std::string text;
    takeWord("\"");
    while (!m_isDamaged && !m_text.empty() && m_text.front() != '"') {
      char c = m_text.front();
      m_text.remove_prefix(1);
      if (c == '\\') {
        std::uint8_t byte = 0;
        takeWord("x");
        const std::string_view digits = m_text.substr(0, 2);
        const auto [p, error] = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
        if (error != std::errc() || p != digits.data() + 2) m_isDamaged = true;
        if (!m_isDamaged) m_text.remove_prefix(2);
        c = static_cast<char>(byte);
      }
      text += c;
    }
    takeWord("\"");
    return text;
  }
  bool isAtEnd() const { return m_text.empty() || m_text.front() == ' '; }

 private:
  void takeWord(std::string_view word) {
    if (!m_text.starts_with(word)) m_isDamaged = true;
    if (!m_isDamaged) m_text.remove_prefix(word.size());
  }

  std::string_view m_text;
};

}  // namespace

void appendNoteText(std::string& out, const NoteValue& value) {
  TextWriter writer(out);
  std::visit(
      [&]<typename T>(const T& kind) {
        writer.put(layouts::kLayout<T>.number);
        out += ' ';
        out += noteKey(value);
        const auto put = [&](const auto& field) {
          out += ' ';
          out += field.name;
          out += '=';
          writer.put(kind.*field.member);
        };
        std::apply([&](const auto&... fields) { (put(fields), ...); }, layouts::kLayout<T>.fields);
      },
      value);
}

Result<std::optional<NoteValue>, NoteFault> noteOfText(std::string_view text) {
  TextReader reader(text);
  std::uint8_t kind = 0;
  reader.take(kind);
  reader.passWord();
  std::optional<NoteValue> value;
  if (!reader.isDamaged()) value = layouts::takeValue(kind, reader);
  if (reader.isDamaged() || kind == 0 || (value && !reader.isAtEnd())) return Failure{NoteFault::Damaged};
  if (reader.isUnknown()) value.reset();
  return value;
}

}  // namespace deckpipe
