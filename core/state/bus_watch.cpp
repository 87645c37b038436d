// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/bus_watch.h"

#include <algorithm>
#include <utility>

#include "bus/load.h"
#include "state/health.h"

namespace deckpipe {
namespace {

// More NAMEs without an address than a bus has addresses are not told apart.
constexpr std::size_t kMaxNames = 256;
// So often it is looked whether two devices still share an address.
constexpr Duration kSharedAgain = 1s;

// What a controller is told as: the last one that speaks of its errors.
EventKind kindOf(ControllerState state) {
  switch (state) {
    case ControllerState::BusOff: return EventKind::BusOff;
    case ControllerState::ErrorPassive: return EventKind::ErrorPassive;
    case ControllerState::Unknown:
    case ControllerState::ErrorActive:
    case ControllerState::ErrorWarning:
    case ControllerState::Stopped:
    case ControllerState::Sleeping: break;
  }
  return EventKind::ErrorActive;
}

}  // namespace

void BusWatch::beginSecond(const State& state) {
  const Instant now = state.cursor().time;
  if (m_first == kNotYet) m_first = now;
  m_secondEnd = now + 1s;
  m_bits = state.channel(m_channel).bits;
}

void BusWatch::errorCame(const State& state, std::vector<Event>& out) {
  m_burstEnd = state.cursor().time + kErrorPause;
  ++m_errors;
  compareErrors(state, out);
  compareController(state, out);
}

void BusWatch::linkChanged(const State& state) {
  m_isFaster = false;
  m_controller.set(static_cast<std::uint64_t>(kindOf(state.channel(m_channel).controller)));
  for (StickWatch& stick : m_sticks) {
    stick.linkChanged(state.cursor().time);
    m_sticksDue = std::min(m_sticksDue, stick.due());
  }
}

void BusWatch::linkCameBack(std::span<const DeviceWatch> devices) {
  m_isBehindGap = true;
  for (KnownPin& known : m_knownPins) known.isBack = false;
  m_wereNameless.reset();
  for (const DeviceWatch& device : devices) {
    if (!device.isUsed() || device.channel() != m_channel) continue;
    if (device.pin().isNull()) {
      if (device.address() != kNullAddress) m_wereNameless.set(device.address().value);
      continue;
    }
    const KnownPin now{device.pin(), device.lastAddress(), false, device.address() == kNullAddress};
    const auto known = std::ranges::find(m_knownPins, device.pin(), &KnownPin::pin);
    if (known != m_knownPins.end()) {
      *known = now;
    } else if (m_knownPins.size() < kMaxNames) {
      m_knownPins.push_back(now);
    }
  }
  for (const KnownPin& known : m_knownPins) {
    if (!known.hasLost) m_wereNameless.reset(known.address.value);
  }
  m_first = kNotYet;
  m_secondEnd = m_sharedDue = m_contestsDue = kNever;
  m_holders = m_formerHolders = {};
  m_claims = {};
  m_cannotClaim.clear();
  m_shared.reset();
  m_strangerSince = neverHeard<256>();
  m_nodeSince = neverHeard<128>();
  for (StickWatch& stick : m_sticks) stick.linkCameBack();
  m_sticksDue = kNever;
}

// One that had no PIN before may be the one that says its PIN now: at its address, or at any one if it was there at once.
void BusWatch::pinCame(const State& state, const Device& device, Instant since, EventKind toldAs,
                       std::vector<Event>& out) {
  if (!m_isBehindGap || device.pin.isNull() || device.address == kNullAddress) return;
  Event event = eventAt(state, m_channel, EventKind::Appeared, device.address);
  event.pin = device.pin;
  const auto known = std::ranges::find(m_knownPins, device.pin, &KnownPin::pin);
  if (known == m_knownPins.end()) {
    if (m_knownPins.size() >= kMaxNames) return;
    m_knownPins.push_back({device.pin, device.address, true});
    const bool isNew = m_wereNameless.none() || (since != kNotYet && isSettled(since));
    if (isNew && toldAs == EventKind::Count && !m_wereNameless[device.address.value]) out.push_back(event);
    return;
  }
  const Address before = known->address;
  if (std::exchange(known->isBack, true)) return;
  if (before == kNullAddress || before == device.address || toldAs == EventKind::MovedAddress) return;
  event.kind = EventKind::MovedAddress;
  event.was = before.value;
  event.now = device.address.value;
  out.push_back(event);
}

Address BusWatch::formerAddress(Address address, Instant now) const {
  const Name name = m_holders[address.value];
  if (!name.isAkron()) return kNullAddress;
  for (const auto* names : {&m_formerHolders, &m_holders}) {
    for (std::size_t a = 0; a < kNullAddress.value; ++a) {
      if ((*names)[a] != name || a == address.value) continue;
      if (names == &m_formerHolders || now - m_heldSince[a] >= kClaimTime)
        return {static_cast<std::uint8_t>(a)};
    }
  }
  return kNullAddress;
}

void BusWatch::compareErrors(const State& state, std::vector<Event>& out) {
  const bool isBurst = m_burstEnd != kNever;
  if (!m_burst.moves(isBurst ? 1 : 0, state.cursor().time, m_retry)) return;
  Event event = eventAt(state, m_channel, isBurst ? EventKind::ErrorFrames : EventKind::ErrorFramesOver);
  if (!isBurst) event.now = static_cast<std::int64_t>(std::exchange(m_errors, 0u));
  m_burst.tell(event, out);
}

void BusWatch::compareController(const State& state, std::vector<Event>& out) {
  const EventKind kind = kindOf(state.channel(m_channel).controller);
  if (!m_controller.moves(static_cast<std::uint64_t>(kind), state.cursor().time, m_retry,
                          EventSlot::First::Always))
    return;
  m_controller.tell(eventAt(state, m_channel, kind), out);
}

void BusWatch::lookAtHolders(const State& state, std::span<DeviceWatch> devices, std::vector<Event>& out) {
  const AddressBook& book = state.channel(m_channel).book;
  m_contestsDue = book.nextDecision();
  m_sharedDue = std::min(m_sharedDue, state.cursor().time + kClaimTime);
  for (std::size_t a = 0; a < kNullAddress.value; ++a) {
    const Address address{static_cast<std::uint8_t>(a)};
    const Name holder = book.holder(address);
    const Name before = std::exchange(m_holders[a], holder);
    if (holder == before) continue;
    std::erase(m_cannotClaim, holder);
    m_strangerSince[a] = kNotYet;
    Event event = eventAt(state, m_channel, EventKind::AddressLost, address);
    const Instant since = std::exchange(m_heldSince[a], event.time);
    // Who claims an address and gives way within the time for that never had it.
    if (before.isNull() || event.time - since < kClaimTime) continue;
    std::ranges::replace(m_formerHolders, before, Name{});
    m_formerHolders[a] = before;
    if (holder.isNull()) continue;
    bool isTold = false;
    for (DeviceWatch& device : devices) {
      if (!device.isUsed() || device.channel() != m_channel) continue;
      const bool isLoser = !device.pin().isNull() && isNameOf(before, device.pin());
      if (isLoser) event.pin = device.pin();
      if (device.address() != address) isTold = isTold || isLoser;
      if (device.address() == address && (isLoser || device.pin().isNull())) device.addressWasTaken();
    }
    event.was = static_cast<std::int64_t>(before.value);
    event.now = static_cast<std::int64_t>(holder.value);
    if (!isTold) m_losses[a].happens(event, out);
  }
}

// Asked again and again, it says so again: that is told once.
void BusWatch::cannotClaim(const State& state, Name name, std::span<DeviceWatch> devices,
                           std::vector<Event>& out) {
  if (name.isNull() || m_cannotClaim.size() >= kMaxNames) return;
  if (std::ranges::find(m_cannotClaim, name) != m_cannotClaim.end()) return;
  m_cannotClaim.push_back(name);
  Event event = eventAt(state, m_channel, EventKind::CannotClaim);
  event.was = static_cast<std::int64_t>(name.value);
  const auto holder = std::ranges::find(m_holders, name);
  if (holder != m_holders.end()) event.address = {static_cast<std::uint8_t>(holder - m_holders.begin())};
  for (DeviceWatch& device : devices) {
    if (!device.isUsed() || device.channel() != m_channel) continue;
    const bool hadIt = event.address != kNullAddress && device.address() == event.address;
    if (hadIt || (!device.pin().isNull() && isNameOf(name, device.pin()))) event.pin = device.pin();
    if (hadIt) device.addressWasTaken();
  }
  out.push_back(event);
}

void BusWatch::claimed(Address address, Name name) {
  auto& [last, before] = m_claims[address.value];
  if (name.isNull() || name == last) return;
  before = std::exchange(last, name);
}

void BusWatch::nameParties(Event& lost, const Pin& pin) const {
  for (const Name name : m_claims[lost.address.value]) {
    if (name.isNull()) continue;
    if (isNameOf(name, lost.pin)) lost.was = static_cast<std::int64_t>(name.value);
    if (isNameOf(name, pin)) lost.now = static_cast<std::int64_t>(name.value);
  }
}

void BusWatch::lookAtShared(const State& state, std::vector<Event>& out) {
  std::bitset<256> shared;
  for (const Device& device : state.devices().all()) {
    if (device.kind == Device::Kind::Free || device.channel != m_channel) continue;
    const Address address = sharedAddressOf(state, device);
    if (address != kNullAddress) shared.set(address.value);
  }
  const Instant now = state.cursor().time;
  if (m_sharedDue <= now) m_sharedDue = kNever;
  if (shared.any()) m_sharedDue = std::min(m_sharedDue, now + kSharedAgain);
  for (std::size_t a = 0; a < shared.size(); ++a) {
    if (shared[a] == m_shared[a]) continue;
    const Address address{static_cast<std::uint8_t>(a)};
    Event event = eventAt(state, m_channel,
                          shared[a] ? EventKind::TwoAtOneAddress : EventKind::TwoAtOneAddressOver, address);
    if (const Device* device = state.devices().byAddress(m_channel, address)) event.pin = device->pin;
    for (const Device& device : state.devices().all()) {
      if (device.kind != Device::Kind::Pin || device.channel != m_channel || device.pin == event.pin)
        continue;
      if (device.address == kNullAddress && device.previousAddress() == address) event.other = device.pin;
    }
    out.push_back(event);
  }
  m_shared = shared;
}

Instant BusWatch::heardSince(const Device& device, Instant now) const {
  const bool isNode = device.kind == Device::Kind::Node;
  const Instant since =
      isNode ? m_nodeSince[device.node.value & 0x7F] : m_strangerSince[device.address.value];
  return since == kNotYet ? now : since;
}

bool BusWatch::stickCame(const State& state, Address source, std::vector<Event>& out) {
  const auto sticks = state.channel(m_channel).joysticks.all();
  for (std::size_t i = 0; i < sticks.size(); ++i) {
    if (sticks[i].source != source) continue;
    // The state took none: controllers take no input from a message of a wrong length.
    if (sticks[i].basic.at != state.cursor().time) {
      m_sticks[i].malformedCame(state, m_channel, sticks[i], out);
      m_sticksDue = std::min(m_sticksDue, m_sticks[i].due());
      return false;
    }
    const bool isBack = m_sticks[i].look(state, m_channel, sticks[i], isSettled(state.cursor().time), out);
    m_sticksDue = std::min(m_sticksDue, m_sticks[i].due());
    return isBack;
  }
  return false;
}

// Full seconds are judged, where the log says the rate, or an Akron device speaks J1939: then one is assumed.
void BusWatch::judgeLoad(const State& state, std::vector<Event>& out) {
  const std::uint64_t bits = state.channel(m_channel).bits;
  const std::uint64_t carried = bits - std::exchange(m_bits, bits);
  m_secondEnd = carried > 0 ? state.cursor().time + 1s : kNever;
  m_percentBefore = m_percent;
  const std::uint32_t bitRate = state.channel(m_channel).bitRate;
  m_percent = static_cast<std::int64_t>(carried * 100 / (bitRate != 0 ? bitRate : kAssumedBitRate));
  if (bitRate == 0 && m_percent > kFaster) m_isFaster = true;
  compareLoad(state, out);
}

void BusWatch::compareLoad(const State& state, std::vector<Event>& out) {
  const bool isAkron = std::ranges::any_of(state.devices().all(), [this](const Device& d) {
    return (d.kind == Device::Kind::Pin || d.kind == Device::Kind::Address) && d.channel == m_channel;
  });
  // Nor is a second of which the stamps say no more than that it was about then.
  if (m_isFaster || state.slack() > Duration{0}) return m_load.set(0);
  const bool wasHigh = m_load.shown() != 0;
  const std::uint32_t bitRate = state.channel(m_channel).bitRate;
  const bool isHigh = (isAkron || bitRate != 0) && m_percent >= (wasHigh ? kNormal : kHigh);
  if (!m_load.moves(isHigh ? 1 : 0, state.cursor().time, m_retry)) return;
  Event event = eventAt(state, m_channel, isHigh ? EventKind::LoadHigh : EventKind::LoadNormal);
  event.was = m_percentBefore;
  event.now = m_percent;
  event.bitRate = bitRate != 0 ? bitRate : kAssumedBitRate;
  event.isRateAssumed = bitRate == 0;
  m_load.tell(event, out);
}

void BusWatch::timeCame(const State& state, std::vector<Event>& out) {
  const Instant now = state.cursor().time;
  if (m_burstEnd <= now) {
    m_burstEnd = kNever;
    compareErrors(state, out);
  }
  if (m_sharedDue <= now) lookAtShared(state, out);
  if (m_sticksDue <= now) {
    m_sticksDue = kNever;
    const auto sticks = state.channel(m_channel).joysticks.all();
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      m_sticks[i].timeCame(state, m_channel, sticks[i], out);
      m_sticksDue = std::min(m_sticksDue, m_sticks[i].due());
    }
  }
  if (m_secondEnd <= now) judgeLoad(state, out);
  if (m_retry > now) return;
  m_retry = kNever;
  compareErrors(state, out);
  compareController(state, out);
  compareLoad(state, out);
}

