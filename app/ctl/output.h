// SPDX-License-Identifier: GPL-3.0-or-later
// Standard output in large pieces. A reader that went away ends the program as a pipe's end does everywhere
// (SIGPIPE); any other failure is remembered and said once.
#pragma once

#include <string>
#include <string_view>

namespace deckpipe::ctl {

// Text of a log for a terminal: control characters as "\\x1B", so that they forge no line and do nothing to it.
std::string printable(std::string_view text);

class Output {
 public:
  // Append here; write() sends what has gathered once it is worth it, flush() all of it.
  std::string& text() { return m_text; }
  bool write() { return m_text.size() < kWorthWriting || flush(); }
  // False where standard output takes no more.
  bool flush();

 private:
  static constexpr std::size_t kWorthWriting = 256 * 1024;
  std::string m_text;
  bool m_failed = false;
};

}  // namespace deckpipe::ctl
