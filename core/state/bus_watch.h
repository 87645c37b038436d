// SPDX-License-Identifier: GPL-3.0-or-later
// What was last told of one channel: who holds which address, its joysticks, its load and its errors. EventWalk owns
// one for each channel.
#pragma once

#include <array>
#include <bitset>
#include <span>
#include <vector>

#include "state/device_watch.h"
#include "state/event.h"
#include "state/stick_watch.h"

namespace deckpipe {

// A device that is heard so long after the first frame of its channel was not there before.
inline constexpr Duration kSettling = kSilentAfter;

class BusWatch {
 public:
  // Load, in percent of a whole second, that is told as high, and below which it is normal again.
  static constexpr std::int64_t kHigh = 80, kNormal = 60;
  // A bus that carried more of the assumed rate in one second runs at another one. Up to there the estimate of stuff
  // bits errs, and what an adapter handed over late is counted in the second in which it came.
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
  // It is up again: whoever is heard now is compared with nobody of before but by its PIN. `devices`: of before.
  void linkCameBack(std::span<const DeviceWatch> devices);
  // A device is known by its PIN, and is heard since then; kNotYet: since before its channel had settled. Behind a gap
  // that tells, the first time, that it was not known before, or that it had another address then. `toldAs`: see
  // DeviceWatch.
  void pinCame(const State& state, const Device& device, Instant since, EventKind toldAs,
               std::vector<Event>& out);
  void errorCame(const State& state, std::vector<Event>& out);
  // A NAME was sent, or a contest for an address decided. Comes before DeviceWatch::lookAtIdentity().
  void lookAtHolders(const State& state, std::span<DeviceWatch> devices, std::vector<Event>& out);
  // A NAME said that it can claim no address. Comes before lookAtHolders().
  void cannotClaim(const State& state, Name name, std::span<DeviceWatch> devices, std::vector<Event>& out);
  // A NAME was sent from an address.
  void claimed(Address address, Name name);
  // Fills in the NAMEs of an event AddressLost that PINs have shown: that of the loser, and that of the one with
  // `pin`. Both have claimed the address, or the log does not hold them.
  void nameParties(Event& lost, const Pin& pin) const;
  // Statuses, NAMEs or PINs may show two devices at one address.
  void lookAtShared(const State& state, std::vector<Event>& out);
  // A basic message came. Returns whether the source had sent none of the right length for a while.
  bool stickCame(const State& state, Address source, std::vector<Event>& out);
  // A message that a device of Akron's repeats came from an address at which the state knows none: one of a wrong
  // length makes no device.
  void strangerCame(Address source, Instant time) {
    Instant& since = m_strangerSince[source.value];
    if (since == kNotYet) since = time;
  }
  // The same of a node, whether the state knows one or not: it takes more than one message to believe in it.
  void nodeCame(NodeId node, Instant time) {
    Instant& since = m_nodeSince[node.value & 0x7F];
    if (since == kNotYet) since = time;
  }
  // Since when a device is heard that the state has come to know now.
  Instant heardSince(const Device& device, Instant now) const;
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
  // Which address the NAME at this one held before; null: none.
  Address formerAddress(Address address, Instant now) const;
  bool isShared(Address a) const { return m_shared[a.value]; }
  // Who is new on this channel its PIN tells.
  bool isBehindGap() const { return m_isBehindGap; }

 private:
  template <std::size_t N>
  static constexpr std::array<Instant, N> neverHeard() {
    std::array<Instant, N> times;
    times.fill(kNotYet);
    return times;
  }
  void beginSecond(const State& state);
  void judgeLoad(const State& state, std::vector<Event>& out);
  void compareLoad(const State& state, std::vector<Event>& out);
  void compareErrors(const State& state, std::vector<Event>& out);
  void compareController(const State& state, std::vector<Event>& out);

  Channel m_channel;
  Instant m_first = kNotYet;
  Instant m_sharedDue = kNever, m_contestsDue = kNever, m_sticksDue = kNever, m_retry = kNever;

  std::array<Name, 256> m_holders{};
  std::array<Name, 256> m_formerHolders{};  // by the address that each held last and lost
  std::array<Instant, 256> m_heldSince{};
  std::array<std::array<Name, 2>, 256> m_claims{};  // the last two NAMEs that claimed each address
  std::vector<Name> m_cannotClaim;                  // those of which it was told
  std::array<TellCount, 256> m_losses;              // by address
  std::bitset<256> m_shared;
  std::array<Instant, 256> m_strangerSince = neverHeard<256>();
  std::array<Instant, 128> m_nodeSince = neverHeard<128>();
  std::array<StickWatch, Joysticks::kMax> m_sticks;
  struct KnownPin {
    Pin pin;
    Address address;       // the last one that it had before the last gap; null: none
    bool isBack = false;   // it has an address since then
    bool hasLost = false;  // the address, to another device
  };
  std::vector<KnownPin> m_knownPins;  // once there was a gap
  bool m_isBehindGap = false;
  std::bitset<256> m_wereNameless;  // addresses of Akron devices before the gap that no known PIN had

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

// What was last told of the nodes of one channel that are no devices of Akron's: drives, other makers' nodes. They are
// known by their address alone. Whether they are heard is all that is told of them. EventWalk owns one for each
// channel.
class NodeWatch {
 public:
  explicit NodeWatch(Channel channel) : m_channel(channel) {}

  // A J1939 frame came from `source`.
  void heard(const State& state, Address source, std::vector<Event>& out) {
    if (m_silences[source.value].isSilent()) {
      m_silences[source.value].end(state.cursor().time);
      compare(state, source, out);
    }
    if (m_due == kNever) m_due = state.cursor().time + kSilentAfter;
  }
  // The link of its channel went up or down: nothing can be heard while it is down, which is told by itself.
  void linkChanged(Instant time) {
    m_linkChanged = time;
    m_due = time + kSilentAfter;
  }
  // Whatever is due by the state's time.
  void timeCame(const State& state, std::vector<Event>& out);

  // Nothing changes before then unless a frame comes.
  Instant due() const { return m_due; }

 private:
  void compare(const State& state, Address address, std::vector<Event>& out) {
    m_silences[address.value].compare(eventAt(state, m_channel, {}, address), m_due, out);
  }

  Channel m_channel;
  Instant m_linkChanged = kNotYet;
  Instant m_due = kNever;
  std::array<Silence, 256> m_silences;
};

}  // namespace deckpipe
