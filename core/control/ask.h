// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked of an Akron device: the polls, which only read, and the commands, which change something
// and are guarded (CAN Messaging manual, message types 02-05, 21, 41, 45, 46).
#pragma once

#include <cstddef>
#include <cstdint>

namespace deckpipe {

// Numbers stand in files (core/log/note_codec.h): never renumber one, never use one again. They count from 0
// without a gap, as tables are indexed by them.
enum class Ask : std::uint8_t {
  Fault = 0,
  Firmware = 1,
  Pcode = 2,
  Config = 3,
  Vista = 4,
  ZeroAxes = 5,   // command, acknowledged
  Reset = 6,      // command, never acknowledged: the device announces itself anew
  SetupMode = 7,  // command, acknowledged
  Count,
};
inline constexpr std::size_t kAsks = static_cast<std::size_t>(Ask::Count);
constexpr bool isKnown(Ask ask) { return ask < Ask::Count; }

// A set of them.
struct AskSet {
  std::uint8_t bits = 0;

  constexpr AskSet() = default;
  template <typename... Asks>
  constexpr explicit AskSet(Asks... asks)
      : bits(static_cast<std::uint8_t>(((1u << static_cast<unsigned>(asks)) | ...))) {}
  constexpr bool has(Ask ask) const { return (bits >> static_cast<unsigned>(ask) & 1u) != 0; }
  constexpr bool isEmpty() const { return bits == 0; }
  constexpr void add(Ask ask) { bits = static_cast<std::uint8_t>(bits | 1u << static_cast<unsigned>(ask)); }
  friend constexpr AskSet operator&(AskSet a, AskSet b) {
    a.bits &= b.bits;
    return a;
  }
  friend constexpr bool operator==(AskSet, AskSet) = default;
};
inline constexpr AskSet kPolls{Ask::Fault, Ask::Firmware, Ask::Pcode, Ask::Config, Ask::Vista};

constexpr bool isCommand(Ask ask) { return !kPolls.has(ask); }

// How a request came to its end. Numbers stand in files: never renumber one, never use one again.
enum class RequestEnd : std::uint8_t {
  None = 0,         // it has not
  Answered = 1,     // acknowledged, or for a reset: announced itself anew
  WrongAnswer = 2,  // answers came, none of a length the manual gives
  NoAnswer = 3,     // after all tries
  Cancelled = 4,    // by the person, or by locking
  LinkLost = 5,
  Gone = 6,                // the device has no address any more
  AnsweredLate = 7,        // after it had been given up
  AddressLost = 8,         // the console's own, which the answer was to go to
  NotOnBus = 9,            // a poll that has not reached the bus, or a command that the adapter did not take
  WentOutLate = 10,        // a command that was 'not on the bus yet' for a while
  GoneWithInterface = 11,  // a command that was not on the bus yet when the interface went down
};

constexpr bool isKnown(RequestEnd end) {
  switch (end) {
    case RequestEnd::None:
    case RequestEnd::Answered:
    case RequestEnd::WrongAnswer:
    case RequestEnd::NoAnswer:
    case RequestEnd::Cancelled:
    case RequestEnd::LinkLost:
    case RequestEnd::Gone:
    case RequestEnd::AnsweredLate:
    case RequestEnd::AddressLost:
    case RequestEnd::NotOnBus:
    case RequestEnd::WentOutLate:
    case RequestEnd::GoneWithInterface: return true;
  }
  return false;
}

}  // namespace deckpipe
