// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that are not plain bytes, made plain before any format looks at them: a UTF-8 mark is skipped, and UTF-16
// (what PowerShell's `>` writes) becomes bytes. openLog() and pipes use it. Logs are ASCII; a UTF-16 character
// beyond that becomes '?'.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "log/log_bytes.h"

namespace deckpipe {

enum class TextMark : std::uint8_t { None, Utf8, Utf16Little, Utf16Big };

// By the first kMaxTextMark bytes of a log, or all of it if it is shorter. A log has one mark at most.
inline constexpr std::size_t kMaxTextMark = 3;
TextMark textMarkOf(std::string_view head);

// The plain bytes of a log with a mark. The log must live as long.
class UnmarkedBytes final : public LogBytes {
 public:
  UnmarkedBytes(const LogBytes& bytes, TextMark mark) : m_bytes(bytes), m_mark(mark) {}
  std::uint64_t size() const override;
  std::string get(std::uint64_t from, std::uint64_t to, std::vector<char>& buffer,
                  std::string_view& piece) const override;

 private:
  const LogBytes& m_bytes;
  TextMark m_mark;
};

// The same of what comes through a pipe, piece by piece.
class Unmarker {
 public:
  // The plain bytes that can be made by now. Until three bytes are there, none.
  std::string take(std::string_view bytes);
  // The pipe has ended: what was held back.
  std::string finish();

 private:
  std::string m_held;
  TextMark m_mark = TextMark::None;
  bool m_isDecided = false;
};

}  // namespace deckpipe
