// SPDX-License-Identifier: GPL-3.0-or-later
// What every device of the simulator is and does on the bus, whatever it is for: powers up, claims an
// address, announces itself, answers polls 02-05, has an end of the data pipe, and misbehaves on request. The
// four verbs of a service: received, timeCame, nextTime, takeFrames. No clock, no IO; Simulator or a test passes
// the time in. Sources: CAN Messaging manual, message types FF, 02, 03, 04, 05, FE and Appendix A.
//
// 1. Time never falls, and a frame is passed in after everything due before it was done (received does it).
// 2. What a device does at an instant follows from its seed and what it heard before, not from how often
//    timeCame was called.
// 3. It speaks from a claimed address only; its parts go on moving while it has none.
// 4. Without power it neither hears nor sends nor moves, and forgets what it was asked for.
#pragma once

#include <vector>

#include "simulator/address_claim.h"
#include "simulator/misbehaviour.h"
#include "simulator/pipe_end.h"

namespace deckpipe::simulator {

class Device : private PipeShell::Facts {
 public:
  ~Device() override = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  void received(Instant now, const Frame& frame);
  void timeCame(Instant now);
  Instant nextTime() const;
  // Appends the frames that were due by the last time passed in, in order.
  void takeFrames(std::vector<DueFrame>& out);

  // It claims its address `boot` later.
  void powerOn(Instant now, Duration boot);
  void powerOff();
  // The same as message 45.
  void reset(Instant now);
  bool isPowered() const { return m_running || m_startAt != kNever; }

  void misbehave(const Misbehaviour& how);
  const Misbehaviour& misbehaviour() const { return m_misbehaviour; }

  const Identity& identity() const { return m_identity; }
  // Null while it has none.
  Address address() const { return m_claim.address(); }
  AddressClaim::State claimState() const { return m_claim.state(); }

 protected:
  // `period` is that of tick(); zero = never.
  Device(Identity identity, Duration period, std::uint64_t seed, AddressClaim::Range range = {});

  // Powered up, or reset: what was asked for before is forgotten.
  virtual void started(Instant) {}
  virtual void tick(Instant) {}
  // Any 29-bit data frame of another node, polls 02-05 and claims included.
  virtual void heard(Instant, const J1939Id&, const Frame&) {}
  // For the answer to a fault poll: the code of what is really wrong, 0 = nothing.
  virtual std::uint16_t pcodeError() const { return 0; }
  // What STAT says of this kind of device; lines that end with CR LF.
  virtual std::string ownStatus() const { return {}; }

  // An EF00 message from a node that can be answered to our own address.
  bool isForUs(const J1939Id& id) const {
    return id.pgn == pgn::kProprietaryA && address() != kNullAddress && id.destination == address() &&
           id.source != kNullAddress && id.source != kGlobalAddress;
  }
  // What it says is wrong, by itself or on request.
  std::uint16_t errorCode() const {
    return m_misbehaviour.pcodeError != 0 ? m_misbehaviour.pcodeError : pcodeError();
  }
  // A status of its own address; nothing while it has none.
  void broadcast(Instant now, MessageId id, const Encoded& data) { broadcastFrom(now, id, data, address()); }
  void broadcastFrom(Instant now, MessageId id, const Encoded& data, Address source);
  // To a poll or a request, as AnswerFaults spoils it.
  void answer(Instant now, MessageId id, Encoded data, Address to);

 private:
  // Polls 02-05 and the pipe are Akron's; others hear only the claims.
  bool isAkron() const { return m_identity.name.isAkron(); }
  void step(Instant now);
  void announce(Instant now);
  void heardRequest(Instant now, const J1939Id& id, const Frame& frame);
  // Of one byte; nothing where it is none of polls 02-05.
  void answerPoll(Instant now, const Frame& frame, Address to);
  void sendPipe(Instant now);
  void forget();
  void post(Instant due, Duration late, const Frame& frame);
  std::uint32_t faultMap() const;
  Frame made(MessageId id, Encoded data, Address source, Address to) const;

  std::string banner() const override;
  std::string versions() const override;
  std::string status() const override;

  Identity m_identity;
  Duration m_period;
  AddressClaim m_claim;
  Random m_random;
  Misbehaviour m_misbehaviour;
  Outbox m_outbox;
  PipeEnd m_pipe;
  std::vector<PipeEnd::Outgoing> m_pipeOut;
  std::vector<DueFrame> m_late;  // by time: must not hold up what is posted after them
  std::vector<DueFrame> m_ready;
  unsigned m_answers = 0;  // since the misbehaviour was set
  Instant m_startAt = kNever;
  Instant m_tickAt = kNever;
  bool m_running = false;
  bool m_hasRun = false;
};

}  // namespace deckpipe::simulator
