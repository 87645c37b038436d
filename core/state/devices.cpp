// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/devices.h"

#include <algorithm>

namespace deckpipe {

Devices::Devices() {
  for (auto& channel : m_byAddress) channel.fill(kNone);
  for (auto& channel : m_byNode) channel.fill(kNone);
}

const Device* Devices::byPin(const Pin& pin) const {
  const auto found = std::ranges::find_if(
      m_devices, [&](const Device& device) { return device.kind == Device::Kind::Pin && device.pin == pin; });
  return found == m_devices.end() ? nullptr : &*found;
}

const Device* Devices::byPin(Channel channel, const Pin& pin) const {
  const auto found = std::ranges::find_if(used(), [&](const Device& device) {
    return device.kind == Device::Kind::Pin && device.channel == channel && device.pin == pin;
  });
  return found == used().end() ? nullptr : &*found;
}

const Device* Devices::byNode(Channel channel, NodeId node) const {
  if (channel.value >= kMaxChannels || node.value >= 128) return nullptr;
  const Index i = m_byNode[channel.value][node.value];
  return i == kNone ? nullptr : &m_devices[i];
}

Device* Devices::freePlace() {
  const auto free = std::ranges::find(m_devices, Device::Kind::Free, &Device::kind);
  if (free == m_devices.end()) return nullptr;
  m_used = std::max(m_used, static_cast<std::size_t>(free - m_devices.begin()) + 1);
  return &*free;
}

Device* Devices::make() {
  Device* device = freePlace();
  if (device == nullptr) {
    ++m_untracked;
  } else {
    device->isCoarse = m_areCoarse;
  }
  return device;
}

Device* Devices::makeForPin(Channel channel, Address address, Instant time) {
  if (freePlace() == nullptr) {
    Device* oldest = nullptr;
    for (Device& device : m_devices) {
      if (device.kind == Device::Kind::Pin) continue;
      if (oldest == nullptr || device.lastHeard < oldest->lastHeard) oldest = &device;
    }
    if (oldest != nullptr) {
      auto& index = oldest->kind == Device::Kind::Node
                        ? m_byNode[oldest->channel.value][oldest->node.value]
                        : m_byAddress[oldest->channel.value][oldest->address.value];
      index = kNone;
      *oldest = {};
    }
  }
  return atAddress(channel, address, time);
}

Device* Devices::atAddress(Channel channel, Address address, Instant time) {
  if (Device* device = findAddress(channel, address)) return device;
  Device* device = make();
  if (device == nullptr) return nullptr;
  device->kind = Device::Kind::Address;
  device->channel = channel;
  device->address = address;
  device->addressSince = time;
  m_byAddress[channel.value][address.value] = indexOf(*device);
  return device;
}

Device* Devices::atNode(Channel channel, NodeId node) {
  Index& index = m_byNode[channel.value][node.value & 0x7F];
  if (index != kNone) return &m_devices[index];
  Device* device = make();
  if (device == nullptr) return nullptr;
  device->kind = Device::Kind::Node;
  device->channel = channel;
  device->node = node;
  index = indexOf(*device);
  return device;
}

void Devices::takeAddress(Device& device, Instant time) {
  if (device.address == kNullAddress) return;
  m_byAddress[device.channel.value][device.address.value] = kNone;
  if (device.kind == Device::Kind::Address) {  // it was nothing but that address
    device = {};
    return;
  }
  std::shift_right(device.formerAddresses.begin(), device.formerAddresses.end(), 1);
  device.formerAddresses.front() = {time, device.address};
  device.address = kNullAddress;
  device.addressSince = time;
}

void Devices::giveAddress(Device& device, Address address, Instant time) {
  if (device.address == address) return;
  if (Device* before = findAddress(device.channel, address)) takeAddress(*before, time);
  if (device.previousAddress() != kNullAddress) ++device.addressChanges;
  device.address = address;
  device.addressSince = time;
  m_byAddress[device.channel.value][address.value] = indexOf(device);
}

void Devices::announced(Channel channel, Address address, const Pin& pin, Instant time) {
  Device* device = const_cast<Device*>(byPin(channel, pin));
  if (device == nullptr) {
    device = findAddress(channel, address);  // heard before it said who it is
    if (device == nullptr) device = makeForPin(channel, address, time);
    if (device == nullptr) return;
    // The address book has taken away the address of whoever had another PIN there.
    if (device->announced == kNotYet) device->forgetBeforeGap();
    device->kind = Device::Kind::Pin;
    device->pin = pin;
    device->addressSince = time;
  } else {
    giveAddress(*device, address, time);
  }
  device->announced = time;
}

void Devices::addressLost(Channel channel, Address address, Instant time) {
  if (Device* device = findAddress(channel, address)) takeAddress(*device, time);
}

void Devices::named(Channel channel, Address address, const Pin& pin) {
  Device* device = findAddress(channel, address);
  if (device == nullptr || device->kind == Device::Kind::Pin) return;
  device->kind = Device::Kind::Pin;
  device->pin = pin;
}

void Devices::linkCameBack(Channel channel, Instant time) {
  for (Device& device : std::span(m_devices).first(m_used)) {
    if (device.kind == Device::Kind::Free || device.channel != channel) continue;
    if (device.kind == Device::Kind::Pin) {
      device.kind = Device::Kind::Address;
      device.pin = {};
      if (device.address == kNullAddress) {
        device = {};
        continue;
      }
    }
    device.linkCameBack(time);
  }
}

Instant Devices::nextDeadline() const {
  Instant next = kNever;
  for (const Device& device : used()) {
    if (device.kind != Device::Kind::Free) next = std::min(next, device.nextDeadline());
  }
  return next;
}

void Devices::timeCame(Instant time) {
  for (Device& device : std::span(m_devices).first(m_used)) {
    if (device.kind != Device::Kind::Free) device.timeCame(time);
  }
}

}  // namespace deckpipe
