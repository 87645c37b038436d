// SPDX-License-Identifier: GPL-3.0-or-later
// How each thing that can be asked of an Akron device is asked: the polls, which only read, and the commands,
// which change something and are guarded. Source: CAN Messaging manual, message types 02-05, 21, 41, 45, 46;
// deadlines are Deckpipe's own. Which messages ask and answer it the catalogue says (protocol/akron.h).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/enum_table.h"
#include "base/request.h"
#include "base/time.h"

namespace deckpipe {

enum class RequestKind : std::uint8_t {
  Poll,     // reads; may be repeated
  Command,  // changes something in the device; sent once
};

struct RequestFacts {
  std::string_view key;  // on command lines and in JSON: frozen contract
  RequestKind kind;
  Duration patience;  // of one try
  unsigned tries;     // commands are never repeated by themselves
};

// To add a poll: a Request, its row here, its messages in the catalogue, its words in text/service_text.cpp, and who
// takes it in protocol/device_types.h.
inline constexpr EnumTable<Request, RequestFacts> kRequestFacts{{
    {Request::Fault, {"fault", RequestKind::Poll, 500ms, 3}},
    {Request::Firmware, {"firmware", RequestKind::Poll, 500ms, 3}},
    {Request::Pcode, {"pcode", RequestKind::Poll, 500ms, 3}},
    {Request::Config, {"config", RequestKind::Poll, 500ms, 3}},
    {Request::Vista, {"vista", RequestKind::Poll, 500ms, 3}},
    {Request::ZeroAxes, {"zero_axes", RequestKind::Command, 1s, 1}},
    {Request::Reset, {"reset", RequestKind::Command, 10s, 1}},
    {Request::SetupMode, {"setup_mode", RequestKind::Command, 1s, 1}},
}};

constexpr bool isCommand(Request request) { return kRequestFacts[request].kind == RequestKind::Command; }

// The commands, in order; tables over them have a row for each.
inline constexpr auto kCommands = [] {
  constexpr auto kCount = static_cast<std::size_t>(std::ranges::count_if(kAllOf<Request>, isCommand));
  std::array<Request, kCount> commands{};
  std::ranges::copy_if(kAllOf<Request>, commands.begin(), isCommand);
  return commands;
}();

using RequestSet = EnumSet<Request>;
inline constexpr RequestSet kPolls = [] {
  RequestSet polls;
  for (const Request request : kAllOf<Request>) {
    if (!isCommand(request)) polls.add(request);
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
template <>
inline constexpr RequestEnd kLastOf<RequestEnd> = RequestEnd::CannotTell;

}  // namespace deckpipe
