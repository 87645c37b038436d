// SPDX-License-Identifier: GPL-3.0-or-later
// How a device of the simulator gets its address: SAE J1939-81 as the CAN Messaging manual's Appendix A uses
// it. Owned by Device, which passes it every frame and the time, and announces itself on Event::Claimed.
//
// 1. An address may be used 250 ms after it was claimed, unless a numerically lower NAME claimed it too.
// 2. Whoever loses forgets what it wanted to send, and claims the next address nobody is known to hold.
// 3. Where none is free it says so once from the null address, 0-153 ms later, and then only when asked.
// 4. Claims of a length other than 8, from the global address or with NAME 0 mean nothing.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "base/time.h"
#include "bus/j1939.h"
#include "protocol/address_book.h"
#include "protocol/encode.h"
#include "protocol/lists.h"
#include "protocol/typed.h"
#include "simulator/outbox.h"
#include "simulator/random.h"

namespace deckpipe::simulator {

// Who a device of the simulator is: NAME, PIN and the versions it answers polls with (messages 60928, FF,
// 03, 04, 05 of the CAN Messaging manual).
struct Identity {
  Name name;
  std::string model;       // as the manual calls it, for people on the pipe
  std::optional<Pin> pin;  // nothing: the device cannot announce itself (6039)
  FirmwareVersions firmware{0x010B, 0x0204, 0x0206};
  PcodeVersion pcode;
  ConfigVersion config;
};

// A NAME of Akron's as the manual's example has it: function 66, industry group 1, arbitrary address capable.
Name akronName(std::uint32_t identityNumber);
// With the NAME that belongs to this PIN. `pin` must be a PIN.
Identity identityOf(std::string_view pin, PcodeVersion pcode, ConfigVersion config);

// The data of a message whose values are ours, so that failing to encode is a bug of ours.
Encoded encoded(MessageId id, std::initializer_list<FieldValue> values = {});

Frame nameFrame(Name name, Address source);
Frame announcementFrame(const Pin& pin, Address source);

class AddressClaim {
 public:
  static constexpr Duration kContention = 250ms;
  // From hearing a claim or a request to the answer; ours, no frame can follow another at once.
  static constexpr Duration kThinking = 1ms;

  enum class State : std::uint8_t { Off, Contending, Claimed, CannotClaim };
  enum class Event : std::uint8_t {
    None,
    Claimed,   // the address may be used from now on
    Lost,      // it may not be used any more
    Answered,  // a request for the NAME was answered
  };
  // Addresses that may be claimed, the first one first. Akron's devices start at 80 hex.
  struct Range {
    Address first = kFirstDynamic, last = kLastDynamic;
  };

  AddressClaim(Name name, Range range, std::uint64_t seed) : m_name(name), m_range(range), m_random(seed) {}

  void start(Instant now, Outbox& out);
  // At another address than the last, where there is one.
  void startElsewhere(Instant now, Outbox& out);
  void stop();
  Event received(Instant now, const J1939Id& id, const Frame& frame, Outbox& out);
  Event timeCame(Instant now, Outbox& out);
  Instant nextTime() const { return m_deadline; }

  State state() const { return m_state; }
  // Null unless claimed.
  Address address() const { return m_state == State::Claimed ? m_address : kNullAddress; }
  Name name() const { return m_name; }

 private:
  Event claimHeard(Instant now, Address source, Name name, Outbox& out);
  Event requestHeard(Instant now, Address destination, Outbox& out);
  void claim(Instant now, Address address, Outbox& out);
  void cannotClaim(Instant now, Outbox& out);
  std::optional<Address> nextFree() const;

  Name m_name;
  Range m_range;
  Random m_random;
  State m_state = State::Off;
  Address m_address = kNullAddress;
  Address m_last = kNullAddress;  // claimed before it was stopped
  Instant m_deadline = kNever;
  std::array<std::uint64_t, 256> m_holders{};  // NAMEs of others by their address, 0 = none heard
};

}  // namespace deckpipe::simulator
