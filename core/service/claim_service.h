// SPDX-License-Identifier: GPL-3.0-or-later
// An address of our own on the bus (SAE J1939-81; CAN Messaging manual, Appendix A), claimed as long as
// sending is unlocked on a link that is up. Others send from it. There may be several: each controller
// application has a NAME and an address of its own.
//
// 1. First it asks who is there, from the null address, and listens kListen, so as to disturb nobody.
// 2. An address may be used kClaimTime after its claim was on the bus, unless a numerically lower NAME claimed
//    it too. Where the adapter has no echo the time counts from when it took the claim.
// 3. The loser claims the next address that nobody is known to use, F9 and FA first; where there is none it
//    says 'cannot claim' from the null address, 0-153 ms later, and whenever it is asked.
// 4. Every request for the NAME, to all or to our address, is answered. A request for anything else to our address
//    is answered too: we have it not (J1939-21, negative acknowledgement). Those to all are not.
// 5. A frame from our address that we did not send is a conflict: we claim again, and move when it goes on. What
//    comes before anything of ours may be our own of an earlier run, which the adapter kept.
//    Without echoes our own frames cannot be told from another's, and this is not watched.
// 6. Another node with our very NAME cannot be contested: it is reported, and nothing more is sent. Our own claim
//    of an earlier run, which the adapter kept, is none: it comes before anything of ours.
// 7. The console never prefers a joystick's or a monitor's address, whatever the settings say. F9 replaces it.
// 8. A monitor's address (80..F7 hex) is claimed only where F9 and FA are taken, from the top, and only if no
//    frame was ever heard from it. It is given up at once when anybody else claims it or sends from it.
#pragma once

#include <bitset>

#include "bus/j1939.h"
#include "control/status.h"
#include "protocol/address_book.h"
#include "service/service.h"

namespace deckpipe {

// Which controller application of this installation it is, and which addresses it takes. By default the
// console itself, as a service tool.
struct ClaimSettings {
  std::uint32_t identityNumber = 1;  // up to kLargestIdentity, this installation's own
  Address preferred = kServiceTool1;
  Address second = kServiceTool1, third = kServiceTool2;  // where the preferred one is taken
  // Then the free one with the highest number: Akron's devices claim theirs from 80 hex up.
  Address lowest{0x80}, highest = kLastDynamic;
  std::uint8_t function = kServiceToolFunction;  // of the NAME
  std::uint8_t functionInstance = 0;             // of the NAME, 0..31
  // Its address is the console's own in the log and in ServiceStatus::claim, and it asks for NAMEs.
  bool isConsole = true;
};

// Our NAME: industry group 0, may take any address. Manufacturer code 2047, all ones, as Deckpipe has none
// from SAE: it also loses every contest against an equal NAME that has.
Name nameOf(const ClaimSettings& settings);
// The console's own, with the default function.
inline Name consoleName(std::uint32_t identityNumber) {
  return nameOf(ClaimSettings{.identityNumber = identityNumber});
}

class ClaimService : public Service {
 public:
  static constexpr Duration kListen = 250ms;

  // From a claim that the adapter refused twice to the next try.
  static constexpr Duration kClaimAgain = 1s;
  // A conflict is over when nobody else was heard at our address for so long.
  static constexpr Duration kConflictOver = 10s;
  // From one negative acknowledgement to the next: a node that asks without end must not fill the bus twice.
  static constexpr Duration kDeclineAgain = 100ms;

  explicit ClaimService(const ClaimSettings& settings, bool echoes = true);

  void linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) override;
  std::optional<Refusal> intentCame(Instant now, const Live& live, const Intent& intent,
                                    Outgoing& out) override;
  void received(Instant now, const Live& live, const Frame& frame, Outgoing& out) override;
  void writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome, Outgoing& out) override;
  void timeCame(Instant now, const Live& live, Outgoing& out) override;
  Instant nextTime() const override { return m_deadline; }
  void end(Instant now, const Live& live, EndReason reason, Outgoing& out) override;
  bool endsLast() const override { return true; }
  Address source() const override { return kNullAddress; }
  void status(const Live& live, ServiceStatus& into) const override;

  // For others to send from; null unless claimed.
  Address address() const {
    return m_status.progress == ClaimStatus::Progress::Claimed ? m_status.address : kNullAddress;
  }

  // Another node was heard sending from it within kConflictOver: an answer to it may be the other node's.
  bool isDisputed() const { return m_status.isDisputed; }

 private:
  using Progress = ClaimStatus::Progress;
  using How = note::OwnAddress::How;

  void start(Instant now, const Live& live, Outgoing& out);
  void stop(const Live& live, How why, Outgoing& out);
  void askNames(const Live& live, Outgoing& out);
  void noteAddress(const Live& live, Address address, How how, Outgoing& out) const;
  void claimNext(Instant now, const Live& live, Outgoing& out);
  void claim(const Live& live, Address address, Outgoing& out);
  void cannotClaim(Instant now, const Live& live, Outgoing& out);
  FrameTag sendName(const Live& live, Address from, Outgoing& out) const;
  void leave(Instant now, const Live& live, How why, Outgoing& out);
  void dispute(const Live& live, Outgoing& out);
  void strangerHeard(Instant now, const Live& live, Outgoing& out);
  void requestHeard(Instant now, const Live& live, const J1939Id& id, const Frame& frame, Outgoing& out);
  void claimHeard(Instant now, const Live& live, Address source, Name name, Outgoing& out);
  bool isFree(const Live& live, Address address) const;

  ClaimSettings m_settings;
  ClaimStatus m_status;
  std::bitset<256> m_ours;  // we used it: that it was heard says nothing
  std::bitset<256> m_lost;  // and others hold it since
  Instant m_deadline = kNever;
  FrameTag m_claim;              // the NAME that claims the present address
  Instant m_conflict = kNotYet;  // we claimed again because another sends from our address
  Instant m_declined = kNotYet;  // the last negative acknowledgement
  bool m_hasSpoken = false;      // something of ours was on the bus since it began
  bool m_echoes;
  std::uint32_t m_spread;  // of the delays of 'cannot claim'
};

}  // namespace deckpipe
