// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/live.h"

namespace deckpipe {

const Device* Live::find(const DeviceKey& key) const {
  const Device* device = nullptr;
  if (key.kind == DeviceKey::Kind::Pin) device = state.devices().byPin(key.pin);
  if (key.kind == DeviceKey::Kind::Address && key.channel == channel)
    device = state.devices().byAddress(channel, key.address);
  return device != nullptr && device->channel == channel ? device : nullptr;
}

std::optional<Address> Live::addressOf(const DeviceKey& key) const {
  const Device* device = find(key);
  if (device == nullptr || device->address == kNullAddress) return {};
  return device->address;
}

DeviceKey Live::canonical(const DeviceKey& key) const {
  const Device* device = find(key);
  return device != nullptr && !device->pin.isNull() ? DeviceKey::of(device->pin) : key;
}

}  // namespace deckpipe
