// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_health.h"

#include <QCoreApplication>
#include <algorithm>

namespace deckpipe {
namespace {

struct Health {
  Q_DECLARE_TR_FUNCTIONS(Health)
};

HealthLevel levelOf(HealthReason reason) {
  if (reason == HealthReason::NothingHeard) return HealthLevel::Silent;
  if (reason == HealthReason::NothingDue) return HealthLevel::Quiet;
  return reason <= HealthReason::DeviceFaulted ? HealthLevel::Fault : HealthLevel::Attend;
}

// The reason that stands for the silence of each status.
constexpr KeyTable<kOwnPeriodicReports, HealthReason> kOverdue{{
    {MessageId::PositionLimitStatus, HealthReason::PositionOverdue},
    {MessageId::RotationSoftLimits, HealthReason::LimitsOverdue},
    {MessageId::ElevationSoftLimits, HealthReason::LimitsOverdue},
    {MessageId::DigitalOutputs, HealthReason::OutputsOverdue},
    {MessageId::MiniDigitalOutputs, HealthReason::OutputsOverdue},
    {MessageId::DigitalInputs, HealthReason::InputsOverdue},
    {MessageId::Heartbeat, HealthReason::HeartbeatOverdue},
}};

class Finder {
 public:
  void add(HealthReason reason, bool holds) {
    if (!holds) return;
    m_health.reasons.add(reason);
    // Reasons come in order of gravity: the first decides.
    if (m_health.level == HealthLevel::Fine) m_health.level = levelOf(reason);
  }
  // `isDue`: whether the protocol lets expect that it goes on sending.
  void addSilence(Instant lastHeard, Instant now, bool isDue) {
    const bool isSilent = lastHeard == kNotYet || now - lastHeard >= kSilentAfter;
    add(isDue ? HealthReason::NothingHeard : HealthReason::NothingDue, isSilent);
  }
  void addJoystick(const ChannelState& channel, Address address) {
    const Joystick* stick = channel.joysticks.find(address);
    add(HealthReason::JoystickOverdue, stick != nullptr && stick->timedOut);
  }
  void addClaim(ClaimState claim) {
    add(HealthReason::AddressContested, claim == ClaimState::Contested);
    add(HealthReason::CannotClaim, claim == ClaimState::CannotClaim);
  }
  const DeviceHealth& health() const { return m_health; }

