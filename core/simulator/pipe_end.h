// SPDX-License-Identifier: GPL-3.0-or-later
// A device's end of the ASCII data pipe (CAN Messaging manual, message type FE): packets of up to 7
// characters and their acknowledgements, with a PipeShell behind them. Device passes it what came and the
// time, and puts its packets on the bus. Both directions run at once.
//
// 1. One packet of ours is on its way at a time; the next goes out after its acknowledgement. Without one for
//    1 s everything that waits is given up, and the shell says so with the next input.
// 2. Every packet that is taken is acknowledged. There is no sequence number, so one that comes twice is
//    taken twice.
// 3. One peer at a time: while a line, a file or an answer is under way others are neither heard nor
//    acknowledged, until the peer was silent for 10 s.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/ids.h"
#include "base/time.h"
#include "protocol/encode.h"
#include "simulator/misbehaviour.h"
#include "simulator/pipe_shell.h"

namespace deckpipe::simulator {

class PipeEnd {
 public:
  static constexpr std::size_t kPacket = 7;  // characters
  static constexpr Duration kAckTimeout = 1s, kPeerSilence = 10s;
  static constexpr Duration kThinking = 2ms;  // from a packet to its acknowledgement; ours

  struct Outgoing {
    Instant due;
    Address to;
    MessageId message;
    Encoded data;
  };

  explicit PipeEnd(const PipeShell::Facts& facts) : m_shell(facts) {}

  void misbehave(const PipeFaults& how);
  // No characters: an acknowledgement.
  void received(Instant now, Address from, std::span<const std::uint8_t> characters);
  void timeCame(Instant now);
  Instant nextTime() const { return std::min(m_ackBy, m_shell.nextTime()); }
  void takeOutgoing(std::vector<Outgoing>& out);
  void clear();

  // PipeFaults::vanishAfter has come true; true once.
  bool vanishes();
  // "PIPE IN 12 OUT 3": data packets since it started.
  std::string status() const;

 private:
  bool isTakenByAnother(Instant now, Address from) const;
  void acknowledge(Instant now);
  void send(Instant now);

  PipeShell m_shell;
  PipeFaults m_faults;
  unsigned m_in = 0, m_acks = 0, m_out = 0;  // since the misbehaviour was set, for Losses
  bool m_vanished = false;
  unsigned m_taken = 0, m_sent = 0;
  Address m_peer = kNullAddress;
  Instant m_heardAt = kNotYet;
  Instant m_ackBy = kNever;  // kNever: none is on its way
  std::size_t m_onItsWay = 0;
  std::vector<Outgoing> m_outgoing;
};

}  // namespace deckpipe::simulator
