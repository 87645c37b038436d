// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/motion_watch.h"

#include <algorithm>

#include "bus/j1939.h"
#include "protocol/device_types.h"
#include "protocol/lists.h"
#include "protocol/name.h"

namespace deckpipe {
namespace {

// In the order of the axes of PositionLimitStatus.
constexpr std::size_t kRotation = 0, kElevation = 1;

bool saysWhatMonitorsDo(const Device& device) {
  return device.position().isKnown() || device.outputs().isKnown() || device.rotationLimits().isKnown() ||
         device.elevationLimits().isKnown();
}

bool mayBeMonitor(const Device& device) {
  if (saysWhatMonitorsDo(device)) return true;
  if (device.kind != Device::Kind::Pin) return false;
  return deviceTypeOf(device.pin.deviceType()) == nullptr ||
         isOfUse(device.pin.deviceType(), DeviceUse::Monitor);
}

bool isDoubled(const Device& device, Instant now) {
  return device.doubled != kNotYet && now - device.doubled < kDoubledFor;
}

int signOf(int value) { return (value > 0) - (value < 0); }

}  // namespace

std::vector<const Device*> monitorsHeard(const State& state, Channel channel) {
  std::vector<const Device*> found;
  for (const Device& device : state.devices().all()) {
    if (device.kind != Device::Kind::Free && device.channel == channel && mayBeMonitor(device))
      found.push_back(&device);
  }
  return found;
}

std::vector<MotionWatch::Controller> MotionWatch::controllers(const Live& live) {
  std::vector<Controller> all;
  for (const Device& device : live.state.devices().all()) {
    if (device.kind == Device::Kind::Free || device.channel != live.channel) continue;
    DeviceKey key = DeviceKey::of(device.pin, device.channel);
    if (device.kind == Device::Kind::Address) key = DeviceKey::at(device.channel, device.address);
    if (device.kind == Device::Kind::Node) key = DeviceKey::at(device.channel, device.node);
    all.push_back({key, device.address});
  }
  return all;
}

MotionWatch::Bits MotionWatch::bitsOf(const Device& device) {
  Bits bits;
  if (device.isKnownNow(MessageId::DigitalOutputs)) {
    const DigitalOutputs outputs = device.outputs().value();
    bits.isEnabled = outputs.enable;
    bits.isStowed = outputs.stowed;
  }
  if (device.isKnownNow(MessageId::PositionLimitStatus))
    bits.operationalError = device.position().value().operationalError;
  return bits;
}

Refusal MotionWatch::arm(Instant now, const Live& live, Address source, const std::vector<Pin>& moves) {
  m_source = source;
  m_monitors.clear();
  const std::vector<const Device*> heard = monitorsHeard(live.state, live.channel);
  for (const Pin& pin : moves) {
    const Device* device = find(live, pin);
    const Refusal why = live.whyNotTo(now, DeviceKey::of(pin, live.channel));
    if (why != Refusal::None) return why;
    if (std::ranges::count(heard, device) == 0) return Refusal::NotTaken;
    if (isDoubled(*device, now)) return Refusal::OtherMonitors;
    if (std::ranges::count(m_monitors, pin, &Monitor::pin) == 0) m_monitors.push_back({pin, {}, {}});
  }
  if (m_monitors.empty() || m_monitors.size() != heard.size()) return Refusal::OtherMonitors;
  m_controllers = controllers(live);
  m_newcomer = m_stowAsked = false;
  return Refusal::None;
}

MotionCause MotionWatch::press(Instant now, const Live& live) {
  for (Monitor& monitor : m_monitors) {
    const Device* device = find(live, monitor.pin);
    if (device == nullptr) return MotionCause::MonitorGone;
    monitor.atPress = bitsOf(*device);
    monitor.moves = {};
  }
  m_stowAsked = false;
  return whyNotHeld(now, live, {}, {});
}

void MotionWatch::heard(const Live& live, const Frame& frame) {
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn == pgn::kAddressClaimed && frame.length == 8) {
    const Device* device = live.find(DeviceKey::at(live.channel, id.source));
    const bool isKnown = device != nullptr && isNameOf(Name::of(frame), device->pin);
    m_newcomer = m_newcomer || (Name::of(frame).isAkron() && !isKnown);
  } else if (id.pgn == pgn::kBasicJoystick && frame.length == 8) {
    constexpr std::size_t kDeploy = 8 - 1, kStow = 9 - 1;
    const auto& switches = BasicJoystick::of(frame).switches;
    m_stowAsked = m_stowAsked || switches[kDeploy] == Status2::On || switches[kStow] == Status2::On;
  } else if (id.pgn == pgn::kProprietaryA && hasTypeOf(frame, MessageId::DigitalInputs) &&
             allows(messageOf(MessageId::DigitalInputs).lengths, frame.length)) {
    const DigitalInputs inputs = DigitalInputs::of(frame);
    m_stowAsked = m_stowAsked || inputs.deploy || inputs.stow;
  }
}

