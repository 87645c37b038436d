// SPDX-License-Identifier: GPL-3.0-or-later
// Where the lines of a text log end: at LF, at CR LF, and at a CR that no LF follows; mixed too. File and pipe
// ask the same functions, so that they cut a text alike. A CR that is the last known byte ends no line yet,
// since an LF may follow.
#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>

namespace deckpipe {

// The last byte of the line that begins at `begin`, with its end; null if none of the bytes before `end` is.
inline const char* findLineEnd(const char* begin, const char* end) {
  const auto find = [](const char* from, const char* to, char c) {
    return from < to ? static_cast<const char*>(std::memchr(from, c, static_cast<std::size_t>(to - from)))
                     : nullptr;
  };
  const char* const feed = find(begin, end, '\n');
  // A CR right before the LF is a part of its line end.
  const char* const before = feed != nullptr ? feed - 1 : end - 1;
  const char* const lone = before > begin ? find(begin, before, '\r') : nullptr;
  return lone != nullptr ? lone : feed;
}

// Number of bytes of whole lines with their ends.
inline std::size_t wholeLines(std::string_view text) {
  // npos + 1 is 0.
  const std::size_t feed = text.rfind('\n') + 1;
  const std::size_t lone = text.size() < 2 ? 0 : text.rfind('\r', text.size() - 2) + 1;
  return feed > lone ? feed : lone;
}

}  // namespace deckpipe