// A joystick's messages have events of their own.
void NodeWatch::timeCame(const State& state, std::vector<Event>& out) {
  const ChannelState& channel = state.channel(m_channel);
  const Instant now = state.cursor().time;
  if (m_due > now) return;
  m_due = kNever;
  if (channel.link == ChannelLink::Down) return;
  for (std::size_t a = 0; a < kNullAddress.value; ++a) {
    const Address address{static_cast<std::uint8_t>(a)};
    const Node node = channel.nodes[address];
    if (node.isSteady && !m_silences[a].isSilent() &&
        state.devices().byAddress(m_channel, address) == nullptr &&
        channel.joysticks.find(address) == nullptr) {
      const Instant due = std::max(node.lastHeard, m_linkChanged) + silentAfter(node.period);
      if (due > now) {
        m_due = std::min(m_due, due);
      } else if (channel.isBeforeGap(node.lastHeard)) {
        if (!channel.wereOwn[a]) m_silences[a].begin(m_linkChanged, EventKind::NotBack);
      } else if (healthOf(state, m_channel, address).has(HealthCause::Silent)) {
        m_silences[a].begin(std::max(node.lastHeard, m_linkChanged));
      }
    }
    if (m_silences[a].lastHeard() != kNotYet) compare(state, address, out);
  }
}

}  // namespace deckpipe
