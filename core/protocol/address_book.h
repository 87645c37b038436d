// SPDX-License-Identifier: GPL-3.0-or-later
// Who is at each J1939 address of one channel, and which CANopen nodes there are Akron's: the one place that
// works it out (protocol.md 1.3, "Whose message is it" and "Who holds an address"; SAE J1939-81). State, the
// index of roles, the headless tool and the services ask a book.
//
// A book is a function of the frames and of what the person said before, and of log time. Whoever walks a log
// keeps one a channel. For each frame, in order: timeCame(), then classify() with the book, then observe().
//
//   1. The first NAME heard at an address holds it. A numerically lower NAME takes it at once.
//   2. A higher NAME contests it, and takes it kClaimTime later unless the holder answers with its own NAME.
//      Of several that contest it the lowest counts, from the first claim on. One that claims elsewhere, or
//      says 'cannot claim', has given up. In a log without times a higher NAME takes the address at once.
//      The NAME of another maker contests the address of a device that sends statuses of Akron's even as a lower or
//      the first one: whoever claims an address may not send from it within kClaimTime. If statuses go on meanwhile,
//      the device has not given way, and there are two. The address stays contested until the statuses have stopped
//      for one to two seconds, or until either claims elsewhere. Where neither a NAME nor a PIN is known, a NAME
//      within 2 s after a request for it may be the device's own, and takes the address at once.
//   3. 'Cannot claim' frees every address that the NAME holds. Whoever contested one takes it then.
//   4. A NAME that takes an address takes it clean: what was known there is dropped. Kept are the PIN whose
//      NAME it is, and what was known before any NAME was heard, if the NAME is Akron's.
//   5. A drive stays where the person said until a NAME other than the one before takes the address.
//   6. An announcement to all tells the PIN at its source. A PIN is at one address only: its last.
//   7. Claims from the global address or with NAME 0 mean nothing.
//   8. While the link was down, which is a gap of the log, another bus may have come to the plug. Behind a gap nobody
//      holds an address, and no role holds there, until a NAME or an announcement is heard from it anew; what was known
//      is told as former. The former PIN is current again if it is announced, or if the very NAME that was there claims
//      the address. Messages of what was Akron's are presumed. A drive stays where the person said.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "base/ids.h"
#include "base/time.h"
#include "bus/frame.h"
#include "protocol/classify.h"
#include "protocol/lists.h"
#include "protocol/name.h"
#include "protocol/open_requests.h"

namespace deckpipe {

// Which addresses a program on the bus may choose for itself. On a joystick's address it would be obeyed as
// that joystick, on a monitor's it would push the monitor off: a NAME decides who keeps an address, and ours
// may be the lower one. The tool's option, the settings of the window and the claim service all ask this.
// Sources: CAN Messaging manual, Appendix A and B; SAE J1939-81.

// Controllers obey joystick messages from these; the first has the highest priority.
inline constexpr Address kFirstJoystick{0x33}, kLastJoystick{0x38};
// Devices that may take any address claim theirs from these. Akron's begin at the first.
inline constexpr Address kFirstDynamic{0x80}, kLastDynamic{0xF7};
// Off-board service tools.
inline constexpr Address kServiceTool1{0xF9}, kServiceTool2{0xFA};
// What the NAME of such a tool, and so of every console of ours, has as its function.
inline constexpr std::uint32_t kServiceToolFunction = 129;

constexpr bool isJoystickAddress(Address a) { return a >= kFirstJoystick && a <= kLastJoystick; }
constexpr bool isDynamicAddress(Address a) { return a >= kFirstDynamic && a <= kLastDynamic; }

enum class AddressUse : std::uint8_t {
  Ok,
  Warn,     // below 80 hex: SAE gave it to a device, which may be on this bus
  Refused,  // a joystick's or a monitor's, or no address at all (FE, FF)
};

// What a person should know who wants this address for the console.
constexpr AddressUse addressUse(Address a) {
  if (isJoystickAddress(a) || isDynamicAddress(a) || a >= kNullAddress) return AddressUse::Refused;
  return a < kFirstDynamic ? AddressUse::Warn : AddressUse::Ok;
}

// J1939-81: an address is usable this long after it was claimed, unless contested.
inline constexpr Duration kClaimTime = 250ms;

enum class ClaimState : std::uint8_t {
  NoClaim,   // no NAME heard
  Claiming,  // claimed less than kClaimTime ago
  Claimed,
  Contested,    // another NAME claimed it too, and who will have it is not decided
  CannotClaim,  // its holder said that it could not claim any
};

class AddressBook {
 public:
  // Addresses whose device is not there any more.
  using Lost = std::bitset<256>;

