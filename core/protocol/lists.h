// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of messages that other rooms need, worked out from the catalogue at compile time. Nothing here is
// written by hand: what is in a list follows from the message's own line.
#pragma once

#include <array>
#include <optional>

#include "bus/frame.h"
#include "protocol/catalogue.h"

namespace deckpipe {

// The messages of which `isWanted` (bool(const Message&)) is true, in catalogue order, as a std::array.
template <auto isWanted>
consteval auto messagesWhere() {
  constexpr std::size_t kCount = [] {
    std::size_t count = 0;
    for (const Message& message : kCatalogue) count += isWanted(message) ? 1 : 0;
    return count;
  }();
  std::array<MessageId, kCount> ids{};
  std::size_t at = 0;
  for (const Message& message : kCatalogue) {
    if (isWanted(message)) ids[at++] = message.id;
  }
  return ids;
}

// What a device repeats, or what is repeated to it: stale when older than three periods. Joystick messages
// are not among them: they belong to a source, not to a device.
constexpr bool isPeriodicReport(const Message& message) {
  return message.period > 0ns && message.family != Family::J1939;
}
inline constexpr auto kPeriodicReports = messagesWhere<isPeriodicReport>();
// Those that the device sends: while it is well they keep coming.
constexpr bool isOwnPeriodicReport(const Message& message) {
  return isPeriodicReport(message) && message.device == DeviceEnd::Sender;
}
inline constexpr auto kOwnPeriodicReports = messagesWhere<isOwnPeriodicReport>();
inline constexpr EnumArray<MessageId, bool> kIsOwnPeriodicReport = [] {
  EnumArray<MessageId, bool> is{};
  for (const MessageId id : kOwnPeriodicReports) is[id] = true;
  return is;
}();
// Those that a CANopen node sends: how often is a setting of it.
constexpr bool isNodeReport(const Message& message) {
  return isOwnPeriodicReport(message) && (message.family == Family::Canopen || message.pdo != 0);
}
inline constexpr auto kNodeReports = messagesWhere<isNodeReport>();

// The messages whose last one is kept of each device: periodic reports, and answers that its page shows.
constexpr bool isReport(const Message& message) {
  return isPeriodicReport(message) || (message.part == Part::Answers && !message.page.isEmpty());
}
inline constexpr auto kReports = messagesWhere<isReport>();

// The messages that tell who their sender is: who holds an address, with which PIN and versions. What they say
// holds until the address changes hands.
constexpr bool isIdentity(const Message& message) {
  return message.device == DeviceEnd::Sender &&
         (message.page.has(PageGroup::Address) || message.page.has(PageGroup::Versions));
}
inline constexpr auto kIdentityMessages = messagesWhere<isIdentity>();

// Place of a report in kReports; kReports.size() for any other message.
inline constexpr EnumArray<MessageId, std::uint8_t> kReportPlaces = [] {
  EnumArray<MessageId, std::uint8_t> places;
  for (std::uint8_t& place : places) place = static_cast<std::uint8_t>(kReports.size());
  for (std::size_t i = 0; i < kReports.size(); ++i) places[kReports[i]] = static_cast<std::uint8_t>(i);
  return places;
}();

inline constexpr int kStalePeriods = 3;
constexpr Duration staleAfter(MessageId id) { return kStalePeriods * messageOf(id).period; }

// Byte 1 of a message; it must have one.
constexpr std::uint8_t typeOf(MessageId id) { return static_cast<std::uint8_t>(messageOf(id).firstByte); }
constexpr bool hasTypeOf(const Frame& frame, MessageId id) {
  return frame.length > 0 && frame.data[0] == messageOf(id).firstByte;
}

// The ask whose answer or acknowledgement a message is; nothing for any other message.
constexpr std::optional<Request> requestAnsweredBy(MessageId id) {
  const Message& message = messageOf(id);
  if (message.part == Part::Answers || message.part == Part::Acknowledges) return message.request;
  return {};
}

// The request of an ask.
constexpr MessageId requestOf(Request request) {
  for (const Message& message : kCatalogue) {
    if (message.request == request && message.part == Part::Asks) return message.id;
  }
  return MessageId::Count;
}
// The messages that end a request, all of them together; Count where there are fewer.
inline constexpr std::size_t kMaxAnswers = 2;
constexpr std::array<MessageId, kMaxAnswers> answersOf(Request request) {
  std::array<MessageId, kMaxAnswers> ids{MessageId::Count, MessageId::Count};
  std::size_t at = 0;
  for (const Message& message : kCatalogue) {
    if (message.request == request && message.part != Part::Asks) ids.at(at++) = message.id;
  }
  return ids;
}

// Whether byte 1 is that of a message between one device and whoever asks it: a cheap look at a frame of PGN
// EF00 before the roles are asked.
inline constexpr std::array<bool, 256> kSaidTypes = [] {
  std::array<bool, 256> types{};
  for (const Message& message : kCatalogue) {
    if (message.isSaid()) types[typeOf(message.id)] = true;
  }
  return types;
}();

// Messages that have a simulator of the same bytes: a request and its acknowledgement, told apart by direction.
inline constexpr EnumArray<MessageId, bool> kLooksAlikeBothWays = [] {
  EnumArray<MessageId, bool> alike;
  for (const Message& a : kCatalogue) {
    for (const Message& b : kCatalogue) {
      alike[a.id] =
          alike[a.id] || (a.id != b.id && a.family == b.family && a.selector == b.selector &&
                          a.firstByte >= 0 && a.firstByte == b.firstByte && (a.lengths & b.lengths) != 0);
    }
  }
  return alike;
}();

// The bits of a message that no field marked as `aside` has.
constexpr std::uint64_t newsBits(const Message& message) {
  std::uint64_t bits = ~0ull;
  for (const Field& field : message.fields) {
    if (field.aside) bits &= ~checks::bitSet(field.bits);
  }
  return bits;
}

namespace checks {

constexpr bool everyTwinIsARequestOrItsAck() {
  for (const Message& message : kCatalogue) {
    const bool canBeTold = message.part == Part::Asks || message.part == Part::Acknowledges;
    if (kLooksAlikeBothWays[message.id] && !canBeTold) return false;
  }
  return true;
}
constexpr bool everyRequestHasItsMessages() {
  for (const Request request : kAllOf<Request>) {
    std::size_t requests = 0;
    for (const Message& message : kCatalogue) {
      if (message.request == request && message.part == Part::Asks) ++requests;
    }
    if (requests != 1 || answersOf(request)[0] == MessageId::Count) return false;
  }
  return true;
}
constexpr bool everyPartSaysItsRequest() {
  for (const Message& message : kCatalogue) {
    const bool hasRequest = message.request != Request::Count;
    if (hasRequest == (message.part == Part::None || message.part == Part::Pipe)) return false;
  }
  return true;
}
constexpr bool everyPeriodicReportIsShown() {
  for (const MessageId id : kPeriodicReports) {
    if (messageOf(id).page.isEmpty() || !messageOf(id).isWatched) return false;
  }
  return true;
}
constexpr bool everyPageGroupHasAMessage() {
  for (const PageGroup group : kAllOf<PageGroup>) {
    bool has = false;
    for (const Message& message : kCatalogue) has = has || message.page.has(group);
    if (!has) return false;
  }
  return true;
}

static_assert(everyTwinIsARequestOrItsAck(), "classify() tells a request from its ack, and no other two");
static_assert(everyRequestHasItsMessages(), "an ask has one request, and one or two messages that end it");
static_assert(everyPartSaysItsRequest(), "a message that asks or answers says what, any other says nothing");
static_assert(everyPeriodicReportIsShown(), "a periodic report is watched and stands on a page");
static_assert(everyPageGroupHasAMessage(), "a page group is made from messages");

}  // namespace checks
}  // namespace deckpipe
