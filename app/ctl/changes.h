// SPDX-License-Identifier: GPL-3.0-or-later
// Changes on a bus as lines of JSON, for `deckpipectl watch`: devices that come, move and go, addresses
// claimed, values that differ from the last ones, what falls silent, joysticks that begin and end, what the link did.
#pragma once

#include <array>
#include <map>
#include <string>

#include "bus_follower.h"
#include "state/stick_watch.h"

namespace deckpipe::ctl {

class Changes {
 public:
  // Sets the onFrame and onNote of `follower`; lines are appended to `out`.
  Changes(BusFollower& follower, Channel channel, std::string channelName, std::string& out);

 private:
  struct Shown {
    Device::Kind kind = Device::Kind::Free;
    Pin pin;
    Address address;
    NodeId node;
    EnumSet<MessageId> stale;
    Instant restarted = kNotYet;
  };
  void frameCame(const Frame& frame, const Classified& what);
  void noteCame(const Note& note);
  void compare();
  void stickCame(const Frame& frame);
  void compareSticks();
  void tell(const std::vector<Event>& events);
  void compareDevice(const Device& device, Shown& shown);

  BusFollower& m_follower;
  Channel m_channel;
  std::string m_channelName;
  std::string& m_out;
  std::array<Shown, kMaxDevices> m_shown{};
  std::array<StickWatch, Joysticks::kMax> m_sticks{};
  Instant m_newsFrom =
      kNotYet;  // a joystick that is heard for the first time then has begun; kNever: behind a gap, no frame came
  std::array<std::uint64_t, 256> m_names{};
  // Last payload of each identifier and message.
  std::map<std::pair<std::uint32_t, MessageId>, std::uint64_t> m_last;
};

}  // namespace deckpipe::ctl
