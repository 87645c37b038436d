// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/text_marks.h"

#include <utility>

namespace deckpipe {
namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF", kLittleMark = "\xFF\xFE", kBigMark = "\xFE\xFF";

std::size_t sizeOf(TextMark mark) {
  switch (mark) {
    case TextMark::None: return 0;
    case TextMark::Utf8: return kUtf8Mark.size();
    case TextMark::Utf16Little:
    case TextMark::Utf16Big: return kLittleMark.size();
  }
  return 0;
}

bool isWide(TextMark mark) { return mark == TextMark::Utf16Little || mark == TextMark::Utf16Big; }

// One byte for each whole UTF-16 unit. `to` may be where `wide` begins.
void narrow(std::string_view wide, TextMark mark, char* to) {
  const std::size_t low = mark == TextMark::Utf16Little ? 0 : 1;
  for (std::size_t i = 0; i + 1 < wide.size(); i += 2) {
    const bool isAscii = wide[i + 1 - low] == 0 && static_cast<unsigned char>(wide[i + low]) < 0x80;
    *to++ = isAscii ? wide[i + low] : '?';
  }
}

}  // namespace

TextMark textMarkOf(std::string_view head) {
  if (head.starts_with(kUtf8Mark)) return TextMark::Utf8;
  if (head.starts_with(kLittleMark)) return TextMark::Utf16Little;
  if (head.starts_with(kBigMark)) return TextMark::Utf16Big;
  return TextMark::None;
}

std::uint64_t UnmarkedBytes::size() const {
  const std::uint64_t rest = m_bytes.size() - sizeOf(m_mark);
  return isWide(m_mark) ? rest / 2 : rest;
}

std::string UnmarkedBytes::get(std::uint64_t from, std::uint64_t to, std::vector<char>& buffer,
                               std::string_view& piece) const {
  const std::uint64_t begin = sizeOf(m_mark);
  if (!isWide(m_mark)) return m_bytes.get(begin + from, begin + to, buffer, piece);
  std::string_view wide;
  if (std::string why = m_bytes.get(begin + 2 * from, begin + 2 * to, buffer, wide); !why.empty()) return why;
  // What lies in memory is not ours to change.
  if (buffer.size() < wide.size() || wide.data() != buffer.data()) {
    buffer.assign(wide.begin(), wide.end());
    wide = {buffer.data(), wide.size()};
  }
  narrow(wide, m_mark, buffer.data());
  piece = {buffer.data(), wide.size() / 2};
  return {};
}

std::string Unmarker::take(std::string_view bytes) {
  m_held += bytes;
  if (!m_isDecided) {
    if (m_held.size() < kMaxTextMark) return {};
    m_isDecided = true;
    m_mark = textMarkOf(m_held);
    m_held.erase(0, sizeOf(m_mark));
  }
  if (!isWide(m_mark)) return std::exchange(m_held, {});
  const std::size_t whole = m_held.size() / 2 * 2;
  std::string plain(whole / 2, '\0');
  narrow(std::string_view(m_held).substr(0, whole), m_mark, plain.data());
  m_held.erase(0, whole);
  return plain;
}

std::string Unmarker::finish() {
  if (m_isDecided) return {};  // half a character is none
  m_isDecided = true;
  m_held.erase(0, sizeOf(textMarkOf(m_held)));
  return std::exchange(m_held, {});
}

}  // namespace deckpipe