  // --- Whose messages are sent from an address. While it is contested: its holder's.

  bool isAkron(Address a) const { return holds(a, kAkron); }
  bool isForeign(Address a) const { return holds(a, kForeign); }
  // Akron's before the link was down, and nobody has said since who is there.
  bool wasAkron(Address a) const { return has(a, kFormer) && has(a, kAkron); }
  bool isDrive(Address a) const { return has(a, kDrive); }
  // Answered SDO 5000.01 with a part number.
  bool isAkronNode(NodeId node) const { return m_akronNodes[node.value & 0x7F]; }
  const OpenRequests& openRequests() const { return m_openRequests; }

  // --- Who is there.

  bool isHeld(Address a) const { return holds(a, kHeld); }
  // The NAME that holds it; 0 = none.
  Name holder(Address a) const { return isHeld(a) ? lastHolder(a) : Name{}; }
  // The NAME that holds it, or did until it said 'cannot claim'; 0 = none.
  Name lastHolder(Address a) const { return has(a, kFormer) ? Name{} : m_names[a.value]; }
  // Null while none was announced there.
  Pin pin(Address a) const;
  // The NAME that held it and the PIN that was there when the link went down, as long as nobody has said since who is
  // there.
  Name formerHolder(Address a) const { return has(a, kFormer) && has(a, kHeld) ? m_names[a.value] : Name{}; }
  Pin formerPin(Address a) const;
  // Where a PIN was so; null: nowhere.
  Address formerAddress(const Pin& pin) const;
  // Any frame came from there.
  bool isHeard(Address a) const { return has(a, kHeard); }
  // The PIN that was here was announced elsewhere, and nothing was heard from here since.
  bool wasLeft(Address a) const { return has(a, kLeft); }
  // Nothing may be sent to it: who will have it is not decided.
  bool isContested(Address a) const { return has(a, kContested); }
  // Since when two devices have said that it is theirs, neither giving way; kNotYet: they do not. The statuses of one
  // go on though the NAME of another maker has claimed it (rule 2). Or two NAMEs have taken it, or two PINs were
  // announced there, in turn: the first one again a second or more after its first time, at most 10 s from turn to
  // turn, and the last not more than a minute ago. On a lawful bus whoever loses an address claims another one, says
  // that it cannot, or is gone. When a NAME does either of the first two, its turns and those of the PINs that may
  // have it are forgotten; so are those of a PIN that is announced elsewhere.
  Instant sharedSince(Address a, Instant now) const;
  // `now` is the log time that is looked at, not before the last frame.
  ClaimState claim(Address a, Instant now) const;
  // Contests that a holder kept the address in, and lost it in, to a lower NAME or for want of an answer. They are
  // counted from where the link came back.
  std::uint16_t claimsWon(Address a) const { return m_won[a.value]; }
  std::uint16_t claimsLost(Address a) const { return m_lost[a.value]; }

  // --- Feeding it.

  // The person says that a Copley drive is at this address, or takes it back.
  void sayDrive(Address a, bool isDrive);
  // Nothing is heard from now on: no contest can be decided.
  void linkWentDown();
  // Frames come again after that.
  void linkCameBack();
  // Learns from a frame that was classified with this book. Returns whether anything changed; adds to `lost`.
  bool observe(const Frame& frame, Instant time, const Classified& classified, Lost& lost) {
    return mayTeach(frame, classified) && learn(frame, time, classified, lost);
  }
  // Whether there is anything to learn: false of nearly every frame, so that it costs a look-up.
  bool mayTeach(const Frame& frame, const Classified& classified) const {
    const bool isNode = (frame.id & (kExtendedBit | kErrorBit)) == kExtendedBit;
    const Address source{static_cast<std::uint8_t>(frame.id)};
    return (isNode && (isNew(source) || isNewsOfReports(source, classified.message))) ||
           isLesson(classified.message);
  }
  // When the next contest is decided; kNever where there is none.
  Instant nextDecision() const { return m_nextDecision; }
  // Decides contests that are due at `time`. Returns whether there was any; adds to `lost`.
  bool timeCame(Instant time, Lost& lost) { return time >= m_nextDecision && decide(time, lost); }

  friend bool operator==(const AddressBook&, const AddressBook&) = default;

