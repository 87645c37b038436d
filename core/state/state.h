// SPDX-License-Identifier: GPL-3.0-or-later
// Everything known at one instant of a log, built from frames, notes and log time alone by apply() and
// timeCame() (advance.h walks a store with them). A plain value: copying it is a keyframe. It holds the channels
// up to the last one heard, kMaxChannels at most. The state at a cursor is the same however one got there.
//
//   1. Between two frames every time-out that falls due is applied at its own time, in order of deadline; one
//      that is due at the very time of a frame comes before that frame.
//   2. Nothing here looks at stamps, only at log time.
//   3. Channels beyond kMaxChannels are counted, not followed.
#pragma once

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <vector>

#include "bus/controller.h"
#include "bus/frame.h"
#include "log/note_store.h"
#include "log/time_grain.h"
#include "protocol/address_book.h"
#include "protocol/classify.h"
#include "state/devices.h"
#include "state/joysticks.h"
#include "state/nodes.h"

namespace deckpipe {

// A place in a log: so many frames have happened, and it is this late.
struct Cursor {
  std::uint64_t frames = 0;
  Instant time = kNotYet;
  friend constexpr bool operator==(const Cursor&, const Cursor&) = default;
};

struct MessageCounter {
  std::uint64_t count = 0;
  Instant last = kNotYet;
  friend bool operator==(const MessageCounter&, const MessageCounter&) = default;
};

enum class ChannelLink : std::uint8_t { Unknown, Up, Down };

struct ChannelState {
  AddressBook book;
  Nodes nodes;
  Joysticks joysticks;
  std::uint64_t frames = 0;
  std::uint64_t bits = 0;  // estimated on the wire, for the load
  std::uint64_t errorFrames = 0;
  std::uint64_t remoteFrames = 0;
  std::uint64_t dropped = 0;  // said lost by notes
  Instant lastFrame = kNotYet;
  // When every node last had cause to say its NAME: a request to all for it, or an address that was commanded.
  Instant namesAsked = kNotYet;
  ChannelLink link = ChannelLink::Unknown;
  std::uint32_t bitRate = 0;  // bit/s; 0: the log does not say it
  // When the link last came up, and when it last went down: nothing can be heard in between.
  Instant linkUp = kNotYet, linkDown = kNotYet;
  // Whether the link was down since something was heard, and is up again: another bus may be at the plug. A log without
  // times stands still at 0: what was said before its gaps is forgotten instead.
  bool isBeforeGap(Instant at) const {
    return link == ChannelLink::Up && at != kNotYet && at <= linkDown && linkDown != Instant{};
  }
  // Whatever is missing is missing since then, at the earliest.
  Instant missedFrom(Instant lastHeard) const { return std::max(lastHeard, linkUp); }
  // The last instant at or before `now` at which this channel could be heard.
  Instant heardUntil(Instant now) const { return link == ChannelLink::Down ? linkDown : now; }
  Address ownAddress;        // of the console that recorded this; null while it held none
  std::bitset<256> wereOwn;  // addresses that it ever held
  ControllerState controller = ControllerState::Unknown;  // of the adapter, as its error frames said last
  friend bool operator==(const ChannelState&, const ChannelState&) = default;
};

class State {
 public:
  const Cursor& cursor() const { return m_cursor; }
  // Empty of a channel that was not heard.
  const ChannelState& channel(Channel c) const;
  // Channels up to the last one heard.
  std::size_t channelCount() const { return m_channels.size(); }
  const Devices& devices() const { return m_devices; }
  const MessageCounter& counter(MessageId id) const { return m_counters[id]; }
  // Frames that are no message of the catalogue; those that are, but of a wrong length.
  const MessageCounter& others() const { return m_others; }
  const MessageCounter& malformed() const { return m_malformed; }
  // Frames on channels beyond kMaxChannels.
  std::uint64_t untrackedFrames() const { return m_untrackedFrames; }
  bool isLocked() const { return m_locked; }
  // Frames of the log were left out when it was saved (note::Filtered): nothing that rests on a silence is known.
  bool isFiltered() const { return m_isFiltered; }

  // How fine the times of the log are; before its first frame.
  void timesAre(TimeGrain grain);
  // What two times of the log may be nearer to each other than they seem.
  Duration slack() const { return m_isCoarse ? kSecondGrain : Duration{0}; }

  // The next frame of the log. `time` is its log time, not before the cursor's.
  void apply(const Frame& frame, Instant time);
  // A note that stands before the next frame.
  void apply(const Note& note);
  // Nothing came until `time`: what is due by then happens.
  void timeCame(Instant time);

  friend bool operator==(const State&, const State&) = default;

 private:
  ChannelState& use(Channel c);
  void applyExtended(const Frame& frame, Instant time, const Classified& what);
  void applyStandard(const Frame& frame, Instant time, const Classified& what);
  void namesAsked(ChannelState& channel, Channel channelId, Address destination, Instant time);
  void nameHeard(Channel channelId, const Frame& frame, Instant time);
  void announced(ChannelState& channel, Channel channelId, Address source, const Frame& frame, Instant time);
  void count(const Classified& what, Instant time);
  void linkIs(Channel channelId, ChannelLink link);
  void lose(Channel channel, const AddressBook::Lost& lost, Instant time);
  // Whether the frame that is applied may say that a device starts. One that was put into the log when a part of it was
  // saved says who is who, and no device sent it then. What a filter held back may have asked for it.
  bool maySayStart() const { return m_cursor.frames > m_addedUntil && !m_isFiltered; }
  Instant nextDeadline() const;
  void fire(Instant due);

  Cursor m_cursor;
  Instant m_nextCheck = kNever;  // no deadline is earlier
  std::vector<ChannelState> m_channels;
  Devices m_devices;
  EnumArray<MessageId, MessageCounter> m_counters;
  MessageCounter m_others, m_malformed;
  std::uint64_t m_untrackedFrames = 0;
  std::uint64_t m_addedUntil = 0;  // frames before this place were added when the log was saved
  bool m_locked = true;
  bool m_isCoarse = false;
  bool m_isFiltered = false;
};
// A keyframe stands every 131,072 frames, which are 3.1 MB.
static_assert(sizeof(State) + 4 * sizeof(ChannelState) <= 155'000, "5 % of the frames with four channels");
static_assert(sizeof(State) + kMaxChannels * sizeof(ChannelState) <= 314'500, "10 % with all of them");

}  // namespace deckpipe
