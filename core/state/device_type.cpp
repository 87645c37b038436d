// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/device_type.h"

#include "protocol/device_types.h"

namespace deckpipe {
namespace {

using From = DeviceType::From;

constexpr NodeId kGatewayNode{0x70};  // the gateway manual's default

bool sendsMonitorStatus(const Device& d) {
  return d.isKnownNow(MessageId::PositionLimitStatus) || d.isKnownNow(MessageId::DigitalOutputs) ||
         d.isKnownNow(MessageId::RotationSoftLimits) || d.isKnownNow(MessageId::ElevationSoftLimits);
}

}  // namespace

std::optional<unsigned> DeviceType::pinDigits() const {
  if (from == From::Pin) return number;
  if (const unsigned type = from == From::Part ? deviceTypeOfPart(number) : 0u; type != 0) return type;
  if (from == From::Messages84) return soleSenderOf(MessageId::MiniDigitalOutputs);
  return {};
}

DeviceType typeOf(const Device& d) {
  if (d.kind == Device::Kind::Pin) return {From::Pin, d.pin.deviceType()};
  if (d.kind == Device::Kind::Node) {
    if (d.part() != 0) return {From::Part, d.part()};
    if (sendsMonitorStatus(d)) return {From::MonitorNode};
    return {d.node == kGatewayNode ? From::GatewayNode : From::CanopenNode};
  }
  if (sendsMonitorStatus(d)) return {From::Messages83};
  if (d.isKnownNow(MessageId::MiniDigitalOutputs)) return {From::Messages84};
  if (d.isKnownNow(MessageId::DigitalInputs)) return {From::Messages85};
  return {From::AkronMessages};
}

DeviceType typeOf(const State& state, Channel channel, Address address) {
  const ChannelState& on = state.channel(channel);
  if (address == on.ownAddress) return {From::Own};
  if (on.book.isDrive(address)) return {From::Drive};
  const Name name = on.book.lastHolder(address);
  if (name.isNull()) return {From::NoName};
  if (name.isAkron()) return {From::AkronName};
  return {From::OtherName, name.manufacturerCode()};
}

bool isMonitor(const Device& d) {
  return sendsMonitorStatus(d) || isOfUse(typeOf(d).pinDigits().value_or(0), DeviceUse::Monitor);
}

}  // namespace deckpipe
