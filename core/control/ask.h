// SPDX-License-Identifier: GPL-3.0-or-later
// How each thing that can be asked of an Akron device is asked: the polls, which only read, and the commands,
// which change something and are guarded. Source: CAN Messaging manual, message types 02-05, 21, 41, 45, 46;
// deadlines are Deckpipe's own. Which messages ask and answer it the catalogue says (protocol/akron.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/ask.h"
#include "base/enum_table.h"
#include "base/time.h"

namespace deckpipe {

enum class AskKind : std::uint8_t {
  Poll,     // reads; may be repeated
  Command,  // changes something in the device; sent once
};

struct AskFacts {
  std::string_view key;  // on command lines and in JSON: frozen contract
  AskKind kind;
  Duration patience;  // of one try
  unsigned tries;     // commands are never repeated by themselves
};

// To add a poll: an Ask, its row here, its messages in the catalogue, its words in text/service_text.cpp, and in
// protocol/device_types.h who takes it, unless every device does.
inline constexpr EnumTable<Ask, AskFacts> kAskFacts{{
    {Ask::Fault, {"fault", AskKind::Poll, 500ms, 3}},
    {Ask::Firmware, {"firmware", AskKind::Poll, 500ms, 3}},
    {Ask::Pcode, {"pcode", AskKind::Poll, 500ms, 3}},
    {Ask::Config, {"config", AskKind::Poll, 500ms, 3}},
    {Ask::Vista, {"vista", AskKind::Poll, 500ms, 3}},
    {Ask::ZeroAxes, {"zero_axes", AskKind::Command, 1s, 1}},
    {Ask::Reset, {"reset", AskKind::Command, 10s, 1}},
    {Ask::SetupMode, {"setup_mode", AskKind::Command, 1s, 1}},
}};

constexpr bool isCommand(Ask ask) { return kAskFacts[ask].kind == AskKind::Command; }

// The commands, in order; tables over them have a row for each.
inline constexpr auto kCommands = [] {
  constexpr auto kCount = static_cast<std::size_t>(std::ranges::count_if(kAllOf<Ask>, isCommand));
  std::array<Ask, kCount> commands{};
  std::ranges::copy_if(kAllOf<Ask>, commands.begin(), isCommand);
  return commands;
}();

using AskSet = EnumSet<Ask>;
inline constexpr AskSet kPolls = [] {
  AskSet polls;
  for (const Ask ask : kAllOf<Ask>) {
    if (!isCommand(ask)) polls.add(ask);
  }
  return polls;
}();

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
  CannotTell = 12,         // … and whose fate cannot be told: lost frames, its echo perhaps among them
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
    case RequestEnd::GoneWithInterface:
    case RequestEnd::CannotTell: return true;
  }
  return false;
}

}  // namespace deckpipe
