// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/joystick_service.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "bus/j1939.h"
#include "protocol/lists.h"
#include "protocol/typed.h"

namespace deckpipe {
namespace {

constexpr BitRange kAskedPgn = fieldOf(j1939::kRequestFields, "pgn").bits;

bool isTrouble(ControllerState state) {
  return state == ControllerState::BusOff || state == ControllerState::ErrorPassive ||
         state == ControllerState::Stopped || state == ControllerState::Sleeping;
}

Name joystickName(ClaimSettings settings) {
  settings.functionInstance ^= 1u;
  return nameOf(settings);
}

}  // namespace

JoystickService::JoystickService(const ClaimSettings& console, Echo echo)
    : m_name(joystickName(console)), m_echo(echo) {
  m_foreign.fill(kNotYet);
}

bool JoystickService::move(JoystickMove what) {
  const auto next = after(m_status.progress, what);
  if (next) m_status.progress = *next;
  return next.has_value();
}

bool JoystickService::maySend(Instant now) const {
  if (!m_isOpen) return false;
  return m_endBy == kNever || (m_status.progress == Progress::Ending && now < m_endBy);
}

void JoystickService::linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) {
  if (!isOpen) {
    // Nothing can be said any more, and what waits is gone with the link.
    const bool wasUsed = m_status.progress != Progress::Off;
    m_status.progress = Progress::Off;
    m_status.cause = MotionCause::LinkLost;
    if (wasUsed) noteEnd(live, true, out);
    m_written.clear();
  }
  m_status.progress = Progress::Off;
  m_isOpen = isOpen;
  m_openSince = now;
  m_hasClaimed = false;
  m_endBy = m_deadline = m_next = kNever;
  m_foreign.fill(kNotYet);
}

void JoystickService::end(Instant now, const Live& live, EndReason, Outgoing& out) {
  m_endBy = now + kEndingTime;
  stop(now, live, MotionCause::Locked, out);
}

std::optional<Refusal> JoystickService::intentCame(Instant now, const Live& live, const Intent& intent,
                                                   Outgoing& out) {
  if (const auto* wanted = std::get_if<intent::ArmJoystick>(&intent)) return arm(now, live, *wanted);
  if (const auto* wanted = std::get_if<intent::HoldJoystick>(&intent)) return hold(now, live, *wanted, out);
  if (const auto* wanted = std::get_if<intent::DisarmJoystick>(&intent)) {
    stop(now, live, wanted->cause, out);
    return Refusal::None;
  }
  return {};
}

bool JoystickService::isInTrouble(const Live& live) const {
  // What the driver says now is truer than the last error frame.
  const bool isRead = m_reading.state != ControllerState::Unknown;
  return isTrouble(isRead ? m_reading.state : live.bus().controller);
}

bool JoystickService::isSourceTaken(Instant now, const Live& live, Address source) const {
  const AddressBook& book = live.bus().book;
  if (book.isHeld(source) && book.holder(source).value != m_name.value) return true;
  const Instant heard = m_foreign[source.value - kFirstJoystick.value];
  return heard != kNotYet && now - heard < kSilence;
}

Refusal JoystickService::arm(Instant now, const Live& live, const intent::ArmJoystick& wanted) {
  if (m_status.progress != Progress::Off) return Refusal::Busy;
  if (!isJoystickAddress(wanted.source)) return Refusal::NotTaken;
  if (m_echo == Echo::None || (m_echo == Echo::Unproven && !wanted.acceptsUnproven))
    return Refusal::EchoUnproven;
  if (!m_written.empty() || (m_doubt != kNotYet && m_doubt >= live.bus().linkUp)) return Refusal::StillWaits;
  if (isSourceTaken(now, live, wanted.source)) return Refusal::SourceTaken;
  if (const Refusal why = m_watch.arm(now, live, wanted.source, wanted.moves); why != Refusal::None)
    return why;
  const JoystickStatus before =
      std::exchange(m_status, {.source = wanted.source,
                               .moves = wanted.moves,
                               .limit = std::clamp(wanted.limit, 0, Deflection::kFull)});
  const MotionCause cause = whyNot(now, live);
  if (cause != MotionCause::None) {
    m_status = before;
    return cause == MotionCause::BusTrouble ? Refusal::BusTrouble : Refusal::WouldOutrank;
  }
  m_arming = wanted;
  m_hasClaimed = false;
  m_mustRelease = true;
  move(JoystickMove::Arm);
  m_deadline = std::max(now, m_openSince + kSilence);
  m_next = now + kLook;
  return Refusal::None;
}

