// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the nodes of one channel: who is Akron, a drive, or foreign. It is causal: built from the
// frames before the one in question and from what the person said, never from later ones. Whoever walks a log
// (State, the index, deckpipectl) keeps one a channel, classifies each frame with it, then lets it observe
// the frame. Rules: protocol.md 1.3, "Whose message is it".
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "base/ids.h"
#include "base/time.h"
#include "bus/frame.h"

namespace deckpipe {

struct Classified;

class ChannelRoles {
 public:
  bool isAkron(Address a) const { return (m_roles[a.value] & kAkron) != 0; }
  bool isForeign(Address a) const { return (m_roles[a.value] & kForeign) != 0; }
  bool isDrive(Address a) const { return (m_roles[a.value] & kDrive) != 0; }
  // Answered SDO 5000.01 with a part number.
  bool isAkronNode(NodeId node) const { return m_akronNodes[node.value & 0x7F]; }
  // The NAME last claimed at an address; 0 = none heard.
  std::uint64_t name(Address a) const { return m_names[a.value]; }

  // The person says that a Copley drive is at this address, or takes it back.
  void sayDrive(Address a, bool isDrive);

  // Learns from a frame that was classified with these roles; says whether there was anything to learn. Call
  // once a frame, in order.
  bool observe(const Frame& frame, Instant time, const Classified& classified);

  // Whether a request of this type (41 or 46) from `to` to `from` waits for an answer at this time.
  bool awaitsAnswer(std::uint8_t type, Address from, Address to, Instant time) const {
    return m_waiting != 0 && findRequest(type, to, from, time) != kRequests;
  }

  friend bool operator==(const ChannelRoles&, const ChannelRoles&) = default;

 private:
  enum : std::uint8_t { kAkron = 1, kForeign = 2, kDrive = 4 };
  struct Request {
    Instant time = kNotYet;
    std::uint8_t type = 0;
    Address from, to;
    friend bool operator==(const Request&, const Request&) = default;
  };
  static constexpr std::size_t kRequests = 64;

  bool observeName(Address source, const Frame& frame);
  std::size_t findRequest(std::uint8_t type, Address from, Address to, Instant time) const;
  bool observeExchange(const Frame& frame, Instant time, const Classified& classified);

  std::array<std::uint8_t, 256> m_roles{};
  std::array<std::uint64_t, 256> m_names{};
  std::bitset<128> m_akronNodes;
  std::array<Request, kRequests> m_requests{};  // a free slot has time kNotYet
  std::uint8_t m_waiting = 0;                   // slots in use; 0 spares the search
};

}  // namespace deckpipe
