// SPDX-License-Identifier: GPL-3.0-or-later
// The data pipe (CAN Messaging manual, message type FE): up to 7 characters a packet, one packet in flight to
// a device, the next only after its ack; what comes in is acknowledged at once; both directions interleave,
// and several devices at once. What was said is in the log; here is how it goes.
//
// 1. There is no sequence number, so nothing is ever sent twice by itself: a missing ack stops the pipe until
//    the person says resend, skip or abort. An ack that comes late after all resolves the doubt. What the
//    person says may be for the rest of a file or text too: that holds for missing acks alone, for
//    kMaxMissingAcks in a row, and never outlives what it was said of.
// 2. An ack counts only once the packet was on the bus, and its time runs from there: one that came before
//    cannot be its own. A packet that is not on the bus yet is not sent a second time.
// 3. After a packet was sent again, skipped or given up, an ack of it may still come. The next packet waits
//    kSettle for it, from its being on the bus, lest it be taken for its own.
// 4. Only who is known to be Akron's is sent packets and answered: other makers' frames look the same.
// 5. A device has one pipe, by its PIN once that is known: one that was used by its address joins it. Where
//    both had something under way, both end. When sending begins anew, pipes to addresses are forgotten.
// 6. A packet belongs to the address it went to. When the device is elsewhere by then, the pipe stops.
// 7. Each packet goes only where a command may go: to a device heard within 1 s, at an address that nobody
//    contests. Otherwise the pipe stops before it.
// 8. A device that restarts has lost what it was told: what waits then is dropped, and a file ends.
#pragma once

#include <vector>

#include "service/claim_service.h"
#include "service/pipe.h"

namespace deckpipe {

class PipeService : public Service {
 public:
  // Sends from the address that `own` claims.
  explicit PipeService(const ClaimService& own) : m_own(own) {}

  void linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) override;
  std::optional<Refusal> intentCame(Instant now, const Live& live, const Intent& intent,
                                    Outgoing& out) override;
  void received(Instant now, const Live& live, const Frame& frame, Outgoing& out) override;
  void writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome, Outgoing& out) override;
  void timeCame(Instant now, const Live& live, Outgoing& out) override;
  Instant nextTime() const override;
  // What is in flight is in doubt then, what waits is dropped.
  void end(Instant now, const Live& live, EndReason reason, Outgoing& out) override;
  Address source() const override { return m_own.address(); }
  void status(const Live& live, ServiceStatus& into) const override;

 private:
  Pipe& pipe(const DeviceKey& device);
  Pipe* find(const DeviceKey& device);
  // The pipe of an address is the device's there once its PIN is known.
  void adopt(const Pipe::Turn& turn);

  const ClaimService& m_own;
  std::vector<Pipe> m_pipes;
};

}  // namespace deckpipe
