// SPDX-License-Identifier: GPL-3.0-or-later
// Requests of types 41 and 46 on one channel that wait for their answer: a request and its
// answer look alike, and only an open request tells them apart (protocol.md 1.3). AddressBook owns one.
#pragma once

#include <array>
#include <cstdint>

#include "base/ids.h"
#include "base/time.h"

namespace deckpipe {

class OpenRequests {
 public:
  // Whether a request of this type from `to` to `from` waits for an answer at this time.
  bool awaitsAnswer(std::uint8_t type, Address from, Address to, Instant time) const {
    return m_waiting != 0 && find(type, to, from, time) != kRequests;
  }
  // A request or an answer was on the bus. Both return whether anything has changed. The oldest request makes room
  // where kRequests wait.
  bool requested(std::uint8_t type, Address from, Address to, Instant time);
  bool answered(std::uint8_t type, Address from, Address to, Instant time);

  friend bool operator==(const OpenRequests&, const OpenRequests&) = default;

 private:
  struct Request {
    Instant time = kNotYet;
    std::uint8_t type = 0;
    Address from, to;
    friend bool operator==(const Request&, const Request&) = default;
  };
  static constexpr std::size_t kRequests = 64;

  // The oldest of those that are alike; kRequests where there is none.
  std::size_t find(std::uint8_t type, Address from, Address to, Instant time) const;
  bool forgetOld(Instant time);

  std::array<Request, kRequests> m_requests{};  // a free slot has time kNotYet
  std::uint8_t m_waiting = 0;                   // slots in use; 0 spares the search
};

}  // namespace deckpipe
