// SPDX-License-Identifier: GPL-3.0-or-later
// Which device is meant, wherever one is chosen, shown or named by an intent: the PIN, which stays when the
// address changes, or the place on a channel of what has no PIN.
#pragma once

#include "base/ids.h"

namespace deckpipe {

struct DeviceKey {
  enum class Kind : std::uint8_t { None, Pin, Address, Node };

  Kind kind = Kind::None;
  Pin pin{};          // Kind::Pin; the rest is then left alone, for a PIN is the same on every channel
  Channel channel{};  // Kind::Address, Kind::Node
  Address address{};  // Kind::Address
  NodeId node{};      // Kind::Node

  static constexpr DeviceKey of(const Pin& pin) { return {.kind = Kind::Pin, .pin = pin}; }
  static constexpr DeviceKey at(Channel channel, Address address) {
    return {.kind = Kind::Address, .channel = channel, .address = address};
  }
  static constexpr DeviceKey at(Channel channel, NodeId node) {
    return {.kind = Kind::Node, .channel = channel, .node = node};
  }

  constexpr bool isNull() const { return kind == Kind::None; }
  friend constexpr auto operator<=>(const DeviceKey&, const DeviceKey&) = default;
};

}  // namespace deckpipe
