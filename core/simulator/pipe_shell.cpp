// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/pipe_shell.h"

#include <algorithm>

namespace deckpipe::simulator {

void PipeShell::clear() {
  m_line.clear();
  m_answer.clear();
  m_peer = kNullAddress;
  m_ackBy = kNever;
}

void PipeShell::received(Instant now, Address from, std::span<const std::uint8_t> characters) {
  if (from != m_peer) clear();
  m_peer = from;
  if (now >= m_ackBy) {
    m_answer.clear();
    m_ackBy = kNever;
  }
  for (const std::uint8_t c : characters) {
    if (c == '\r') continue;
    if (c != '\n') {
      if (m_line.size() < kLongestLine) m_line += static_cast<char>(c);
      continue;
    }
    if (m_line == "A?" && m_answer.empty()) m_answer = m_banner + "\r\n";
    m_line.clear();
  }
}

void PipeShell::acknowledged(Address from) {
  if (from == m_peer) m_ackBy = kNever;
}

std::optional<std::string> PipeShell::takePacket(Instant now) {
  if (m_ackBy != kNever && now >= m_ackBy) {
    m_answer.clear();
    m_ackBy = kNever;
  }
  if (m_answer.empty() || m_ackBy != kNever) return {};
  const std::string packet = m_answer.substr(0, kPacket);
  m_answer.erase(0, packet.size());
  m_ackBy = now + kAckTimeout;
  return packet;
}

}  // namespace deckpipe::simulator