Refusal JoystickService::hold(Instant now, const Live& live, const intent::HoldJoystick& wanted,
                              Outgoing& out) {
  const bool isHeld = m_status.progress == Progress::Held;
  const bool isFresh = wanted.verified <= now && now - wanted.verified <= kFresh;
  if (!wanted.isHeld || !isFresh) {
    if (isHeld) stop(now, live, wanted.isHeld ? MotionCause::HandNotSeen : MotionCause::Released, out);
    m_mustRelease = m_mustRelease && wanted.isHeld;
    return Refusal::None;
  }
  if (!isHeld) return press(now, live, wanted, out);
  if (now - m_lastTurn > kGap) {
    stop(now, live, MotionCause::Gap, out);
    return Refusal::NotReleased;
  }
  m_verified = std::max(m_verified, wanted.verified);
  m_x = wanted.x.within(m_status.limit);
  m_y = wanted.y.within(m_status.limit);
  return Refusal::None;
}

Refusal JoystickService::press(Instant now, const Live& live, const intent::HoldJoystick& wanted,
                               Outgoing& out) {
  look(now, live, out);
  if (m_status.progress != Progress::Armed && m_status.progress != Progress::Releasing)
    return Refusal::NotArmed;
  m_mustRelease = m_mustRelease || !wanted.x.isAtRest() || !wanted.y.isAtRest();
  if (m_mustRelease) return Refusal::NotReleased;
  if (const MotionCause why = m_watch.press(now, live); why != MotionCause::None) {
    m_status.cause = why;
    m_mustRelease = true;
    return Refusal::Disabled;
  }
  move(JoystickMove::Press);
  m_x = m_y = {};
  m_status.cause = MotionCause::None;
  m_status.frames = 0;
  m_status.period = Duration{0};
  m_status.heldSince = now;
  m_firstSaid = m_lastSaid = kNotYet;
  m_verified = wanted.verified;
  m_deadline = now + kLongestHold;
  m_next = m_lastTurn = now;
  return Refusal::None;
}

MotionCause JoystickService::whyNot(Instant now, const Live& live) {
  if (isInTrouble(live)) return MotionCause::BusTrouble;
  const bool wouldOutrank = std::ranges::any_of(live.bus().joysticks.all(), [&](const Joystick& stick) {
    return stick.isActive() && stick.priority() && stick.source > m_status.source;
  });
  if (wouldOutrank) return MotionCause::WouldOutrank;
  const MotionCause cause = m_watch.whyNotArmed(now, live);
  if (cause != MotionCause::None || m_status.progress != Progress::Held) return cause;
  return m_watch.whyNotHeld(now, live, m_x, m_y);
}

void JoystickService::look(Instant now, const Live& live, Outgoing& out) {
  if (!isActive()) return;
  if (const MotionCause cause = whyNot(now, live); cause != MotionCause::None) stop(now, live, cause, out);
}

void JoystickService::stop(Instant now, const Live& live, MotionCause cause, Outgoing& out) {
  const bool wasHeld = m_status.progress == Progress::Held;
  if (!move(disarms(cause) ? JoystickMove::Disarm : JoystickMove::Stop)) return;
  m_status.cause = cause;
  m_mustRelease = true;
  m_x = m_y = {};
  noteEnd(live, disarms(cause), out);
  if (wasHeld) return beginNeutral(now, live, out);
  if (m_status.progress == Progress::Off) m_deadline = m_next = kNever;
}

void JoystickService::beginNeutral(Instant now, const Live& live, Outgoing& out) {
  withdraw(out, false);
  m_neutrals = 0;
  m_deadline = now + kNeutralFor;
  m_next = now + kPeriod;
  sayNeutral(now, live, out);
}

void JoystickService::sayNeutral(Instant now, const Live& live, Outgoing& out) {
  // The first goes at once, whatever waits; the others only behind nothing.
  if (!maySend(now) || (m_neutrals > 0 && !m_written.empty())) return;
  ++m_neutrals;
  say(now, live, {}, {}, out);
}

void JoystickService::keepHeld(Instant now, const Live& live, Outgoing& out) {
  if (now - m_lastTurn > kGap) return stop(now, live, MotionCause::Gap, out);
  if (now - m_verified > kFresh) return stop(now, live, MotionCause::HandNotSeen, out);
  look(now, live, out);
  if (m_status.progress != Progress::Held) return;
  m_lastTurn = now;
  // One at most is on its way.
  if (oldestUnconfirmed() == kNever) say(now, live, m_x, m_y, out);
}

