// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/stranger_watch.h"

#include <algorithm>

#include "bus/j1939.h"

namespace deckpipe {

bool isSimulatedBus(const LinkSettings& link, const std::optional<CanInterface>& facts) {
  if (link.plugin == QLatin1String("virtualcan")) return true;
  if (link.plugin != QLatin1String("socketcan")) return false;
  return facts && facts->isCan && facts->kind == "vcan";
}

void StrangerWatch::received(const Frame& frame, Instant now) {
  if ((frame.flags & Frame::kSent) != 0) return;
  Frame heard = frame;
  heard.channel = 0;
  m_state.apply(heard, now);
  if (!frame.isExtended() || frame.isError()) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn == pgn::kBasicJoystick || id.pgn == pgn::kExtendedJoystick) m_joysticks.set(id.source.value);
}

std::vector<Stranger> StrangerWatch::strangers() const {
  const ChannelState& bus = m_state.channel({});
  const auto kindAt = [&](Address a, const Device* device) -> std::optional<Stranger::Kind> {
    if (m_joysticks[a.value]) return Stranger::Kind::Joystick;
    if (!bus.book.isHeard(a) || bus.book.lastHolder(a).function() == kServiceToolFunction) return {};
    if (device != nullptr || bus.book.isAkron(a)) return Stranger::Kind::Akron;
    if (std::ranges::count(m_own, a) > 0) return Stranger::Kind::OwnAddress;
    return {};
  };
  std::vector<Stranger> found;
  for (unsigned value = 0; value <= kGlobalAddress.value; ++value) {
    const Address a{static_cast<std::uint8_t>(value)};
    const Device* device = m_state.devices().byAddress({}, a);
    if (const auto kind = kindAt(a, device))
      found.push_back({.kind = *kind, .address = a, .pin = device != nullptr ? device->pin : Pin()});
  }
  for (const Device& device : m_state.devices().all()) {
    if (device.kind == Device::Kind::Pin && device.address == kNullAddress)  // it cannot claim one
      found.push_back({.pin = device.pin});
    if (device.kind != Device::Kind::Node) continue;
    // What only has a heartbeat may be any CANopen device.
    const bool saysStatus = device.position().isKnown() || device.outputs().isKnown();
    if (saysStatus || bus.book.isAkronNode(device.node)) found.push_back({.node = device.node});
  }
  return found;
}

}  // namespace deckpipe
