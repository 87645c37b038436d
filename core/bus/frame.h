// SPDX-License-Identifier: GPL-3.0-or-later
// One CAN frame as it is kept: 24 bytes, nothing else. Adapters, files and services all make these.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/bits.h"
#include "base/ids.h"

namespace deckpipe {

// The stamp of a frame whose log gives no time.
inline constexpr std::int64_t kNoStamp = std::numeric_limits<std::int64_t>::min();

// Identifier bits above the 29, as SocketCAN has them.
inline constexpr std::uint32_t kExtendedBit = 0x8000'0000;
inline constexpr std::uint32_t kRemoteBit = 0x4000'0000;
inline constexpr std::uint32_t kErrorBit = 0x2000'0000;
inline constexpr std::uint32_t kIdMask = 0x1FFF'FFFF;

struct Frame {
  enum Flag : std::uint8_t {
    kSent = 1,       // by us (live) or marked as transmitted (file)
    kConfirmed = 2,  // a frame of ours that came back as an echo
    kTimeJump = 4,   // the clock of the stamps steps at this frame
    kLate = 8,       // handled so late (live) that its log time is later than its stamp says
  };

  std::int64_t stamp = kNoStamp;  // ns; what the adapter or the file says; shown, never used for order
  std::uint32_t id = 0;           // with kExtendedBit, kRemoteBit, kErrorBit
  Payload data{};                 // bytes past length are zero
  std::uint8_t channel = 0;
  std::uint8_t length = 0;  // 0..8; of a remote frame the length asked for
  std::uint8_t flags = 0;
  std::uint8_t spare = 0;

  constexpr bool isExtended() const { return (id & kExtendedBit) != 0; }
  constexpr bool isRemote() const { return (id & kRemoteBit) != 0; }
  constexpr bool isError() const { return (id & kErrorBit) != 0; }
  constexpr bool hasStamp() const { return stamp != kNoStamp; }
  constexpr std::uint32_t identifier() const { return id & kIdMask; }
  constexpr std::span<const std::uint8_t> bytes() const {
    return {data.data(), isRemote() ? 0u : static_cast<std::size_t>(length)};
  }

  friend constexpr bool operator==(const Frame&, const Frame&) = default;
};
static_assert(sizeof(Frame) == 24);

}  // namespace deckpipe
