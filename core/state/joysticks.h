// SPDX-License-Identifier: GPL-3.0-or-later
// Who sends joystick messages on one channel, how regularly, and what each asks for now.
// Source: CAN Messaging manual, PGN 64982, 64983 and Appendix B (20 ms from Akron devices, 100 ms at most,
// after 200 ms the controller clears that source's input).
#pragma once

#include <array>
#include <span>

#include "bus/frame.h"
#include "log/time_grain.h"
#include "protocol/address_book.h"
#include "protocol/typed.h"
#include "state/timed.h"

namespace deckpipe {

inline constexpr Duration kInputTimeout = 200ms;

struct Joystick {
  Address source = kNullAddress;
  Reported<&BasicJoystick::of> basic;
  Reported<&ExtendedJoystick::of> extended;
  std::uint32_t frames = 0;
  std::uint32_t timeouts = 0;  // how often more than kInputTimeout passed without a basic message
  bool timedOut = false;       // now: controllers have cleared this source's input
  bool isFormer = false;       // not heard since the link came back: nobody knows whether any do
  Duration period{0};          // smoothed over about eight messages
  Duration worstGap{0};        // between two basic messages; silences above kSilence are none

  static constexpr Duration kSilence = 2s;
  // 0 for 33 hex .. 5 for 38 hex; nothing where controllers do not listen to this source by default.
  std::optional<int> priority() const {
    if (!isJoystickAddress(source)) return {};
    return source.value - kFirstJoystick.value;
  }
  // Whether any message of its had a right length.
  bool isUnderstood() const { return basic.isKnown() || extended.isKnown(); }
  // Whether the source sends now: controllers hold its input.
  bool isActive() const { return basic.isKnown() && !timedOut && !isFormer; }
  friend bool operator==(const Joystick&, const Joystick&) = default;
};

class Joysticks {
 public:
  static constexpr std::size_t kMax = 8;  // 33..38 and two that controllers do not listen to

  // In order of first appearance; those never used have the null address.
  std::span<const Joystick> all() const { return m_sticks; }
  const Joystick* find(Address source) const;

  void heardBasic(Address source, const Frame& frame, Instant time);
  void heardExtended(Address source, const Frame& frame, Instant time);
  // A joystick message of a wrong length came: a source that sends nothing else is known, and asks for nothing.
  void heardMalformed(Address source) { at(source); }
  // Whether times are good to the second.
  void setCoarse(bool areCoarse) { m_areCoarse = areCoarse; }
  // The link came up; kNever: it went down, and no source times out.
  void listensSince(Instant time) { m_listensSince = time; }
  // Frames come again after the link was down: no source is expected to be on this bus.
  void linkCameBack();
  Instant nextDeadline() const;
  void timeCame(Instant time);

  friend bool operator==(const Joysticks&, const Joysticks&) = default;

 private:
  Joystick* at(Address source);
  Instant timeoutOf(const Joystick& stick) const;

  std::array<Joystick, kMax> m_sticks{};
  Instant m_listensSince = kNotYet;
  bool m_areCoarse = false;
};

}  // namespace deckpipe
