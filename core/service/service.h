// SPDX-License-Identifier: GPL-3.0-or-later
// A service, and what it is given with every call.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/ids.h"
#include "bus/own_frames.h"
#include "control/intent.h"
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

enum class EndReason : std::uint8_t {
  Locked,
  Closing,  // the link is about to be closed
  AddressLost,
};

// Of a frame. Handing it over proves nothing: only an echo does.
enum class WriteOutcome : std::uint8_t {
  OnBus,       // its echo came; `now` is the echo's log time
  CannotTell,  // the adapter took it, or queued it, and tells no more: this counts as on the bus from now on
  QueueFull,   // not sent, for want of room
  NotTaken,    // not sent
  Gone,        // the interface went down first: whether it went out before is not known
  EchoLost,    // its echo may have been lost on the way to us: whether it went out is not known
};

// The longest that an ending may last.
inline constexpr Duration kEndingTime = 1s;
// A frame whose echo has not come by then is said to be 'not on the bus yet'.
inline constexpr Duration kOnBusTime = 100ms;
// From a full queue to the second try of what is tried again.
inline constexpr Duration kTryAgain = 20ms;

// One thing that this console says on a bus by itself or for a person: an address claim, polls and commands,
// data pipes. Services (services.h) owns all of them and is their only caller.
//
// The contract, in the order of a service's life. Time is passed in; no call happens inside another. Every
// call may put frames to send and notes into `out`, unless it is said otherwise here; Services hands them on
// when the call has returned. After every call but nextTime() and status() all of nextTime(), source(),
// hasEnded() and status() may have changed.
//
//   linkChanged(true)   Sending is unlocked and the link is up: the service begins, and may send.
//   intentCame(intent)  A person's intent. Nothing is returned for an intent that is for another service; any
//                       other answer is final. A refused intent changes nothing.
//   received(frame)     A frame was on the bus. The State has it already. Our own frames come too, with
//                       Frame::kSent. `now` is the frame's own log time, which may lie before the `now` of
//                       an earlier call when the thread was late, but never before that of an earlier frame.
//   writeEnded(tag)     What became of a frame that the service put into `out`; once for each, also after the
//                       end, but for what still waits when we close the link ourselves. The outcomes stand
//                       below. After one that says that the adapter did not take the frame nothing is sent at
//                       once, but from timeCame() on. A joystick's first neutral alone goes out at once.
//   timeCame()          `now` has reached nextTime(), or passed it. Every frame that was on the bus until
//                       `now` was handed over before: what is missing now has not come in time.
//   end(reason)         Stop: what is open ends now, with this reason.
//                         Locked, Closing  Ending is a phase. A service that must still say something (a
//                                          joystick its neutral) goes on saying it until hasEnded(). Lock or
//                                          close are complete when all have ended, and after kEndingTime in
//                                          any case. A service that has ended gets only writeEnded() until
//                                          linkChanged(true) comes again.
//                         AddressLost      source() was lost to another node. What has to be said of that is
//                                          said in this call. The service goes on by itself when source() is
//                                          there again.
//   hasEnded()          Asked after each call since end(Locked) or end(Closing).
//   linkChanged(false)  The link is gone. Everything ends at once, an ending too; nothing can be sent. What
//                       was still waiting for its echo was told before, by writeEnded(Gone).
//
// The services stand in a list, each behind those that it depends on: a frame reaches the claim of an address
// before it reaches who sends from that address, and a service that others depend on (endsLast) is asked to
// end when all the others have ended.
class Service {
 public:
  virtual ~Service() = default;

  virtual void linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) = 0;
  virtual std::optional<Refusal> intentCame(Instant now, const Live& live, const Intent& intent,
                                            Outgoing& out) = 0;
  virtual void received(Instant now, const Live& live, const Frame& frame, Outgoing& out) = 0;
  virtual void writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome,
                          Outgoing& out) = 0;
  virtual void timeCame(Instant now, const Live& live, Outgoing& out) = 0;
  // What the driver says of the adapter's controller, whenever it was read.
  virtual void controllerRead(Instant, const Live&, const ControllerReading&, Outgoing&) {}
  // When timeCame() is due next; kNever if nothing is.
  virtual Instant nextTime() const = 0;
  virtual void end(Instant now, const Live& live, EndReason reason, Outgoing& out) = 0;
  // Most have nothing to say at their end.
  virtual bool hasEnded() const { return true; }
  virtual bool endsLast() const { return false; }
  // The claimed address that it sends from; null while it has none, and for a claim itself.
  virtual Address source() const = 0;
  // What it has to say of itself, into its own part of the whole.
  virtual void status(const Live& live, ServiceStatus& into) const = 0;
};

}  // namespace deckpipe
