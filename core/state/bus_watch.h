// SPDX-License-Identifier: GPL-3.0-or-later
// What was last told of one channel: who holds which address, its joysticks, its load and its errors. EventWalk owns
// one for each channel.
#pragma once

#include <array>
#include <bitset>
#include <span>
#include <vector>

#include "state/device_watch.h"
#include "state/stick_watch.h"

namespace deckpipe {

// A device that is heard so long after the first frame of its channel was not there before.
inline constexpr Duration kSettling = kSilentAfter;

class BusWatch {
 public:
  // Load, in percent of a whole second, that is told as high, and below which it is normal again.
  static constexpr std::int64_t kHigh = 80, kNormal = 60;
  // A bus that carried more of the assumed rate in one second runs at another one. Up to there the estimate of stuff bits errs, and what
  // an adapter handed over late is counted in the second in which it came.
  static constexpr std::int64_t kFaster = 130;
  static constexpr Duration kErrorPause = 1s;  // that ends a burst of error frames

  explicit BusWatch(Channel channel) : m_channel(channel) {}

  // A frame of this channel came. Returns whether due() may be sooner now.
  bool heard(const State& state) {
    if (m_secondEnd != kNever) return false;
    beginSecond(state);
    return true;
  }
  // The link went up or down, and nothing is known any more of its controller.
  void linkChanged(const State& state);
  void errorCame(const State& state, std::vector<Event>& out);
  // A NAME was sent, or a contest for an address decided. Comes before DeviceWatch::lookAtIdentity().
  void lookAtHolders(const State& state, std::span<DeviceWatch> devices, std::vector<Event>& out);
  // A NAME said that it can claim no address. Comes before lookAtHolders().
  void cannotClaim(const State& state, Name name, std::span<DeviceWatch> devices, std::vector<Event>& out);
  // Statuses, NAMEs or PINs may show two devices at one address.
  void lookAtShared(const State& state, std::vector<Event>& out);
  // A basic message came. Returns whether the source had sent none of the right length for a while.
  bool stickCame(const State& state, Address source, std::vector<Event>& out);
  // Whatever is due by the state's time, but for contests.
  void timeCame(const State& state, std::vector<Event>& out);

  // Nothing changes before then unless a frame comes.
  Instant due() const {
    return std::min({m_secondEnd, m_burstEnd, m_sharedDue, m_contestsDue, m_sticksDue, m_retry});
  }
  // When its joysticks need to be looked at, of that.
  Instant sticksDue() const { return m_sticksDue; }
  // When the next contest is decided.
  Instant contestsDue() const { return m_contestsDue; }
  // Whether whoever is heard for the first time was not there before.
  bool isSettled(Instant now) const { return m_first != kNotYet && now - m_first >= kSettling; }
  // Where the NAME at this address was before; null: nowhere.
  Address formerAddress(Address address) const;
  bool isShared(Address a) const { return m_shared[a.value]; }

 private:
  void beginSecond(const State& state);
  void judgeLoad(const State& state, std::vector<Event>& out);
  void compareLoad(const State& state, std::vector<Event>& out);
  void compareErrors(const State& state, std::vector<Event>& out);
  void compareController(const State& state, std::vector<Event>& out);

  Channel m_channel;
  Instant m_first = kNotYet;
  Instant m_sharedDue = kNever, m_contestsDue = kNever, m_sticksDue = kNever, m_retry = kNever;

  std::array<Name, 256> m_holders{};
  std::array<Name, 256> m_formerHolders{};  // by the address that each lost last
  std::array<Instant, 256> m_heldSince{};
  std::vector<Name> m_cannotClaim;      // those of which it was told
  std::array<TellCount, 256> m_losses;  // by address
  std::bitset<256> m_shared;
  std::array<StickWatch, Joysticks::kMax> m_sticks;

  Instant m_secondEnd = kNever;                     // of the second whose load is counted
  std::uint64_t m_bits = 0;                         // of the channel when it began
  std::int64_t m_percent = 0, m_percentBefore = 0;  // of the last whole second, and of the one before
  bool m_isFaster = false;                          // its rate is not said, and it carried more than kFaster
  EventSlot m_load{0};
  Instant m_burstEnd = kNever;  // unless another error frame comes
  std::uint64_t m_errors = 0;   // since the present burst was told
  EventSlot m_burst{0};
  EventSlot m_controller{static_cast<std::uint64_t>(EventKind::ErrorActive)};
};

}  // namespace deckpipe