 private:
  enum : std::uint8_t {
    kAkron = 1,
    kForeign = 2,
    kDrive = 4,
    kHeard = 8,
    kHeld = 16,
    kContested = 32,
    kLeft = 64,
    kFormer =
        128,  // kAkron, kForeign, kHeld, the NAME and the PIN tell who was there when the link went down
  };
  static constexpr Duration kGivesWayAfter = 2s;  // after the last status that counts; one a second does
  struct Contest {
    Instant since = kNotYet;  // kNotYet: a free place
    Name challenger;
    Address address;
    MessageId report = MessageId::Count;  // the first status that came meanwhile
    bool goesOn = false;                  // more of its kind have come
    std::uint32_t reportedMs = 0;         // the last one that counts, so long after `since`; 49 days at most
    // When the challenger takes it.
    Instant due() const {
      if (since == kNotYet) return kNever;
      return goesOn ? since + reportedMs * 1ms + kGivesWayAfter : since + kClaimTime;
    }
    friend bool operator==(const Contest&, const Contest&) = default;
  };
  // An address went to another NAME or PIN.
  struct Turn {
    enum class By : std::uint8_t { Name, Pin };
    Instant time = kNotYet;  // kNotYet: a free place
    std::uint64_t who = 0;   // the NAME, or the announcement's bytes
    Address address;
    By by = By::Name;
    friend bool operator==(const Turn&, const Turn&) = default;
  };
  static constexpr std::size_t kTurns = 16;
  // More at once are not followed: the holders keep their addresses.
  static constexpr std::size_t kContests = 8;

  bool has(Address a, std::uint8_t flag) const { return (m_flags[a.value] & flag) != 0; }
  bool holds(Address a, std::uint8_t flag) const { return (m_flags[a.value] & (flag | kFormer)) == flag; }
  void set(Address a, unsigned flag) {
    m_flags[a.value] = static_cast<std::uint8_t>(m_flags[a.value] | flag);
  }
  void clear(Address a, unsigned flag) {
    m_flags[a.value] = static_cast<std::uint8_t>(m_flags[a.value] & ~flag);
  }
  static constexpr bool isLesson(MessageId id) {
    return id == MessageId::Name || id == MessageId::Request || id == MessageId::AddressAnnouncement ||
           id == MessageId::SdoReadResponse || (id != MessageId::Count && kLooksAlikeBothWays[id]);
  }
  bool isNewsOfReports(Address source, MessageId id) const {
    return id != MessageId::Count && kIsOwnPeriodicReport[id] &&
           (!m_reporters[source.value] || isContested(source));
  }
  bool learn(const Frame& frame, Instant time, const Classified& classified, Lost& lost);
  // Not heard yet, or not since its device left.
  bool isNew(Address source) const { return (m_flags[source.value] & (kHeard | kLeft)) != kHeard; }
  bool heard(Address source);
  bool claimed(Address source, const Frame& frame, Instant time, Lost& lost);
  bool reported(Address source, MessageId id, Instant time);
  // Whether this NAME is of another device than the one that sends statuses from there, which may go on.
  bool mayGoOn(Address a, Name name, Instant time) const;
  bool answered(Address source, Instant time, Lost& lost);
  bool leaveTo(Name holder, Address except, Lost& lost);
  bool cannotClaim(Name name, Lost& lost);
  // The PIN stays.
  void forgetFormer(Address a);
  bool announced(Address source, const Frame& frame, Instant time, Lost& lost);
  bool exchanged(const Frame& frame, Instant time, const Classified& classified);
  void take(Address a, Name name, Instant since, Lost& lost);
  bool contest(Address a, Name challenger, Instant time);
  bool giveUpContests(Name challenger, Address except);
  void end(Contest& contest);
  void planDecision();
  Contest& contestAt(Address a);
  bool decide(Instant time, Lost& lost);
  void noteTurn(const Turn& turn);
  // Whoever is meant is elsewhere now, or nowhere: it shares no address but `except`.
  template <typename IsMeant>
  bool forgetTurns(IsMeant isMeant, Address except);
  // The latest turns of an address by NAME or PIN, the last first; null where there were fewer.
  std::array<const Turn*, 4> turnsOf(Address a, Turn::By by) const;

  std::array<std::uint8_t, 256> m_flags{};
  std::array<Name, 256> m_names{};
  std::array<std::uint64_t, 256> m_pins{};  // the announcement's bytes; 0 = none
  std::array<Instant, 256> m_claimedAt{};
  std::array<std::uint16_t, 256> m_won{}, m_lost{};
  std::array<Contest, kContests> m_contests{};
  std::array<Turn, kTurns> m_turns{};  // of all addresses, the latest first
  std::bitset<256> m_reporters;    // addresses that sent statuses of Akron's before any other NAME took them
  Instant m_namesAsked = kNotYet;  // the last request for NAMEs
  Instant m_nextDecision = kNever;
  std::bitset<128> m_akronNodes;
  OpenRequests m_openRequests;
};

}  // namespace deckpipe
