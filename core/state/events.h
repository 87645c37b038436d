// SPDX-License-Identifier: GPL-3.0-or-later
// What happened in a log, and when: devices that appeared or changed their address, claims, nodes that
// started, errors, silences, jumps of the clock. One look through the frames, a bounded piece at a time,
// continued as the log grows; EventModel shows them together with the notes. Where a device counts as silent
// later on is the state's business: an event stands at the frame that proves it.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "state/log_view.h"

namespace deckpipe {

enum class EventKind : std::uint8_t {
  Announced,       // pin, address: heard of for the first time
  AddressChanged,  // pin, address, previous
  Claimed,         // name, address: that nobody held, or another
  CannotClaim,     // name; address: where it was, null if nowhere
  NodeStarted,     // node: its boot-up message
  ErrorBegan,      // address or node: a monitor reports an operational error
  ErrorEnded,
  SilenceEnded,  // address or node; lasted: what repeats itself did not come for so long
  ErrorFrames,   // of the controller; only the first of a series
  ClockJump,
};

struct Event {
  EventKind kind = EventKind::ClockJump;
  std::uint64_t frame = 0;
  Instant time;
  Channel channel;
  Address address;   // null: none
  Address previous;  // null: none
  NodeId node;       // 0: none
  Pin pin;
  Name name;
  Duration lasted{};
  friend bool operator==(const Event&, const Event&) = default;
};

class Events {
 public:
  // Beyond these a person reads no list; looking stops.
  static constexpr std::size_t kMost = 20'000;
  // Shorter gaps are jitter, or the device table's to show.
  static constexpr Duration kSilence = 1s;

  // Looks at up to so many further frames before `until`; not beyond what the log's index of roles has built.
  // False where frames remain to be looked at.
  bool take(const LogDocument& log, std::uint64_t until, std::uint64_t atMost);

  const std::vector<Event>& list() const { return m_list; }
  bool isFull() const { return m_list.size() >= kMost; }

 private:
  // Of a J1939 address or a CANopen node.
  struct Talker {
    Pin pin;                       // as the address book says
    Name name;                     // … that holds the address
    Instant lastStatus = kNotYet;  // of what it repeats
    bool hasError = false;
  };
  struct Bus {
    std::array<Talker, 256> addresses;
    std::array<Talker, 128> nodes;
    Instant lastError = kNotYet;
    Instant nextDecision = kNever;  // of a contest
  };

  void look(const LogDocument& log, const Frame& frame, Event at);
  void lookExtended(const LogDocument& log, Bus& bus, const Frame& frame, Event at);
  void lookStandard(const LogDocument& log, Bus& bus, const Frame& frame, Event at);
  void nameHeard(const LogDocument& log, Bus& bus, Name name, const Event& at);
  void announced(const LogDocument& log, Bus& bus, Event at);
  void timeCame(const LogDocument& log, Bus& bus, const Event& at);
  void compareHolder(const AddressBook& book, Bus& bus, Address address, Event at);
  void statusHeard(const LogDocument& log, Talker& talker, const Frame& frame, const Event& at);
  bool isMessage(const LogDocument& log, const Frame& frame, const Event& at, MessageId id);
  void add(EventKind kind, Event at);

  std::vector<Event> m_list;
  std::array<Bus, kMaxChannels> m_buses{};
  RoleIndex::Stand m_roles;
  std::uint64_t m_looked = 0;
};

}  // namespace deckpipe
