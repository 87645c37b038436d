// SPDX-License-Identifier: GPL-3.0-or-later
// The far end of the ASCII data pipe (CAN Messaging manual, message type FE) with a shell of one command: the
// line "A?" is answered with a line that names the device. The manual gives no command's answer; this one is
// the twin's own. Called by Monitor6032, which sends the acknowledgements.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/ids.h"
#include "base/time.h"

namespace deckpipe::simulator {

class PipeShell {
 public:
  static constexpr std::size_t kPacket = 7;        // characters
  static constexpr std::size_t kLongestLine = 80;  // longer ones are dropped
  static constexpr Duration kAckTimeout = 1s;      // then the rest of the answer is given up

  explicit PipeShell(std::string banner) : m_banner(std::move(banner)) {}

  void received(Instant now, Address from, std::span<const std::uint8_t> characters);
  void acknowledged(Address from);
  void clear();

  // The next packet, where one may be sent: one is on its way at a time.
  std::optional<std::string> takePacket(Instant now);
  Address peer() const { return m_peer; }

 private:
  std::string m_banner;
  std::string m_line;    // received, not yet ended
  std::string m_answer;  // not yet sent
  Address m_peer = kNullAddress;
  Instant m_ackBy = kNever;  // kNever: none is on its way
};

}  // namespace deckpipe::simulator