 private:
  DeviceHealth m_health;
};

// Whether something of the device comes by itself, at a period that the manual gives. Controls have to send
// joystick messages, but from an address of 33 to 38 hex that no message ties to their PIN.
bool sendsByItself(const ChannelState& channel, const Device& d) {
  for (const MessageId id : kOwnPeriodicReports) {
    if (d.report(id).isKnown()) return true;
  }
  if (d.kind == Device::Kind::Node) return false;
  if (channel.joysticks.find(d.address) != nullptr) return true;
  const unsigned type = d.kind == Device::Kind::Pin ? d.pin.deviceType() : 0;
  return type == 1032 || type == 1033 || type == 1040 || type == 1042 || type == 1052;
}

bool hasStopError(const PositionLimitStatus& position) {
  return std::ranges::count(position.plusStop, Status2::Error) +
             std::ranges::count(position.minusStop, Status2::Error) >
         0;
}

}  // namespace

DeviceHealth healthOf(const State& state, const Device& d) {
  const ChannelState& channel = state.channel(d.channel);
  // A status counts as long as it is fresh; an answer to a poll as long as there is no later one.
  const bool hasPosition = d.position().isKnown() && !d.isStale(MessageId::PositionLimitStatus);
  const PositionLimitStatus position = d.position().value();
  Finder f;
  const bool isDue = sendsByItself(channel, d);
  if (isDue) f.addSilence(d.lastHeard, state.cursor().time, true);
  f.add(HealthReason::FaultBits, d.faults().isKnown() && d.faults().value().map != 0);
  f.add(HealthReason::PcodeError,
        (d.faults().isKnown() && d.faults().value().pcodeError.value_or(0) != 0) ||
            (d.operationalErrorCode.isKnown() && d.operationalErrorCode.value != 0));
  f.add(HealthReason::RotationSensor, hasPosition && position.rotation.state == PositionState::SensorError);
  f.add(HealthReason::ElevationSensor, hasPosition && position.elevation.state == PositionState::SensorError);
  f.add(HealthReason::DeviceFaulted, d.miniOutputs().isKnown() && !d.isStale(MessageId::MiniDigitalOutputs) &&
                                         d.miniOutputs().value().deviceFaulted);
  f.add(HealthReason::OperationalError, hasPosition && position.operationalError == Status2::On);
  f.add(HealthReason::StopError, hasPosition && hasStopError(position));
  f.add(HealthReason::PositionInvalid, hasPosition && (position.rotation.state == PositionState::Invalid ||
                                                       position.elevation.state == PositionState::Invalid));
  for (const MessageId id : kOwnPeriodicReports) f.add(*kOverdue.find(id), d.isStale(id));
  f.add(HealthReason::NotOperational,
        d.heartbeat().isKnown() && d.heartbeat().value() != gateway::kOperational);
  if (d.kind != Device::Kind::Node) {
    const bool hasAddress = d.address != kNullAddress;
    if (hasAddress) f.addJoystick(channel, d.address);
    f.add(HealthReason::AddressLost, !hasAddress);
    if (hasAddress) f.addClaim(channel.book.claim(d.address, state.cursor().time));
  }
  f.add(HealthReason::Malformed, d.malformed != 0);
  if (!isDue) f.addSilence(d.lastHeard, state.cursor().time, false);
  return f.health();
}

DeviceHealth healthOf(const State& state, Channel channelId, Address address) {
  const ChannelState& channel = state.channel(channelId);
  const Node node = channel.nodes[address];
  Finder f;
  const bool isDue = channel.joysticks.find(address) != nullptr;
  if (isDue) f.addSilence(node.lastHeard, state.cursor().time, true);
  f.addJoystick(channel, address);
  f.addClaim(channel.book.claim(address, state.cursor().time));
  f.add(HealthReason::Malformed, node.malformed != 0);
  if (!isDue) f.addSilence(node.lastHeard, state.cursor().time, false);
  return f.health();
}

QString healthWord(HealthLevel level) {
  switch (level) {
    case HealthLevel::Fine: return Health::tr("fine");
    case HealthLevel::Quiet: return Health::tr("quiet");
    case HealthLevel::Attend: return Health::tr("attend");
    case HealthLevel::Fault: return Health::tr("fault");
    case HealthLevel::Silent: return Health::tr("silent");
  }
  return {};
}

QStringList healthReasons(const DeviceHealth& health) {
  static constexpr EnumTable<HealthReason, const char*> kTexts{{
      {HealthReason::NothingHeard, QT_TRANSLATE_NOOP("Health", "Nothing heard for some time.")},
      {HealthReason::FaultBits, QT_TRANSLATE_NOOP("Health", "It answered that fault bits are set.")},
      {HealthReason::PcodeError, QT_TRANSLATE_NOOP("Health", "It answered with an error code.")},
      {HealthReason::RotationSensor, QT_TRANSLATE_NOOP("Health", "Rotation sensor error.")},
      {HealthReason::ElevationSensor, QT_TRANSLATE_NOOP("Health", "Elevation sensor error.")},
      {HealthReason::DeviceFaulted, QT_TRANSLATE_NOOP("Health", "It says that it is faulted.")},
      {HealthReason::OperationalError,
       QT_TRANSLATE_NOOP("Health", "It reports an operational error; ask for its faults.")},
      {HealthReason::StopError, QT_TRANSLATE_NOOP("Health", "A hard stop reports an error.")},
      {HealthReason::PositionInvalid, QT_TRANSLATE_NOOP("Health", "Its position is not valid.")},
      {HealthReason::PositionOverdue, QT_TRANSLATE_NOOP("Health", "Its position status is overdue.")},
      {HealthReason::LimitsOverdue, QT_TRANSLATE_NOOP("Health", "Its soft limits are overdue.")},
      {HealthReason::OutputsOverdue, QT_TRANSLATE_NOOP("Health", "Its outputs are overdue.")},
      {HealthReason::InputsOverdue, QT_TRANSLATE_NOOP("Health", "Its inputs are overdue.")},
      {HealthReason::HeartbeatOverdue, QT_TRANSLATE_NOOP("Health", "Its heartbeat is overdue.")},
      {HealthReason::NotOperational, QT_TRANSLATE_NOOP("Health", "It is not operational (NMT).")},
      {HealthReason::JoystickOverdue, QT_TRANSLATE_NOOP("Health", "It stopped sending joystick messages.")},
      {HealthReason::AddressLost,
       QT_TRANSLATE_NOOP("Health", "It lost its address and has announced no other.")},
      {HealthReason::AddressContested, QT_TRANSLATE_NOOP("Health", "Another NAME claims its address too.")},
      {HealthReason::CannotClaim, QT_TRANSLATE_NOOP("Health", "It could not claim an address.")},
      {HealthReason::Malformed, QT_TRANSLATE_NOOP("Health", "It sent messages of a wrong length.")},
      {HealthReason::NothingDue,
       QT_TRANSLATE_NOOP("Health", "Not heard for some time; no periodic message is expected of it.")},
  }};
  QStringList texts;
  for (const HealthReason reason : kAllOf<HealthReason>) {
    if (health.has(reason)) texts << QCoreApplication::translate("Health", kTexts[reason]);
  }
  return texts;
}

}  // namespace deckpipe
