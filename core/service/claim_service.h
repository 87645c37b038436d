// SPDX-License-Identifier: GPL-3.0-or-later
// The console's own address on the bus (SAE J1939-81; CAN Messaging manual, Appendix A). Started when sending
// is unlocked on a link that is up, stopped when it is locked or the link goes. Services calls it.
//
// 1. First it asks who is there, from the null address, and listens kListen, so as to disturb nobody.
// 2. An address may be used kClaimTime after it was claimed, unless a numerically lower NAME claimed it too.
// 3. The loser claims the next address that nobody is known to use, F9 and FA first; where there is none it
//    says 'cannot claim' from the null address, 0-153 ms later, and whenever it is asked.
// 4. Every request for the NAME, to all or to our address, is answered.
// 5. Another node with our very NAME cannot be contested: it is reported, and nothing more is sent.
// 6. A joystick's or a monitor's address is never preferred, whatever the settings say: F9 replaces it.
// 7. A monitor's address (80..F7 hex) is claimed only where F9 and FA are taken, from the top, and only if no
//    frame was ever heard from it. It is given up at once when anybody else claims it or sends from it.
#pragma once

#include <bitset>

#include "control/status.h"
#include "protocol/address_use.h"
#include "service/live.h"

namespace deckpipe {

struct ClaimSettings {
  std::uint32_t identityNumber = 1;  // up to kLargestIdentity, this installation's own
  Address preferred = kServiceTool1;
};

// Our NAME: function 129 (off-board service tool), industry group 0, may take any address. Manufacturer code
// 2047, all ones, as Deckpipe has none from SAE: it also loses every contest against an equal NAME that has.
Name consoleName(std::uint32_t identityNumber);

class ClaimService {
 public:
  static constexpr Duration kListen = 250ms;

  explicit ClaimService(const ClaimSettings& settings);

  void start(Instant now, const Live& live, Outgoing& out);
  void stop();
  void received(Instant now, const Live& live, const Frame& frame, Outgoing& out);
  void timeCame(Instant now, const Live& live, Outgoing& out);
  Instant nextTime() const { return m_deadline; }
  // From our address, or the null address before there is one.
  void askNames(const Live& live, Outgoing& out);

  const ClaimStatus& status() const { return m_status; }
  // To send from; null unless claimed.
  Address address() const {
    return m_status.progress == ClaimStatus::Progress::Claimed ? m_status.address : kNullAddress;
  }

 private:
  using Progress = ClaimStatus::Progress;

  void claimNext(Instant now, const Live& live, Outgoing& out);
  void claim(Instant now, const Live& live, Address address, Outgoing& out);
  void cannotClaim(Instant now, const Live& live, Outgoing& out);
  void sendName(const Live& live, Address from, Outgoing& out) const;
  void claimHeard(Instant now, const Live& live, Address source, Name name, Outgoing& out);
  void addressLost(Instant now, const Live& live, Outgoing& out);
  bool isFree(const Live& live, Address address) const;

  ClaimSettings m_settings;
  ClaimStatus m_status;
  std::bitset<256> m_ours;  // we used it: that it was heard says nothing
  std::bitset<256> m_lost;  // and others hold it since
  Instant m_deadline = kNever;
  std::uint32_t m_spread;  // of the delays of 'cannot claim'
};

}  // namespace deckpipe
