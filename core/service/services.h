// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that this console sends on one channel, behind the one transmit lock. The bus thread owns it and
// gives it every live frame, the time when it asked for it, what the person wants and how the link is; it
// takes from it the frames to write and the notes to put into the log. No clock, no IO. It calls the services
// as service.h says, and knows none of them but where it makes them.
//
//   1. Locked, nothing is sent at all: no claim, no ack, no answer to a request for the NAME.
//   2. Unlocking lasts for this run and this link: a link that is lost locks, and nothing is unlocked without one
//      (design.md section 7, rule 2).
//   3. A lock or close waits for services that still have something to say, kEndingTime at most. Meanwhile
//      nothing is begun.
//   4. What a person wants is done or refused at once, with the reason; nothing waits for an address.
#pragma once

#include <memory>

#include "bus/port.h"
#include "service/bus_budget.h"
#include "service/claim_service.h"

namespace deckpipe {

struct ServiceSettings {
  Channel channel{};
  int bitRate = 250'000;
  bool echoes = true;  // our own frames come back from the link
  ClaimSettings claim{};
  // No frame comes back that was not on the bus: good enough to move a monitor without a word of the person for it.
  bool echoIsProven = false;
};

class Services {
 public:
  explicit Services(const ServiceSettings& settings);
  // One more, behind those that it depends on; before the link comes up.
  Service& add(std::unique_ptr<Service> service);

  void linkChanged(Instant now, const State& live, bool isUp);
  // What the driver says of the adapter: nothing is unlocked that cannot send, and what is, is locked.
  void setListenOnly(Instant now, const State& live, bool isListenOnly);
  // … and whether it loops frames back itself: where the kernel does it when a frame is queued, an echo says
  // nothing about the bus. Taken for true until said otherwise.
  void setEchoProves(bool proves) { m_status.echoes = m_settings.echoes && proves; }
  // … and how its controller is. Returns whether there is something to write.
  bool controllerRead(Instant now, const State& live, const ControllerReading& reading);
  // … and at which bit rate the bus runs, 0 if it does not say.
  void setBitRate(int bitRate) { m_budget.setBitRate(bitRate > 0 ? bitRate : m_settings.bitRate); }
  // Ends everything, because the link is about to be closed; complete when isLocked(). For good.
  void close(Instant now, const State& live);
  bool isLocked() const { return m_status.locked; }
  Refusal apply(Instant now, const State& live, const StampedIntent& intent);
  // For a reason that the services cannot know.
  Refusal refuse(const StampedIntent& intent, Refusal why);
  // A frame that the State has taken already, with its own log time; our own echoes too. In order.
  void received(Instant at, const State& live, const Frame& frame);
  // Frames were lost before they could be read, behind those that were received(): the echoes of what is not
  // confirmed yet may be among them, and are not waited for.
  void echoesLost(Instant now, const State& live);
  // Only when every frame that was on the bus until `now` was handed over: an answer that came in time is in
  // time, however late the thread is.
  void timeCame(Instant now, const State& live);
  Instant nextTime() const;
  // Appends what is to be written, in order, and forgets it. Each is to be written at once and followed by
  // wrote(); then there may be more.
  void takeFrames(std::vector<OutFrame>& out);
  void wrote(Instant now, const State& live, const OutFrame& frame, WriteResult result);
  void takeNotes(std::vector<Note>& out);

  ServiceStatus status(Instant now, const State& live);

 private:
  struct Again {
    OutFrame frame;
    Instant due;
  };
  struct Entry {
    std::unique_ptr<Service> service;
    Address source = kNullAddress;  // that it had after the last call
    bool hasEnded = false;          // since the last end()
  };
  bool isOpen() const { return !m_status.locked && m_status.linkUp; }
  Live liveOf(const State& state) const { return {state, m_settings.channel}; }
  Refusal carryOut(Instant now, const Live& live, const StampedIntent& intent);
  void begin(Instant now, const Live& live);
  Refusal unlock(Instant now, const Live& live);
  void endAll(Instant now, const Live& live, EndReason reason);
  void followEnding(Instant now, const Live& live);
  void complete(Instant now, const Live& live);
  void writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome);
  // Of all frames that wait for their echo.
  void endOwn(Instant now, const Live& live, WriteOutcome outcome);
  // What was not written yet, or waits for its second try, is not sent.
  void dropUnwritten(Instant now, const Live& live);
  // What a full queue refused is not tried again.
  void giveUpAgain(Instant now, const Live& live);
  // Nothing takes back what the adapter has, nor `unwritten` frames that it is about to get.
  void noteWaiting(const Live& live, std::size_t unwritten);
  // Calls every service that has not ended, in order or backwards, as the owner of what it sends.
  template <typename F>
  void forEach(F&& call);
  template <typename F>
  void forEachBackwards(F&& call);
  template <typename F>
  void callAt(std::size_t place, F&& call);
  // Who sent from an address that is no longer ours ends.
  void dropLeft(Instant now, const Live& live);
  void followAddresses(Instant now, const Live& live);

  ServiceSettings m_settings;
  ServiceStatus m_status;
  bool m_isClosed = false;
  EndReason m_reason{};  // of the ending that is under way
  Instant m_endBy = kNever;
  BusBudget m_budget;
  std::vector<Entry> m_services;
  Outgoing m_out;
  OwnFrames m_own;
  std::vector<Again> m_again;
};

}  // namespace deckpipe
