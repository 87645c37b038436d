// SPDX-License-Identifier: GPL-3.0-or-later
// The console's own joystick: PGN 64982 every 20 ms while a hand holds it, from an address of its own beside the
// console's. The rules are those of design.md section 7, whose numbers stand here. What only the window knows (its
// focus, its input device) is the window's: it says 'held' only while all of that is true.
//
// 1. Arming names every monitor that is heard; a controller that appears disarms (rule 1, motion_watch.h).
// 2. Its address is one of 33..38, silent for kSilence, claimed with a NAME of its own, kClaimTime waited. No joystick
//    of lower priority may be heard: that would be a person at the truck, outranked. From the address go joystick
//    messages and claims alone. Any foreign claim of it and any foreign frame from it ends all at once: one neutral
//    at most, 'cannot claim' once, silence (rule 3).
// 3. A link without echoes is refused. Where an echo does not prove that a frame was on the bus, the person must have
//    accepted that at this arming (rule 4).
// 4. 'Held' is an edge: after arming and after every cause 'not held' is wanted first, and then 'held' with the stick
//    at rest (rule 7). 'Held' that is older than kFresh is 'not held' (rule 6).
// 5. Frames have absolute deadlines; missed ones are skipped. When the thread stood still for more than kGap,
//    neutral goes out, never the old value (rule 10).
// 6. Neutral is said every 20 ms for kNeutralFor, then nothing. It is not said behind a motion frame that waits, but
//    for the first one, which goes at once; on a full queue that one is tried until it is taken (rules 10 and 11).
// 7. One motion frame at most is unconfirmed. After kUnconfirmed it disarms, and arming again needs the echo of all
//    that was written, or a link that went down. An old motion frame that goes out late is answered with
//    neutral, and said (rule 11).
//
// Its state machine is the table below, and changes nowhere else.
#pragma once

#include <array>
#include <vector>

#include "protocol/address_book.h"
#include "service/claim_service.h"
#include "service/motion_watch.h"

namespace deckpipe {

enum class JoystickMove : std::uint8_t {
  Arm,      // the person asked for it
  Silent,   // the address was silent for long enough
  Claimed,  // our claim is on the bus
  Settled,  // nobody has contested it
  Press,    // held, with the stick at rest, after it was not
  Stop,     // let go, or a cause after which it may be held anew
  Disarm,   // a cause that takes a new arming
  Yield,    // the address is another's
  Said,     // neutral was said for long enough
  Late,     // an old motion frame has gone out
  Count,
};

namespace joystick_table {
using enum JoystickStatus::Progress;
using Cell = std::optional<JoystickStatus::Progress>;
inline constexpr Cell No;  // does not happen, or is refused: nothing changes
// clang-format off
inline constexpr EnumTable<JoystickStatus::Progress, EnumArray<JoystickMove, Cell>> kTable{{
    //            Arm        Silent    Claimed   Settled Press Stop       Disarm  Yield Said   Late
    {Off,       {{Listening, No,       No,       No,     No,   No,        No,     Off,  No,    Ending}}},
    {Listening, {{No,        Claiming, No,       No,     No,   No,        Off,    Off,  No,    No}}},
    {Claiming,  {{No,        No,       Settling, No,     No,   No,        Off,    Off,  No,    No}}},
    {Settling,  {{No,        No,       No,       Armed,  No,   No,        Off,    Off,  No,    No}}},
    {Armed,     {{No,        No,       No,       No,     Held, No,        Off,    Off,  No,    No}}},
    {Held,      {{No,        No,       No,       No,     No,   Releasing, Ending, Off,  No,    No}}},
    {Releasing, {{No,        No,       No,       No,     Held, No,        Ending, Off,  Armed, No}}},
    {Ending,    {{No,        No,       No,       No,     No,   No,        No,     Off,  Off,   Ending}}},
}};
// clang-format on
}  // namespace joystick_table

// The state after a move; nothing where it does not happen in this state.
constexpr std::optional<JoystickStatus::Progress> after(JoystickStatus::Progress state, JoystickMove move) {
  return joystick_table::kTable[state][move];
}

class JoystickService : public Service {
 public:
  static constexpr Duration kPeriod = 20ms, kNeutralFor = 500ms, kSilence = 1s;
  static constexpr Duration kFresh = 100ms, kGap = 100ms, kUnconfirmed = 60ms;
  static constexpr Duration kLongestHold = 60s, kLongestArmed = 120s;
  static constexpr Duration kClaimPatience = 1s;  // for our claim to be on the bus
  static constexpr Duration kLook = 100ms;        // how often it looks around while armed
  static constexpr unsigned kMoreSendErrors = 8;  // of the adapter, between two readings

