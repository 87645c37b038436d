// SPDX-License-Identifier: GPL-3.0-or-later
// What was last told of one device, and what has changed since. EventWalk owns one for each place of Devices. It
// looks only at the device that a frame touched, and only at what that frame can have changed.
#pragma once

#include <array>
#include <vector>

#include "state/event.h"

namespace deckpipe {

class DeviceWatch {
 public:
  bool isUsed() const { return m_kind != Device::Kind::Free; }
  // Whether it is still the device that this watches.
  bool isOf(const Device& device) const;
  // Begins with a device that the state has just come to know. What is known already is no change.
  void begin(const Device& device, Instant now);

  // That it is heard for the first time; `former`: it was at that address, without a PIN, before.
  Event appeared(const State& state, Address former);
  // By which event that was told; Count: it was not.
  EventKind toldAs() const { return m_toldAs; }

  // A frame came from the device, or one to it that it reports. `id`: what it is if the state took it; Count if nothing
  // of it is told.
  void look(const State& state, const Device& device, MessageId id, const Payload& data,
            std::vector<Event>& out) {
    if (m_isUnheard) heardFirst(state);
    if (m_silence.isSilent() || m_silenceDue == kNever) heard(state, device, out);
    if (device.malformed != m_malformedSeen || m_hasMalformed) lookAtLengths(state, device, id, out);
    if (id != MessageId::Count && !isAsCompared(device, id, data)) compareNew(state, device, id, data, out);
  }
  // Whatever is due by the state's time.
  void timeCame(const State& state, const Device& device, std::vector<Event>& out);
  // Its PIN, its address, or when it started may have changed.
  void lookAtIdentity(const State& state, const Device& device, std::vector<Event>& out);
  // Another NAME took its address, and that was told.
  void addressWasTaken() { m_hasAddress = false; }
  // The link of its channel went up or down.
  void linkChanged(Instant time);
  // It comes up again: what repeated something before the gap is awaited behind it. Comes before the state knows it.
  void expectBack(const State& state, const Device& device);
  // It is up again: whoever is at the address is watched from here on, and nothing is compared with before.
  void linkCameBack(const Device& device, Instant now);

  // Of one behind a gap that has not said who it is: since when it is heard. kNotYet otherwise.
  Instant nobodySince() const { return m_pin.isNull() ? m_heardFrom : kNotYet; }
  // Of one that is at its address since before a gap: since when it is heard behind it, `now` at the latest. kNotYet of
  // others.
  Instant heardFrom(Instant now) const { return m_isUnheard ? now : m_heardFrom; }
  // Nothing changes before then unless a frame comes.
  Instant due() const { return std::min({m_silenceDue, m_permissiveDue, m_retry}); }
  const Pin& pin() const { return m_pin; }
  Channel channel() const { return m_channel; }
  // Null while it has none.
  Address address() const { return m_hasAddress ? m_address : kNullAddress; }
  // The last one that it had; null: none.
  Address lastAddress() const { return m_address; }

 private:
  static constexpr std::array<std::uint64_t, kReports.size()> noneCompared() {
    std::array<std::uint64_t, kReports.size()> none{};
    none.fill(~0ull);
    return none;
  }
  static std::array<EventSlot, 32> noFaults() {
    std::array<EventSlot, 32> slots;
    slots.fill(EventSlot(0));
    return slots;
  }
  bool isAsCompared(const Device& device, MessageId id, const Payload& data) const;
  void compareNew(const State& state, const Device& device, MessageId id, const Payload& data,
                  std::vector<Event>& out);
  Event eventOf(const State& state) const;
  void heardFirst(const State& state) {
    m_isUnheard = false;
    m_heardFrom = state.cursor().time;
  }
  bool isCompared(Instant came) const { return came != kNotYet && came >= m_comparedFrom; }
  void heard(const State& state, const Device& device, std::vector<Event>& out);
  void lookAtLengths(const State& state, const Device& device, MessageId id, std::vector<Event>& out);
  void compareLengths(const State& state, std::vector<Event>& out);
  void compareSilence(const State& state, std::vector<Event>& out) {
    Event event = eventOf(state);
    if (m_silence.isNotBack()) event.pin = m_formerPin;
    m_silence.compare(event, m_retry, out);
  }
  void lookAtSilence(const State& state, const Device& device, std::vector<Event>& out);
  void compare(const State& state, const Device& device, MessageId id, std::vector<Event>& out);
  void comparePosition(const State& state, const Device& device, std::vector<Event>& out);
  void compareRotationLimits(const State& state, const Device& device, std::vector<Event>& out);
  void compareElevationLimits(const State& state, const Device& device, std::vector<Event>& out);
  void compareOutputs(const State& state, const Device& device, std::vector<Event>& out);
  void compareMiniOutputs(const State& state, const Device& device, std::vector<Event>& out);
  void compareHeartbeat(const State& state, const Device& device, std::vector<Event>& out);
  void compareFaults(const State& state, const Device& device, std::vector<Event>& out);
  void comparePermissive(const State& state, const Device& device, std::vector<Event>& out);
  void compareFlag(EventSlot& slot, bool value, EventKind on, EventKind off, Event event,
                   std::vector<Event>& out);
  void compareStop(EventSlot& slot, Status2 value, Event event, std::vector<Event>& out);
  void compareLimit(std::size_t which, std::int16_t value, Event event, std::vector<Event>& out);

  Device::Kind m_kind = Device::Kind::Free;
  Channel m_channel;
  Address m_address;  // the last one that it had
  NodeId m_node;
  Pin m_pin;
  bool m_hasAddress = false;
  EventKind m_toldAs = EventKind::Count;
  Instant m_linkChanged = kNotYet;
  Instant m_comparedFrom = kNotYet;  // what came before is not compared
  bool m_isUnheard = false;          // since then
  Instant m_heardFrom = kNotYet;     // the first time since then
  Pin m_formerPin;                   // before the gap
  Duration m_awaitedFor{0};          // so long behind the gap it is not missing; 0: it is not awaited
  Instant m_restarted = kNotYet;
  Instant m_silenceDue = kNever;     // it may be silent then; never: once it is heard again
  Instant m_permissiveDue = kNever;  // its permissive may have timed out then
  Instant m_retry = kNever;          // a change that came too fast may be told then

  // Of each report what was compared last. All ones: nothing, as a report begins with its type.
  std::array<std::uint64_t, kReports.size()> m_compared = noneCompared();
  Silence m_silence;
  // Of each of kOwnPeriodicReports: when it first and last came in a wrong length, with no right one since.
  struct WrongLength {
    Instant since = kNotYet, last = kNotYet;
    bool isTold = false;  // it came so for longer than a right one may be late
  };
  std::array<WrongLength, kOwnPeriodicReports.size()> m_wrongLengths;
  std::uint32_t m_malformedSeen = 0;  // of Device::malformed
  bool m_hasMalformed = false;        // one of m_wrongLengths has begun
  EventSlot m_lengths{0};
  TellCount m_restarts, m_moves;
  EventSlot m_rotationError{0}, m_elevationError{0}, m_operationalError{0};
  EventSlot m_deviceFaulted{0}, m_errorCode{0};
  std::array<EventSlot, 32> m_faults = noFaults();  // by bit of the fault map
  EventSlot m_enable{1}, m_operational{1};
  EventSlot m_remote, m_stowed, m_permissive;
  std::array<EventSlot, 5> m_plusStops, m_minusStops;
  std::array<EventSlot, 4> m_limits;  // left, right, down, up
};

}  // namespace deckpipe