void JoystickService::say(Instant now, const Live& live, Deflection x, Deflection y, Outgoing& out) {
  BasicJoystick message;
  message.x = StickAxis::at(x.tenths());
  message.y = StickAxis::at(y.tenths());
  const FrameTag tag =
      out.send(live, m_status.source, MessageId::BasicJoystick, kGlobalAddress, message.encode());
  m_written.push_back({tag, x.isAtRest() && y.isAtRest() ? Kind::Neutral : Kind::Motion, now});
}

void JoystickService::sendName(Instant now, const Live& live, Address from, Outgoing& out) {
  const Encoded name{std::bit_cast<Payload>(m_name.value), 8};
  m_written.push_back({out.send(live, from, MessageId::Name, kGlobalAddress, name), Kind::Claim, now});
}

void JoystickService::withdraw(Outgoing& out, bool all) {
  std::erase_if(m_written, [&](const Written& written) {
    if (!all && written.kind == Kind::Claim) return false;
    return std::erase_if(out.frames, [&](const OutFrame& frame) { return frame.tag == written.tag; }) > 0;
  });
}

Instant JoystickService::oldestUnconfirmed() const {
  Instant oldest = kNever;
  for (const Written& written : m_written) {
    if (written.kind != Kind::Claim) oldest = std::min(oldest, written.when);
  }
  return oldest;
}

void JoystickService::received(Instant now, const Live& live, const Frame& frame, Outgoing& out) {
  if (const auto state = controllerStateOf(frame)) {
    if (isActive() && isTrouble(*state)) stop(now, live, MotionCause::BusTrouble, out);
    return;
  }
  if (!frame.isExtended() || frame.isError() || (frame.flags & Frame::kSent) != 0) {
    if (isActive()) look(now, live, out);
    return;
  }
  const J1939Id id = J1939Id::of(frame.identifier());
  const bool isClaim = id.pgn == pgn::kAddressClaimed && frame.length == 8 && !frame.isRemote();
  if (isJoystickAddress(id.source)) m_foreign[id.source.value - kFirstJoystick.value] = now;
  const bool isUsed = m_status.progress != Progress::Off || m_hasClaimed;
  if (isUsed && (id.source == m_status.source || (isClaim && Name::of(frame) == m_name)))
    return yield(now, live, out);
  const bool asksName = id.pgn == pgn::kRequest && frame.length >= j1939::kRequestLength &&
                        (id.destination == kGlobalAddress || id.destination == m_status.source) &&
                        readBits(frame.data, kAskedPgn) == pgn::kAddressClaimed;
  if (asksName && m_hasClaimed && maySend(now)) sendName(now, live, m_status.source, out);
  if (!isActive()) return;
  if (!frame.isRemote()) m_watch.heard(live, frame);
  look(now, live, out);
}

// Whoever else uses the address is not asked why: a deflection of ours must not stay in the controllers, and
// nothing more comes from us.
void JoystickService::yield(Instant now, const Live& live, Outgoing& out) {
  const bool mayStay = m_status.progress == Progress::Held || isSaying();
  const bool wasUsed = m_status.progress != Progress::Off;
  const bool hadClaimed = std::exchange(m_hasClaimed, false);
  withdraw(out, true);
  if (mayStay && maySend(now)) say(now, live, {}, {}, out);
  if (hadClaimed && maySend(now)) sendName(now, live, kNullAddress, out);
  move(JoystickMove::Yield);
  m_deadline = m_next = kNever;
  m_mustRelease = true;
  m_x = m_y = {};
  m_status.cause = MotionCause::SourceTaken;
  if (wasUsed) noteEnd(live, true, out);
}

void JoystickService::controllerRead(Instant now, const Live& live, const ControllerReading& reading,
                                     Outgoing& out) {
  const bool hasFailed = reading.sendErrors >= m_reading.sendErrors + kMoreSendErrors;
  m_reading = reading;
  if (isActive() && (hasFailed || isInTrouble(live))) stop(now, live, MotionCause::BusTrouble, out);
}

