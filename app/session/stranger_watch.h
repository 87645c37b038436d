// SPDX-License-Identifier: GPL-3.0-or-later
// No program moves a monitor without a word for it. A program that puts joystick messages, or a log that
// holds them, on an interface by itself goes through these steps in this order:
//
// 1. Before it opens the interface: isSimulatedBus(). If it is one, nothing else is asked.
// 2. Otherwise a person must have said that it may move monitors; without that word it opens nothing.
// 3. With it, it opens the interface, feeds a StrangerWatch for StrangerWatch::kListen and sends nothing. If
//    strangers() are there it ends. The same each time the interface comes back.
#pragma once

#include <bitset>
#include <optional>
#include <vector>

#include "link/can_interface.h"
#include "link/can_link.h"
#include "state/state.h"

namespace deckpipe {

// Whether no monitor can be there: Qt's virtualcan, or a vcan by the word of its driver. A name proves
// nothing. `facts`: what the kernel says of an interface of Linux (readInterface(), or LinkStatus::hardware
// once a link is up); nothing if it is not known.
bool isSimulatedBus(const LinkSettings& link, const std::optional<CanInterface>& facts);

// Somebody on a bus whom a program that moves monitors must not meet.
struct Stranger {
  enum class Kind : std::uint8_t {
    Joystick,    // sends joystick messages, from whatever address
    Akron,       // an Akron device, or one that sends such messages
    OwnAddress,  // holds an address that the program wants for itself
  };
  Kind kind = Kind::Akron;
  Address address{};  // null for a CANopen node, and for a device that can claim none
  NodeId node{};      // of a CANopen node; 0 for all others
  Pin pin{};          // null where it was not heard
  friend bool operator==(const Stranger&, const Stranger&) = default;
};

// Another console, which has function 129 in its NAME, is no stranger as long as it sends no joystick message.
class StrangerWatch {
 public:
  static constexpr Duration kListen = 1s;

  // `own`: what the program will send from.
  explicit StrangerWatch(std::vector<Address> own) : m_own(std::move(own)) {}

  void received(const Frame& frame, Instant now);
  // One an address at most, by address.
  std::vector<Stranger> strangers() const;

 private:
  std::vector<Address> m_own;
  State m_state;
  std::bitset<256> m_joysticks;
};

}  // namespace deckpipe