  enum class Echo : std::uint8_t {
    None,      // the link gives back nothing
    Unproven,  // what comes back need not have been on the bus
    Proven,
  };

  // Its NAME is that of the console with another function instance.
  JoystickService(const ClaimSettings& console, Echo echo);

  void linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) override;
  std::optional<Refusal> intentCame(Instant now, const Live& live, const Intent& intent,
                                    Outgoing& out) override;
  void received(Instant now, const Live& live, const Frame& frame, Outgoing& out) override;
  void controllerRead(Instant now, const Live& live, const ControllerReading& reading,
                      Outgoing& out) override;
  void writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome, Outgoing& out) override;
  void timeCame(Instant now, const Live& live, Outgoing& out) override;
  Instant nextTime() const override;
  void end(Instant now, const Live& live, EndReason reason, Outgoing& out) override;
  bool hasEnded() const override { return m_status.progress == Progress::Off; }
  // It claims by itself, as its address is given up for other reasons than the console's.
  Address source() const override { return kNullAddress; }
  void status(const Live&, ServiceStatus& into) const override { into.joystick = m_status; }

 private:
  using Progress = JoystickStatus::Progress;
  enum class Kind : std::uint8_t { Claim, Neutral, Motion };
  struct Written {
    FrameTag tag;
    Kind kind;
    Instant when;
  };

  Refusal arm(Instant now, const Live& live, const intent::ArmJoystick& wanted);
  Refusal hold(Instant now, const Live& live, const intent::HoldJoystick& wanted, Outgoing& out);
  Refusal press(Instant now, const Live& live, const intent::HoldJoystick& wanted, Outgoing& out);
  bool isSourceTaken(Instant now, const Live& live, Address source) const;
  // Whether the adapter's controller is in a state in which nothing may be moved.
  bool isInTrouble(const Live& live) const;
  MotionCause whyNot(Instant now, const Live& live);
  void look(Instant now, const Live& live, Outgoing& out);
  void stop(Instant now, const Live& live, MotionCause cause, Outgoing& out);
  void yield(Instant now, const Live& live, Outgoing& out);
  bool move(JoystickMove what);
  bool isActive() const {
    return m_status.progress != Progress::Off && m_status.progress != Progress::Ending;
  }
  bool isSaying() const {
    return m_status.progress == Progress::Releasing || m_status.progress == Progress::Ending;
  }
  bool maySend(Instant now) const;
  void beginNeutral(Instant now, const Live& live, Outgoing& out);
  void sayNeutral(Instant now, const Live& live, Outgoing& out);
  void keepHeld(Instant now, const Live& live, Outgoing& out);
  void say(Instant now, const Live& live, Deflection x, Deflection y, Outgoing& out);
  void sendName(Instant now, const Live& live, Address from, Outgoing& out);
  // Takes back what was put out and not written yet: joystick messages, or all.
  void withdraw(Outgoing& out, bool all);
  void deadlineCame(Instant now, const Live& live, Outgoing& out);
  void wasSaid(Instant at);
  void wentOutLate(Instant now, const Live& live, Outgoing& out);
  // When the oldest joystick message that is not confirmed was written; kNever if there is none.
  Instant oldestUnconfirmed() const;
  void noteEnd(const Live& live, bool isDisarmed, Outgoing& out) const;

  Name m_name;
  Echo m_echo;
  JoystickStatus m_status;
  MotionWatch m_watch;
  intent::ArmJoystick m_arming;  // the last one
  Deflection m_x, m_y;
  bool m_isOpen = false;
  bool m_hasClaimed = false;  // the address, and nobody has taken it since
  bool m_mustRelease = true;  // before it can be held
  Instant m_openSince = kNotYet;
  Instant m_endBy = kNever;                             // of an ending for good
  Instant m_deadline = kNever;                          // of the present state
  Instant m_next = kNever;                              // the next joystick message, or the next look around
  Instant m_lastTurn = kNotYet;                         // the last message was due
  Instant m_verified = kNotYet;                         // that it is held
  Instant m_firstSaid = kNotYet, m_lastSaid = kNotYet;  // joystick messages of this hold, on the bus
  Instant m_doubt = kNotYet;                            // an echo may have been lost
  unsigned m_neutrals = 0;                              // that the adapter took, in this phase
  std::vector<Written> m_written;                       // and not confirmed
  ControllerReading m_reading;
  // When another node last sent from each joystick's address.
  std::array<Instant, kLastJoystick.value - kFirstJoystick.value + 1> m_foreign;
};

}  // namespace deckpipe
