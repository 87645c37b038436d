// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/device_watch.h"

#include <algorithm>
#include <utility>

#include "protocol/akron.h"
#include "protocol/gateway.h"
#include "state/health.h"

namespace deckpipe {
namespace {

constexpr BitRange kRotation = fieldOf(akron::kPositionLimitStatusFields, "rotation_deg").bits;
constexpr BitRange kElevation = fieldOf(akron::kPositionLimitStatusFields, "elevation_deg").bits;
constexpr std::uint64_t kAngles = checks::bitSet(kRotation) | checks::bitSet(kElevation);

// Two positions with the same bits differ at most in where the monitor points. Whether there is an angle at all
// stands in place of the angle.
std::uint64_t statusBitsOf(const Payload& data) {
  std::uint64_t bits = loadLittle(data) & ~kAngles;
  if (readBits(data, kRotation) == kRotation.mask()) bits |= checks::bitSet(kRotation);
  if (readBits(data, kElevation) == kElevation.mask()) bits |= checks::bitSet(kElevation);
  return bits;
}

std::uint64_t bitsOf(MessageId id, const Payload& data) {
  return id == MessageId::PositionLimitStatus ? statusBitsOf(data) : loadLittle(data);
}

// The messages that say the same until something changes.
constexpr EnumArray<MessageId, bool> kIsRepeated = [] {
  EnumArray<MessageId, bool> is;
  for (const MessageId id : kOwnPeriodicReports) is[id] = true;
  return is;
}();

constexpr std::uint8_t kRotationAxis = 1, kElevationAxis = 2;

Event onAxis(Event event, std::size_t axis, bool isPlus) {
  event.axis = static_cast<std::uint8_t>(axis);
  event.isPlus = isPlus;
  return event;
}

// The time of the last message that it repeats; kNotYet if there was none.
Instant lastRepeated(const State& state, const Device& device) {
  Instant last = device.lastStatus;
  if (device.kind != Device::Kind::Node) {
    if (const Joystick* stick = state.channel(device.channel).joysticks.find(device.address))
      last = std::max({last, stick->basic.at, stick->extended.at});
  }
  return last;
}

// The same; of what repeats nothing, when it was heard.
Instant lastBeat(const State& state, const Device& device) {
  const Instant last = lastRepeated(state, device);
  return last == kNotYet ? device.lastHeard : last;
}

}  // namespace

bool DeviceWatch::isOf(const Device& device) const {
  if (device.kind == Device::Kind::Free || device.channel != m_channel) return false;
  switch (m_kind) {
    case Device::Kind::Free: return false;
    case Device::Kind::Pin: return device.kind == m_kind && device.pin == m_pin;
    case Device::Kind::Node: return device.kind == m_kind && device.node == m_node;
    // It may have said its PIN meanwhile.
    case Device::Kind::Address: return device.kind != Device::Kind::Node && device.address == m_address;
  }
  return false;
}

void DeviceWatch::begin(const Device& device, Instant now) {
  *this = {};
  m_kind = device.kind;
  m_channel = device.channel;
  m_address = device.address;
  m_hasAddress = device.address != kNullAddress;
  m_node = device.node;
  m_pin = device.pin;
  m_restarted = device.restarted;
  m_malformedSeen = device.malformed;
  m_silenceDue = now + kSilentAfter;
}

Event DeviceWatch::eventOf(const State& state) const {
  Event event = eventAt(state, m_channel, {}, m_kind == Device::Kind::Node ? kNullAddress : m_address);
  event.node = m_node;
  event.pin = m_pin;
  return event;
}

Event DeviceWatch::appeared(const State& state, Address former) {
  Event event = eventOf(state);
  event.kind = m_toldAs = EventKind::Appeared;
  if (former == kNullAddress || m_kind != Device::Kind::Address) return event;
  event.kind = m_toldAs = EventKind::MovedAddress;
  event.was = former.value;
  event.now = m_address.value;
  return event;
}

void DeviceWatch::linkChanged(Instant time) {
  m_linkChanged = time;
  if (!m_silence.isSilent()) m_silenceDue = time + kSilentAfter;
  m_permissiveDue = time;
}

// One that was not heard behind the gap before this one is the same matter still.
void DeviceWatch::expectBack(const State& state, const Device& device) {
  if (m_isUnheard) return;
  m_formerPin = m_pin;
  const bool repeats = isCompared(lastRepeated(state, device)) &&
                       (device.kind != Device::Kind::Node || device.hasPeriod()) && !m_silence.isSilent();
  m_awaitedFor = repeats ? device.silentAfter() : Duration{0};
}

void DeviceWatch::linkCameBack(const Device& device, Instant now) {
  const DeviceWatch before = std::exchange(*this, {});
  if (device.kind == Device::Kind::Free) return;
  begin(device, now);
  m_linkChanged = m_comparedFrom = now;
  m_isUnheard = true;
  m_formerPin = before.m_formerPin;
  m_awaitedFor = before.m_awaitedFor;
  if (before.m_silence.isNotBack()) m_silence = before.m_silence;
}

// Whatever comes of one that was not back shows that it is; under another PIN it is another one.
void DeviceWatch::heard(const State& state, const Device& device, std::vector<Event>& out) {
  if (m_silence.isNotBack()) {
    if (m_pin.isNull() || m_pin == m_formerPin) {
      m_silence.end(state.cursor().time);
      compareSilence(state, out);
    } else {
      m_silence = {};
    }
  } else if (m_silence.isSilent()) {
    if (lastBeat(state, device) <= m_silence.lastHeard() || healthOf(state, device).has(HealthCause::Silent))
      return;
    m_silence.end(state.cursor().time);
    compareSilence(state, out);
  }
  if (m_silenceDue == kNever) m_silenceDue = state.cursor().time + kSilentAfter;
}

// A status of a wrong length says nothing. Where no other one comes, what the device said before is old; where right
// ones come between, it is not.
void DeviceWatch::lookAtLengths(const State& state, const Device& device, MessageId id,
                                std::vector<Event>& out) {
  const Instant now = state.cursor().time;
  const bool isWrong = device.malformed != std::exchange(m_malformedSeen, device.malformed);
  const auto place = std::ranges::find(kOwnPeriodicReports, id);
  if (place == kOwnPeriodicReports.end()) return;
  WrongLength& wrong = m_wrongLengths[static_cast<std::size_t>(place - kOwnPeriodicReports.begin())];
  if (isWrong) {
    // One now and then is nothing that comes periodically.
    if (wrong.since == kNotYet || now - wrong.last > kSilentAfter) wrong.since = now;
    wrong.last = now;
    wrong.isTold = wrong.isTold || now - wrong.since >= device.staleAfter(id);
  } else if (device.report(id).at == now) {
    wrong = {};
  }
  m_hasMalformed =
      std::ranges::any_of(m_wrongLengths, [](const WrongLength& w) { return w.since != kNotYet; });
  compareLengths(state, out);
}

void DeviceWatch::compareLengths(const State& state, std::vector<Event>& out) {
  Instant since = kNotYet;
  for (const WrongLength& wrong : m_wrongLengths) {
    if (wrong.isTold && (since == kNotYet || wrong.since < since)) since = wrong.since;
  }
  Event event = eventOf(state);
  const bool isWrong = since != kNotYet;
  if (!m_lengths.moves(isWrong ? 1 : 0, event.time, m_retry)) return;
  event.kind = isWrong ? EventKind::Malformed : EventKind::MalformedOver;
  event.since = since;
  m_lengths.tell(event, out);
}

// Nothing can be heard while the link is down, which is told by itself.
void DeviceWatch::lookAtSilence(const State& state, const Device& device, std::vector<Event>& out) {
  const Instant now = state.cursor().time;
  const Duration after = m_isUnheard ? m_awaitedFor : device.silentAfter();
  const Instant due = std::max(lastBeat(state, device), m_linkChanged) + after;
  m_silenceDue = due > now ? due : kNever;
  if (m_silenceDue != kNever || state.channel(m_channel).link == ChannelLink::Down) return;
  if (m_isUnheard) {
    if (std::exchange(m_awaitedFor, Duration{0}) == Duration{0}) return;
    m_silence.begin(m_linkChanged, EventKind::NotBack);
    return compareSilence(state, out);
  }
  const Health health = healthOf(state, device);
  if (!health.has(HealthCause::Silent)) {
    // As long as another one sends from its address, its own silence cannot be told.
    if (health.has(HealthCause::TwoAtOneAddress)) m_silenceDue = now + kSilentAfter;
    return;
  }
  m_silence.begin(std::max(lastBeat(state, device), m_linkChanged));
  compareSilence(state, out);
}

void DeviceWatch::timeCame(const State& state, const Device& device, std::vector<Event>& out) {
  const Instant now = state.cursor().time;
  if (m_silenceDue <= now) lookAtSilence(state, device, out);
  if (m_permissiveDue <= now) {
    m_permissiveDue = kNever;
    if (isCompared(device.permissive().at)) comparePermissive(state, device, out);
  }
  if (m_retry > now) return;
  m_retry = kNever;
  m_compared = noneCompared();
  compareSilence(state, out);
  compareLengths(state, out);
  for (const MessageId id : kReports) {
    if (isCompared(device.report(id).at)) compare(state, device, id, out);
  }
  if (isCompared(device.operationalErrorCode.at)) compareFaults(state, device, out);
}

void DeviceWatch::lookAtIdentity(const State& state, const Device& device, std::vector<Event>& out) {
  m_kind = device.kind;
  m_pin = device.pin;
  if (device.kind != Device::Kind::Node) {
    const bool hasAddress = device.address != kNullAddress;
    Event event = eventOf(state);
    if (!hasAddress && m_hasAddress) {
      event.kind = EventKind::AddressLost;
      m_moves.happens(event, out);
    } else if (hasAddress && device.address != m_address) {
      event.kind = EventKind::MovedAddress;
      event.was = m_address.value;
      event.now = device.address.value;
      event.address = m_address = device.address;
      m_moves.happens(event, out);
    }
    m_hasAddress = hasAddress;
  }
  if (device.restarted != m_restarted) {
    m_restarted = device.restarted;
    Event event = eventOf(state);
    event.kind = EventKind::Restarted;
    m_restarts.happens(event, out);
  }
}

// Nearly every report says what the one before it said. A node that boots again and again says nothing else.
bool DeviceWatch::isAsCompared(const Device& device, MessageId id, const Payload& data) const {
  return kIsRepeated[id] && m_compared[kReportPlaces[id]] == bitsOf(id, data) &&
         device.restarted == m_restarted;
}

// A frame that the state did not take, as one of a wrong length, says nothing. Answers of nodes are no reports.
void DeviceWatch::compareNew(const State& state, const Device& device, MessageId id, const Payload& data,
                             std::vector<Event>& out) {
  if (id == MessageId::SdoReadResponse) return compareFaults(state, device, out);
  if (device.report(id).at != state.cursor().time) return;
  m_compared[kReportPlaces[id]] = bitsOf(id, data);
  compare(state, device, id, out);
}

void DeviceWatch::compare(const State& state, const Device& device, MessageId id, std::vector<Event>& out) {
  using Compare = void (DeviceWatch::*)(const State&, const Device&, std::vector<Event>&);
  constexpr Compare kNoEvents = nullptr;
  static constexpr KeyTable<kReports, Compare> kCompares{{
      {MessageId::PositionLimitStatus, &DeviceWatch::comparePosition},
      {MessageId::RotationSoftLimits, &DeviceWatch::compareRotationLimits},
      {MessageId::ElevationSoftLimits, &DeviceWatch::compareElevationLimits},
      {MessageId::DigitalOutputs, &DeviceWatch::compareOutputs},
      {MessageId::MiniDigitalOutputs, &DeviceWatch::compareMiniOutputs},
      {MessageId::DigitalInputs, kNoEvents},
      {MessageId::SoePermissive, &DeviceWatch::comparePermissive},
      {MessageId::FaultResponse, &DeviceWatch::compareFaults},
      {MessageId::FirmwareResponse, kNoEvents},
      {MessageId::PcodeResponse, kNoEvents},
      {MessageId::ConfigResponse, kNoEvents},
      {MessageId::Heartbeat, &DeviceWatch::compareHeartbeat},
  }};
  if (const Compare found = *kCompares.find(id); found != kNoEvents) (this->*found)(state, device, out);
}

void DeviceWatch::compareRotationLimits(const State& state, const Device& device, std::vector<Event>& out) {
  const Event event = eventOf(state);
  const SoftLimits limits = device.rotationLimits().value();
  if (limits.oscillating) return;  // then these are the oscillation's
  compareLimit(0, limits.low, onAxis(event, kRotationAxis, false), out);
  compareLimit(1, limits.high, onAxis(event, kRotationAxis, true), out);
}

void DeviceWatch::compareElevationLimits(const State& state, const Device& device, std::vector<Event>& out) {
  const Event event = eventOf(state);
  const SoftLimits limits = device.elevationLimits().value();
  compareLimit(2, limits.low, onAxis(event, kElevationAxis, false), out);
  compareLimit(3, limits.high, onAxis(event, kElevationAxis, true), out);
}

void DeviceWatch::compareOutputs(const State& state, const Device& device, std::vector<Event>& out) {
  const Event event = eventOf(state);
  const DigitalOutputs outputs = device.outputs().value();
  compareFlag(m_enable, outputs.enable, EventKind::Enabled, EventKind::Disabled, event, out);
  compareFlag(m_remote, outputs.remoteMode, EventKind::RemoteMode, EventKind::RemoteModeOver, event, out);
  compareFlag(m_stowed, outputs.stowed, EventKind::Stowed, EventKind::NotStowed, event, out);
}

void DeviceWatch::compareMiniOutputs(const State& state, const Device& device, std::vector<Event>& out) {
  compareFlag(m_deviceFaulted, device.miniOutputs().value().deviceFaulted, EventKind::DeviceFaulted,
              EventKind::DeviceFaultedOver, eventOf(state), out);
}

void DeviceWatch::compareHeartbeat(const State& state, const Device& device, std::vector<Event>& out) {
  const Event event = eventOf(state);
  lookAtIdentity(state, device, out);
  compareFlag(m_operational, device.heartbeat().value() == gateway::kOperational, EventKind::Operational,
              EventKind::NotOperational, event, out);
}

void DeviceWatch::comparePosition(const State& state, const Device& device, std::vector<Event>& out) {
  const PositionLimitStatus status = device.position().value();
  const Event event = eventOf(state);
  compareFlag(m_rotationError, status.rotation.state == PositionState::SensorError, EventKind::SensorError,
              EventKind::SensorErrorOver, onAxis(event, kRotationAxis, false), out);
  compareFlag(m_elevationError, status.elevation.state == PositionState::SensorError, EventKind::SensorError,
              EventKind::SensorErrorOver, onAxis(event, kElevationAxis, false), out);
  const bool hadError = m_operationalError.shown() != 0;
  compareFlag(m_operationalError, status.operationalError == Status2::On, EventKind::OperationalError,
              EventKind::OperationalErrorOver, event, out);
  // The code belongs to the error that is over: the next one is asked anew.
  if (hadError && m_operationalError.shown() == 0) m_errorCode.set(0);
  for (std::size_t axis = 0; axis < m_plusStops.size(); ++axis) {
    compareStop(m_plusStops[axis], status.plusStop[axis], onAxis(event, axis + 1, true), out);
    compareStop(m_minusStops[axis], status.minusStop[axis], onAxis(event, axis + 1, false), out);
  }
}

// A node answers for its error code apart from its faults.
void DeviceWatch::compareFaults(const State& state, const Device& device, std::vector<Event>& out) {
  Event event = eventOf(state);
  std::optional<std::uint16_t> code;
  if (isCompared(device.operationalErrorCode.at)) code = device.operationalErrorCode.value;
  if (const auto answer = device.faults(); isCompared(answer.at)) {
    const FaultStatus faults = answer.value();
    if (faults.pcodeError) code = faults.pcodeError;
    for (std::size_t bit = 0; bit < m_faults.size(); ++bit) {
      const std::uint64_t isRaised = faults.map >> bit & 1u;
      if (!m_faults[bit].moves(isRaised, event.time, m_retry)) continue;
      Event told = event;
      told.kind = isRaised != 0 ? EventKind::Fault : EventKind::FaultCleared;
      told.was = told.now = static_cast<std::int64_t>(bit);
      m_faults[bit].tell(told, out);
    }
  }
  if (!code || !m_errorCode.moves(*code, event.time, m_retry, EventSlot::First::Always)) return;
  event.kind = *code != 0 ? EventKind::ErrorCode : EventKind::ErrorCodeCleared;
  event.was = static_cast<std::int64_t>(m_errorCode.shown());
  event.now = *code;
  m_errorCode.tell(event, out);
}

void DeviceWatch::comparePermissive(const State& state, const Device& device, std::vector<Event>& out) {
  const bool isStale = device.isStale(MessageId::SoePermissive);
  const Permissive p = device.permissive().value();
  const bool any = p.axis1Plus || p.axis1Minus || p.axis2Plus || p.axis2Minus;
  m_permissiveDue = device.staleDue(MessageId::SoePermissive);
  compareFlag(m_permissive, any && !isStale, EventKind::PermissiveBack, EventKind::PermissiveLost,
              eventOf(state), out);
}

void DeviceWatch::compareFlag(EventSlot& slot, bool value, EventKind on, EventKind off, Event event,
                              std::vector<Event>& out) {
  if (!slot.moves(value ? 1 : 0, event.time, m_retry)) return;
  event.kind = value ? on : off;
  event.was = static_cast<std::int64_t>(slot.shown());
  event.now = value ? 1 : 0;
  if (kEvents[event.kind].detail == EventDetail::Code) {
    const auto code = static_cast<std::int64_t>(m_errorCode.shown());
    event.was = value ? 0 : code;
    event.now = value ? code : 0;
  }
  slot.tell(event, out);
}

// Not available is neither reached nor left. A stop that reports an error at first is told, one that is reached is not.
void DeviceWatch::compareStop(EventSlot& slot, Status2 value, Event event, std::vector<Event>& out) {
  if (value == Status2::NotAvailable) return;
  if (!slot.isKnown() && value == Status2::Error) slot = EventSlot(static_cast<std::uint64_t>(Status2::Off));
  if (!slot.moves(static_cast<std::uint64_t>(value), event.time, m_retry, EventSlot::First::Always)) return;
  event.kind = value == Status2::On      ? EventKind::StopReached
               : value == Status2::Error ? EventKind::StopError
                                         : EventKind::StopLeft;
  event.was = static_cast<std::int64_t>(slot.shown());
  event.now = static_cast<std::int64_t>(value);
  slot.tell(event, out);
}

void DeviceWatch::compareLimit(std::size_t which, std::int16_t value, Event event, std::vector<Event>& out) {
  EventSlot& slot = m_limits[which];
  if (!slot.moves(static_cast<std::uint16_t>(value), event.time, m_retry)) return;
  event.kind = EventKind::SoftLimitChanged;
  event.was = static_cast<std::int16_t>(slot.shown());
  event.now = value;
  slot.tell(event, out);
  if (event.was == event.now) out.pop_back();
}

}  // namespace deckpipe