MotionCause MotionWatch::whyNotArmed(Instant now, const Live& live) const {
  if (m_newcomer || controllers(live) != m_controllers) return MotionCause::ControllerAppeared;
  for (const Monitor& monitor : m_monitors) {
    const Refusal why = live.whyNotTo(now, DeviceKey::of(monitor.pin, live.channel));
    if (why != Refusal::None) return MotionCause::MonitorGone;
    if (isDoubled(*find(live, monitor.pin), now)) return MotionCause::ControllerAppeared;
  }
  return MotionCause::None;
}

MotionCause MotionWatch::whyNotHeld(Instant now, const Live& live, Deflection x, Deflection y) {
  if (m_stowAsked) return MotionCause::StowAsked;
  const auto hasChanged = [](const auto& before, const auto& after) {
    return before && after && *before != *after;
  };
  for (Monitor& monitor : m_monitors) {
    const Device* device = find(live, monitor.pin);
    if (device == nullptr) return MotionCause::MonitorGone;
    const Bits bits = bitsOf(*device);
    if (bits.isEnabled == false) return MotionCause::EnableOff;
    if (hasChanged(monitor.atPress.isEnabled, bits.isEnabled) ||
        hasChanged(monitor.atPress.isStowed, bits.isStowed) ||
        hasChanged(monitor.atPress.operationalError, bits.operationalError))
      return MotionCause::MonitorChanged;
    // Forward is down.
    const std::array commands{x.tenths(), -y.tenths()};
    for (std::size_t axis : {kRotation, kElevation}) {
      const MotionCause cause = followMove(now, live, *device, monitor.moves[axis], axis, commands[axis]);
      if (cause != MotionCause::None) return cause;
    }
  }
  return MotionCause::None;
}

MotionCause MotionWatch::followMove(Instant now, const Live& live, const Device& device, FirstMove& move,
                                    std::size_t axis, int command) const {
  const bool isSeen =
      device.isKnownNow(MessageId::PositionLimitStatus) && !device.isStale(MessageId::PositionLimitStatus);
  if (move.isDone || !isSeen) return MotionCause::None;
  const PositionLimitStatus position = device.position().value();
  const PositionReading& reading = axis == kRotation ? position.rotation : position.elevation;
  if (reading.state != PositionState::Ok) {
    move = {};
    return MotionCause::None;
  }
  if (signOf(command) != move.direction || !move.from) {
    move = {.direction = signOf(command), .from = reading.tenths, .since = now};
    return MotionCause::None;
  }
  const int moved = (reading.tenths - *move.from) * move.direction;
  if (moved < -kWrongWay) return MotionCause::WrongWay;
  move.isDone = moved >= kMoved;
  if (command * move.direction < kStrongCommand) move.since = now;
  const bool stands = !move.isDone && move.direction != 0 && now - move.since >= kMovesWithin;
  return stands ? whyNoMotion(live, device, axis, move.direction) : MotionCause::None;
}

MotionCause MotionWatch::whyNoMotion(const Live& live, const Device& device, std::size_t axis,
                                     int direction) const {
  const PositionLimitStatus position = device.position().value();
  const auto& stops = direction > 0 ? position.plusStop : position.minusStop;
  if (stops[axis] == Status2::On) return MotionCause::AtStop;
  const PositionReading& reading = axis == kRotation ? position.rotation : position.elevation;
  const MessageId limitsId =
      axis == kRotation ? MessageId::RotationSoftLimits : MessageId::ElevationSoftLimits;
  if (device.isKnownNow(limitsId)) {
    const Frame frame = device.report(limitsId).frame();
    const SoftLimits limits =
        axis == kRotation ? SoftLimits::ofRotation(frame) : SoftLimits::ofElevation(frame);
    const int beyond = direction > 0 ? reading.tenths - limits.high : limits.low - reading.tenths;
    if (beyond > -kMoved) return MotionCause::AtSoftLimit;
  }
  const bool isOutranked = std::ranges::any_of(live.bus().joysticks.all(), [&](const Joystick& stick) {
    if (!stick.isActive() || !stick.priority() || stick.source >= m_source) return false;
    const BasicJoystick asked = stick.basic.value();
    return (axis == kRotation ? asked.x : asked.y).tenths.value_or(0) != 0;
  });
  if (isOutranked) return MotionCause::Outranked;
  if (device.isKnownNow(MessageId::DigitalOutputs) && device.outputs().value().soeMode) {
    const Permissive given = device.permissive().isKnown() && !device.isStale(MessageId::SoePermissive)
                                 ? device.permissive().value()
                                 : Permissive{};
    const bool isGiven = axis == kRotation ? (direction > 0 ? given.axis1Plus : given.axis1Minus)
                                           : (direction > 0 ? given.axis2Plus : given.axis2Minus);
    if (!isGiven) return MotionCause::NoPermissive;
  }
  return MotionCause::NoMotion;
}

}  // namespace deckpipe
