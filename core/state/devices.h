// SPDX-License-Identifier: GPL-3.0-or-later
// All devices of a log, found by PIN, by address or by CANopen node. Identity is the PIN, never the address:
// a device keeps everything it reported when its address changes. Where no place is free, a device that says
// its PIN takes that of the one without a PIN that was heard longest ago.
#pragma once

#include <array>
#include <span>

#include "state/device.h"

namespace deckpipe {

inline constexpr std::size_t kMaxChannels = 16;
inline constexpr std::size_t kMaxDevices = 80;

class Devices {
 public:
  Devices();

  // In order of first appearance; free places have Kind::Free.
  std::span<const Device> all() const { return m_devices; }
  std::span<Device> all() { return m_devices; }
  // A PIN heard on two channels is two devices: each has its own address and says its own things.
  const Device* byPin(Channel channel, const Pin& pin) const;
  // The first that was heard with this PIN, on whatever channel.
  const Device* byPin(const Pin& pin) const;
  const Device* byAddress(Channel channel, Address address) const {
    if (channel.value >= kMaxChannels) return nullptr;
    const Index i = m_byAddress[channel.value][address.value];
    return i == kNone ? nullptr : &m_devices[i];
  }
  const Device* byNode(Channel channel, NodeId node) const;

  // The device at an address or node, made where there is none; null where there is no room.
  Device* atAddress(Channel channel, Address address, Instant time);
  Device* atNode(Channel channel, NodeId node);
  Device* findAddress(Channel channel, Address address) {
    return at(m_byAddress[channel.value][address.value]);
  }

  // The device at an address, if any, is not there any more, says the address book. One that was known only
  // by its address is forgotten.
  void addressLost(Channel channel, Address address, Instant time);
  // Frames come again on a channel after its link was down: nobody has said yet whose its addresses are now. What had
  // a PIN is known by its address alone, and what had no address is forgotten.
  void linkCameBack(Channel channel, Instant time);
  // Behind a gap the device at an address claimed it under the NAME of the PIN that it had: it is the same one.
  void named(Channel channel, Address address, const Pin& pin);
  // A device announced itself: it has this address from now on. Whoever had it lost it before. What was said there
  // before a gap, by whoever had not said its PIN, is not its own.
  void announced(Channel channel, Address address, const Pin& pin, Instant time);

  // Whether times are good to the second; before the first device.
  void setCoarse(bool areCoarse) { m_areCoarse = areCoarse; }
  Instant nextDeadline() const;
  void timeCame(Instant time);
  // Devices that there was no room for, counted once a frame.
  std::uint32_t untracked() const { return m_untracked; }

  friend bool operator==(const Devices&, const Devices&) = default;

 private:
  using Index = std::uint8_t;
  static constexpr Index kNone = 0xFF;
  static_assert(kMaxDevices < kNone);

  Device* at(Index i) { return i == kNone ? nullptr : &m_devices[i]; }
  Index indexOf(const Device& device) const { return static_cast<Index>(&device - m_devices.data()); }
  Device* freePlace();
  Device* make();
  Device* makeForPin(Channel channel, Address address, Instant time);
  void giveAddress(Device& device, Address address, Instant time);
  void takeAddress(Device& device, Instant time);

  std::span<const Device> used() const { return std::span(m_devices).first(m_used); }

  std::array<Device, kMaxDevices> m_devices{};
  std::size_t m_used = 0;  // no device was ever made behind these
  std::array<std::array<Index, 256>, kMaxChannels> m_byAddress;
  std::array<std::array<Index, 128>, kMaxChannels> m_byNode;
  std::uint32_t m_untracked = 0;
  bool m_areCoarse = false;
};

}  // namespace deckpipe
