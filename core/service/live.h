// SPDX-License-Identifier: GPL-3.0-or-later
// What a service is given with every call besides the time, and where it puts what it wants sent and noted.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/device_key.h"
#include "bus/own_frames.h"
#include "control/status.h"
#include "protocol/encode.h"
#include "state/state.h"

namespace deckpipe {

// The live State with every frame up to now applied, whatever the cursor shows.
struct Live {
  const State& state;
  Channel channel;

  const ChannelState& bus() const { return state.channel(channel); }
  const Device* find(const DeviceKey& key) const;
  // Where it is now; nothing where it is not on this channel or has no address.
  std::optional<Address> addressOf(const DeviceKey& key) const;
  // Why a device that has no address now has none: a PIN that was said before a gap means nobody until it is heard
  // anew.
  Refusal whyNowhere(const DeviceKey& key) const;
  // Why no command may go to a device now; None if it may. Polls are not asked for this.
  Refusal whyNotTo(Instant now, const DeviceKey& key) const;
  // The same of a packet of the data pipe: an address that is presumed to be Akron's, or was, is no device to talk to.
  Refusal whyNoPacketTo(Instant now, const DeviceKey& key) const;
  // An address that is a device's own with a PIN is that device.
  DeviceKey canonical(const DeviceKey& key) const;
};

// A frame to be written, and whose it is.
struct OutFrame {
  Frame frame;
  FrameTag tag;
  // When the adapter's queue is full it is tried again once, kTryAgain later.
  bool triesAgain = false;
};

struct Outgoing {
  std::vector<OutFrame> frames;
  std::vector<Note> notes;
  std::uint32_t owner = 0;  // place of the service that is called, in the list; Services sets it
  std::uint64_t lastNumber = 0;
  std::vector<Address> left;  // addresses that are not ours any more: nothing more is sent from them

  // Placed in the log (frame, time) by whoever writes them down.
  void note(NoteValue value) { notes.push_back({.value = std::move(value)}); }
  // `from`: an address that the sender claimed, or the null address for a claim. What becomes of the frame
  // is told by Service::writeEnded() with this tag.
  FrameTag send(const Live& live, Address from, MessageId id, Address to, const Encoded& data,
                bool triesAgain = false) {
    return send(live, j1939Frame(messageOf(id), data, from, to), triesAgain);
  }
  // A frame that is no message of the catalogue.
  FrameTag send(const Live& live, Frame frame, bool triesAgain = false) {
    frame.channel = live.channel.value;
    const FrameTag tag{owner, ++lastNumber};
    frames.push_back({frame, tag, triesAgain});
    return tag;
  }
};

}  // namespace deckpipe
