// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/service.h"

namespace deckpipe {

const Device* Live::find(const DeviceKey& key) const {
  const Device* device = nullptr;
  if (key.channel != channel) return nullptr;
  if (key.kind == DeviceKey::Kind::Pin) device = state.devices().byPin(channel, key.pin);
  if (key.kind == DeviceKey::Kind::Address) device = state.devices().byAddress(channel, key.address);
  return device;
}

std::optional<Address> Live::addressOf(const DeviceKey& key) const {
  const Device* device = find(key);
  if (device == nullptr || device->address == kNullAddress) return {};
  return device->address;
}

Refusal Live::whyNowhere(const DeviceKey& key) const {
  const bool isFormer = key.kind == DeviceKey::Kind::Pin && key.channel == channel && find(key) == nullptr &&
                        bus().book.formerAddress(key.pin) != kNullAddress;
  return isFormer ? Refusal::FormerPin : Refusal::NoDevice;
}

Refusal Live::whyNotTo(Instant now, const DeviceKey& key) const {
  const Device* device = find(key);
  if (device == nullptr || device->address == kNullAddress) return whyNowhere(key);
  if (bus().book.isContested(device->address)) return Refusal::Contested;
  return now - device->lastHeard > kHeardWithin ? Refusal::NotHeard : Refusal::None;
}

Refusal Live::whyNoPacketTo(Instant now, const DeviceKey& key) const {
  if (const Refusal why = whyNotTo(now, key); why != Refusal::None) return why;
  const Address address = find(key)->address;
  if (bus().book.isAkron(address)) return Refusal::None;
  return bus().book.wasAkron(address) ? Refusal::FormerPin : Refusal::NotTaken;
}

DeviceKey Live::canonical(const DeviceKey& key) const {
  const Device* device = find(key);
  return device != nullptr && !device->pin.isNull() ? DeviceKey::of(device->pin, channel) : key;
}

}  // namespace deckpipe
