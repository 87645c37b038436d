// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace deckpipe::ctl {

std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7F) {
      out += c;
      continue;
    }
    char escaped[8];
    std::snprintf(escaped, sizeof escaped, "\\x%02X", byte);
    out += escaped;
  }
  return out;
}

bool Output::flush() {
  if (!m_failed && !m_text.empty() &&
      (std::fwrite(m_text.data(), 1, m_text.size(), stdout) != m_text.size() || std::fflush(stdout) != 0)) {
    m_failed = true;
    std::fprintf(stderr, "deckpipectl: standard output: %s\n", std::strerror(errno));
  }
  m_text.clear();
  return !m_failed;
}

}  // namespace deckpipe::ctl
