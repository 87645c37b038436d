// SPDX-License-Identifier: GPL-3.0-or-later
// Which device is meant, wherever one is chosen, shown or named by an intent: the PIN, which stays when the
// address changes, or the address or node of what has no PIN; and the channel in any case, for what answers
// to one PIN on two channels is heard, and asked, on each of its own.
#pragma once

#include "base/ids.h"

namespace deckpipe {

struct DeviceKey {
  enum class Kind : std::uint8_t { None, Pin, Address, Node };

  Kind kind = Kind::None;
  Pin pin{};  // Kind::Pin
  Channel channel{};
  Address address{};  // Kind::Address
  NodeId node{};      // Kind::Node

  static constexpr DeviceKey of(const Pin& pin, Channel channel = {}) {
    return {.kind = Kind::Pin, .pin = pin, .channel = channel};
  }
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