void JoystickService::writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome,
                                 Outgoing& out) {
  const auto found = std::ranges::find(m_written, tag, &Written::tag);
  if (found == m_written.end()) return;
  const Written written = *found;
  m_written.erase(found);
  const bool isNeutral = written.kind == Kind::Neutral;
  switch (outcome) {
    case WriteOutcome::OnBus:
    case WriteOutcome::CannotTell:
      if (written.kind == Kind::Claim) {
        if (move(JoystickMove::Claimed)) m_deadline = now + kClaimTime;
        return;
      }
      wasSaid(now);
      if (written.kind == Kind::Motion && now - written.when >= kUnconfirmed) wentOutLate(now, live, out);
      return;
    case WriteOutcome::QueueFull:
      // The first neutral is tried until it is taken.
      if (isNeutral && isSaying() && --m_neutrals == 0) m_deadline = now + kNeutralFor;
      if (isActive()) stop(now, live, MotionCause::NotOnBus, out);
      return;
    case WriteOutcome::NotTaken:
      if (isNeutral && isSaying()) --m_neutrals;
      if (isActive()) stop(now, live, MotionCause::WriteFailed, out);
      return;
    case WriteOutcome::EchoLost:
      m_doubt = now;
      if (isActive()) stop(now, live, MotionCause::NotOnBus, out);
      return;
    case WriteOutcome::Gone: return;
  }
}

void JoystickService::wasSaid(Instant at) {
  if (m_firstSaid == kNotYet) {
    m_firstSaid = at;
  } else {
    m_status.worstGap = std::max(m_status.worstGap, at - m_lastSaid);
    m_status.period = (at - m_firstSaid) / m_status.frames;
  }
  m_lastSaid = at;
  ++m_status.frames;
}

void JoystickService::wentOutLate(Instant now, const Live& live, Outgoing& out) {
  if (isActive()) stop(now, live, MotionCause::NotOnBus, out);
  m_status.wentOutLate = true;
  out.note(note::MotionLate{live.channel, m_status.source});
  // Where the address is another's by now, that node decides.
  if (m_hasClaimed && maySend(now) && move(JoystickMove::Late)) beginNeutral(now, live, out);
}

Instant JoystickService::nextTime() const {
  const Instant oldest = isActive() ? oldestUnconfirmed() : kNever;
  return std::min({m_deadline, m_next, oldest == kNever ? kNever : oldest + kUnconfirmed});
}

void JoystickService::timeCame(Instant now, const Live& live, Outgoing& out) {
  if (!m_isOpen) return;
  const Instant oldest = isActive() ? oldestUnconfirmed() : kNever;
  if (oldest != kNever && now - oldest >= kUnconfirmed) stop(now, live, MotionCause::NotOnBus, out);
  if (now >= m_deadline) deadlineCame(now, live, out);
  if (now < m_next) return;
  const bool speaks = m_status.progress == Progress::Held || isSaying();
  const Duration step = speaks ? kPeriod : kLook;
  m_next = m_next + step * ((now - m_next) / step + 1);
  if (m_status.progress == Progress::Held) return keepHeld(now, live, out);
  if (isSaying()) return sayNeutral(now, live, out);
  look(now, live, out);
}

void JoystickService::deadlineCame(Instant now, const Live& live, Outgoing& out) {
  m_deadline = kNever;
  switch (m_status.progress) {
    case Progress::Off: return;
    case Progress::Listening:
      move(JoystickMove::Silent);
      m_hasClaimed = true;
      m_deadline = now + kClaimPatience;
      return sendName(now, live, m_status.source, out);
    case Progress::Claiming: return stop(now, live, MotionCause::NotOnBus, out);
    case Progress::Settling:
      move(JoystickMove::Settled);
      m_deadline = now + kLongestArmed;
      for (const Pin& pin : m_status.moves) {
        out.note(note::MotionArmed{live.channel, m_status.source, pin,
                                   static_cast<std::uint16_t>(m_status.limit), m_echo == Echo::Proven,
                                   m_arming.platform});
      }
      return;
    case Progress::Armed: return stop(now, live, MotionCause::NotHeldTooLong, out);
    case Progress::Held: return stop(now, live, MotionCause::HeldTooLong, out);
    case Progress::Releasing:
      move(JoystickMove::Said);
      m_deadline = now + kLongestArmed;
      return;
    case Progress::Ending:
      move(JoystickMove::Said);
      m_next = kNever;
      return;
  }
}

void JoystickService::noteEnd(const Live& live, bool isDisarmed, Outgoing& out) const {
  const auto microseconds = [](Duration d) { return static_cast<std::uint32_t>(d / 1us); };
  out.note(note::MotionEnded{live.channel, m_status.source, m_status.cause, isDisarmed, m_status.frames,
                             microseconds(m_status.period), microseconds(m_status.worstGap)});
}

}  // namespace deckpipe
