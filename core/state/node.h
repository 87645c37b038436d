// SPDX-License-Identifier: GPL-3.0-or-later
// One J1939 address of one channel: who holds it and how that went.
#pragma once

#include <cstdint>

#include "base/time.h"
#include "protocol/typed.h"
#include "state/frame_rate.h"

namespace deckpipe {

// J1939-81: an address is usable this long after it was claimed, unless contested.
inline constexpr Duration kClaimTime = 250ms;

enum class ClaimState : std::uint8_t {
  NoClaim,   // heard, but no NAME
  Claiming,  // claimed less than kClaimTime ago
  Claimed,
  Contested,    // another NAME claimed it too; the holder has kClaimTime to answer
  CannotClaim,  // its holder said that it could not claim any
};

struct Node {
  Name name;  // of the holder; 0 = none heard
  Instant lastHeard = kNotYet;
  Instant claimedAt = kNotYet;  // of the last claim that started or contested a holding
  std::uint32_t frames = 0;
  FrameRate rate;
  std::uint16_t malformed = 0;   // stays at its most
  std::uint16_t claimsWon = 0;   // contests that the holder at that time kept the address in
  std::uint16_t claimsLost = 0;  // … and lost it in
  ClaimState claim = ClaimState::NoClaim;
  bool wasLeft =
      false;  // the device that was here announced another address, and nobody was heard here since

  bool isHeard() const { return lastHeard != kNotYet; }
  friend bool operator==(const Node&, const Node&) = default;
};

}  // namespace deckpipe
