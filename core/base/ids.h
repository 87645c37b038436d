// SPDX-License-Identifier: GPL-3.0-or-later
// Strong types for the numbers a bus identifies things by, so that none is passed for another.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>

namespace deckpipe {

// Index of a link or of a log's interface; its name is in the store's channel list.
struct Channel {
  std::uint8_t value = 0;
  friend constexpr auto operator<=>(Channel, Channel) = default;
};

// J1939 address, 00..FD; FE null (cannot claim), FF global.
struct Address {
  std::uint8_t value = 0xFE;
  friend constexpr auto operator<=>(Address, Address) = default;
};
inline constexpr Address kNullAddress{0xFE};
inline constexpr Address kGlobalAddress{0xFF};

// CANopen node id, 1..127.
struct NodeId {
  std::uint8_t value = 0;
  friend constexpr auto operator<=>(NodeId, NodeId) = default;
};

// An Akron device's Product Identification Number, 15 characters: digits 1-4 the device type, 5-6 letters,
// 7-15 the serial part (CAN Messaging manual, type FF). It identifies a device; its address does not.
class Pin {
 public:
  static constexpr std::size_t kLength = 15;

  constexpr Pin() = default;
  // Null unless the type is 0..9999, both letters are printable ASCII and the serial is 0..999999999.
  static constexpr std::optional<Pin> make(unsigned type, unsigned letter5, unsigned letter6,
                                           unsigned serial) {
    const auto printable = [](unsigned c) { return c >= 0x20 && c <= 0x7E; };
    if (type > 9999 || serial > 999'999'999 || !printable(letter5) || !printable(letter6)) return {};
    Pin pin;
    for (std::size_t i = 4; i-- > 0; type /= 10) pin.m_text[i] = static_cast<char>('0' + type % 10);
    pin.m_text[4] = static_cast<char>(letter5);
    pin.m_text[5] = static_cast<char>(letter6);
    for (std::size_t i = kLength; i-- > 6; serial /= 10) pin.m_text[i] = static_cast<char>('0' + serial % 10);
    return pin;
  }
  // Null unless the text is a whole PIN.
  static constexpr std::optional<Pin> parse(std::string_view text) {
    if (text.size() != kLength) return {};
    unsigned type = 0, serial = 0;
    for (std::size_t i = 0; i < kLength; ++i) {
      if (i == 4 || i == 5) continue;
      if (text[i] < '0' || text[i] > '9') return {};
      unsigned& part = i < 4 ? type : serial;
      part = part * 10 + static_cast<unsigned>(text[i] - '0');
    }
    return make(type, static_cast<unsigned char>(text[4]), static_cast<unsigned char>(text[5]), serial);
  }

  constexpr bool isNull() const { return m_text[0] == '\0'; }
  constexpr std::string_view text() const { return {m_text.data(), isNull() ? 0 : kLength}; }
  constexpr unsigned deviceType() const { return number(0, 4); }
  constexpr unsigned serial() const { return number(6, kLength); }

  friend constexpr auto operator<=>(const Pin&, const Pin&) = default;

 private:
  constexpr unsigned number(std::size_t from, std::size_t to) const {
    unsigned n = 0;
    for (std::size_t i = from; i < to && !isNull(); ++i) n = n * 10 + static_cast<unsigned>(m_text[i] - '0');
    return n;
  }
  std::array<char, kLength> m_text{};
};

// Which device is meant, wherever one is chosen, shown or named by an intent: the PIN, which stays when the
// address changes, or the address or node of what has no PIN; and the channel in any case, for what answers
// to one PIN on two channels is heard, and asked, on each of its own.
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
