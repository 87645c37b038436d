// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/address_book.h"

#include <algorithm>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/lists.h"
#include "protocol/typed.h"

namespace deckpipe {
namespace {

constexpr std::uint32_t kSmallestPartNumber = 10'000'000;  // part numbers have eight digits
constexpr std::uint32_t kLargestPartNumber = 99'999'999;

constexpr bool isNode(Address a) { return a != kNullAddress && a != kGlobalAddress; }
constexpr Address addressAt(std::size_t i) { return {static_cast<std::uint8_t>(i)}; }

// A log without times stands still at 0, where log time begins.
bool isTimed(const Frame& frame, Instant time) { return frame.hasStamp() || time != Instant{}; }

Pin pinOf(std::uint64_t announcement) {
  Frame frame;
  frame.data = std::bit_cast<Payload>(announcement);
  return announcement == 0 ? Pin() : announcedPin(frame).value_or(Pin());
}

constexpr Duration kTurnWithin = 10s;  // each of two who share an address says so again within this time
constexpr Duration kTurnAfter = 1s;    // sooner it may be one contest
constexpr Duration kSharedFor = 60s;   // … and so long it is believed after the last time

constexpr Duration kAnswersWithin = 2s;  // a NAME so long after a request may be an answer

bool isPartNumberAnswer(const Frame& frame) {
  if (sdo::valueSize(frame.data[0]) != 4) return false;
  const auto object =
      readBits(frame.data, gateway::kIndex.bits) << 8 | readBits(frame.data, gateway::kSubindex.bits);
  const auto value = readBits(frame.data, gateway::kValue.bits);
  return object == sdo::kDeviceType && value >= kSmallestPartNumber && value <= kLargestPartNumber;
}

}  // namespace

Pin AddressBook::pin(Address a) const { return has(a, kFormer) ? Pin() : pinOf(m_pins[a.value]); }

Pin AddressBook::formerPin(Address a) const { return has(a, kFormer) ? pinOf(m_pins[a.value]) : Pin(); }

ClaimState AddressBook::claim(Address a, Instant now) const {
  if (isContested(a)) return ClaimState::Contested;
  if (!isHeld(a)) return lastHolder(a).isNull() ? ClaimState::NoClaim : ClaimState::CannotClaim;
  return now - m_claimedAt[a.value] < kClaimTime ? ClaimState::Claiming : ClaimState::Claimed;
}

void AddressBook::sayDrive(Address a, bool isDrive) { isDrive ? set(a, kDrive) : clear(a, kDrive); }

void AddressBook::linkWentDown() {
  for (const Contest& open : m_contests) {
    if (open.since != kNotYet) clear(open.address, kContested);
  }
  m_contests = {};
  m_nextDecision = kNever;
}

void AddressBook::linkCameBack() {
  linkWentDown();  // a log of several parts may have frames meanwhile
  for (std::size_t i = 0; i < m_flags.size(); ++i) {
    const Address a = addressAt(i);
    if (has(a, kAkron | kForeign | kHeld) || !m_names[i].isNull() || m_pins[i] != 0) set(a, kFormer);
  }
  m_turns = {};
  m_won.fill(0);
  m_lost.fill(0);
  m_akronNodes.reset();
  m_reporters.reset();
  m_namesAsked = kNotYet;
  m_openRequests = {};
}

void AddressBook::forgetFormer(Address a) {
  if (!has(a, kFormer)) return;
  clear(a, kFormer | kAkron | kForeign | kHeld);
  m_names[a.value] = {};
}

Address AddressBook::formerAddress(const Pin& pin) const {
  for (std::size_t i = 0; i < m_pins.size(); ++i) {
    if (has(addressAt(i), kFormer) && m_pins[i] != 0 && pinOf(m_pins[i]) == pin) return addressAt(i);
  }
  return kNullAddress;
}

bool AddressBook::learn(const Frame& frame, Instant time, const Classified& classified, Lost& lost) {
  const Address source = addressAt(frame.id & 0xFF);
  const bool isFirst = frame.isExtended() && !frame.isError() && heard(source);
  if (classified.malformed) return isFirst;
  const bool hasChanged = [&] {
    switch (classified.message) {
      case MessageId::Request:
        if (readBits(frame.data, little(1, 24)) != pgn::kAddressClaimed) return false;
        m_namesAsked = time;
        return true;
      case MessageId::Name: return claimed(source, frame, time, lost);
      case MessageId::AddressAnnouncement:
        return J1939Id::of(frame.identifier()).destination == kGlobalAddress &&
               announced(source, frame, time, lost);
      case MessageId::SdoReadResponse: {
        const NodeId node = CobId::of(frame.identifier()).node;
        if (isAkronNode(node) || !isPartNumberAnswer(frame)) return false;
        m_akronNodes.set(node.value);
        return true;
      }
      case MessageId::Count: return false;
      default:
        if (frame.isExtended() && isNewsOfReports(source, classified.message))
          return reported(source, classified.message, time);
        return kLooksAlikeBothWays[classified.message] && exchanged(frame, time, classified);
    }
  }();
  return isFirst || hasChanged;
}

bool AddressBook::heard(Address source) {
  if (!isNew(source) || !isNode(source)) return false;
  clear(source, kLeft);
  set(source, kHeard);
  return true;
}

bool AddressBook::exchanged(const Frame& frame, Instant time, const Classified& classified) {
  const J1939Id id = J1939Id::of(frame.identifier());
  return messageOf(classified.message).device == DeviceEnd::Sender
             ? m_openRequests.answered(frame.data[0], id.source, id.destination, time)
             : m_openRequests.requested(frame.data[0], id.source, id.destination, time);
}

Instant AddressBook::sharedSince(Address a, Instant now) const {
  for (const Contest& contest : m_contests) {
    if (contest.goesOn && contest.address == a && now - contest.since >= kClaimTime) return contest.since;
  }
  for (const Turn::By by : {Turn::By::Name, Turn::By::Pin}) {
    const auto turns = turnsOf(a, by);
    // A comes back to an address that B took meanwhile, in the last three turns or in the three before.
    const auto isBack = [&](std::size_t last) {
      const Turn *back = turns.at(last), *other = turns.at(last + 1), *first = turns.at(last + 2);
      // In a log without times the turns may lie a day apart.
      if (first == nullptr || back->time == Instant{}) return false;
      return back->who == first->who && back->who != other->who && back->time - first->time >= kTurnAfter &&
             back->time - other->time <= kTurnWithin && other->time - first->time <= kTurnWithin;
    };
    if (turns[2] == nullptr || now - turns[0]->time > kSharedFor) continue;
    // B has some time to give way: a lawful one claims another address.
    if (isBack(0) && now - turns[0]->time >= kClaimTime) return turns[2]->time;
    if (isBack(1) && turns[0]->time - turns[1]->time <= kTurnWithin) return turns[3]->time;
  }
  return kNotYet;
}

std::array<const AddressBook::Turn*, 4> AddressBook::turnsOf(Address a, Turn::By by) const {
  std::array<const Turn*, 4> latest{};
  auto at = latest.begin();
  for (const Turn& turn : m_turns) {
    if (at == latest.end() || turn.time == kNotYet) break;
    if (turn.address == a && turn.by == by) *at++ = &turn;
  }
  return latest;
}

void AddressBook::noteTurn(const Turn& turn) {
  const Turn* last = turnsOf(turn.address, turn.by).front();
  if (last != nullptr && last->who == turn.who) return;
  std::shift_right(m_turns.begin(), m_turns.end(), 1);
  m_turns.front() = turn;
}

template <typename IsMeant>
bool AddressBook::forgetTurns(IsMeant isMeant, Address except) {
  const auto kept = std::remove_if(m_turns.begin(), m_turns.end(), [&](const Turn& turn) {
    return turn.time != kNotYet && turn.address != except && isMeant(turn);
  });
  std::fill(kept, m_turns.end(), Turn{});
  return kept != m_turns.end();
}

bool AddressBook::announced(Address source, const Frame& frame, Instant time, Lost& lost) {
  if (!isNode(source)) return false;
  const bool isNews = !isAkron(source);
  const Name former = formerHolder(source);
  forgetFormer(source);
  set(source, kAkron);
  const std::uint64_t pin = loadLittle(frame.data);
  if (m_pins[source.value] == pin || !announcedPin(frame)) return isNews;
  for (std::size_t i = 0; i < m_pins.size(); ++i) {
    if (m_pins[i] != pin) continue;
    m_pins[i] = 0;
    set(addressAt(i), kLeft);
    m_reporters.reset(i);
    lost.set(i);
  }
  // Behind a gap: whose PIN was not known there may be known by its NAME to be another one.
  const bool wasAnother = former.isAkron() && !isNameOf(former, pinOf(pin));
  if (m_pins[source.value] != 0 || wasAnother) lost.set(source.value);
  m_pins[source.value] = pin;
  forgetTurns([pin](const Turn& turn) { return turn.by == Turn::By::Pin && turn.who == pin; }, source);
  noteTurn({time, pin, source, Turn::By::Pin});
  return true;
}

bool AddressBook::claimed(Address source, const Frame& frame, Instant time, Lost& lost) {
  const Name name = Name::of(frame);
  if (source == kGlobalAddress || name.isNull()) return false;
  const auto isItsTurn = [name](const Turn& turn) {
    return turn.by == Turn::By::Name ? turn.who == name.value : isNameOf(name, pinOf(turn.who));
  };
  const bool hasForgotten = forgetTurns(isItsTurn, source);
  const bool hasGivenUp = giveUpContests(name, source) || hasForgotten;
  if (source == kNullAddress) return cannotClaim(name, lost) || hasGivenUp;
  const bool hasLeft = leaveTo(name, source, lost) || hasGivenUp;
  const Name holder = this->holder(source);
  if (!holder.isNull() && holder == name) return answered(source, time, lost) || hasLeft;
  const bool isHigher = !holder.isNull() && name.value > holder.value;
  if (isTimed(frame, time) && (isHigher || mayGoOn(source, name, time)))
    return contest(source, name, time) || hasLeft;
  if (!holder.isNull()) ++m_lost[source.value];
  take(source, name, time, lost);
  return true;
}

bool AddressBook::mayGoOn(Address a, Name name, Instant time) const {
  if (name.isAkron() || !m_reporters[a.value]) return false;
  return isAkron(a) || isContested(a) || m_namesAsked == kNotYet || time - m_namesAsked > kAnswersWithin;
}

// The holder has claimed its address again. Against a lower NAME that is no answer.
bool AddressBook::answered(Address source, Instant time, Lost& lost) {
  if (!isContested(source)) return false;
  const Contest open = contestAt(source);
  const Name holder = lastHolder(source);
  if (open.challenger.value > holder.value) {
    ++m_won[source.value];
    end(contestAt(source));
    return true;
  }
  if (open.goesOn) return false;
  ++m_lost[source.value];
  take(source, open.challenger, open.since, lost);
  contest(source, holder, time);
  return true;
}

// A holder that claims another address has left the one that a lower NAME has claimed.
bool AddressBook::leaveTo(Name holder, Address except, Lost& lost) {
  bool hasChanged = false;
  for (const Contest& contest : m_contests) {
    if (contest.since == kNotYet || contest.address == except || lastHolder(contest.address) != holder ||
        contest.challenger.value > holder.value)
      continue;
    const Contest open = contest;
    ++m_lost[open.address.value];
    take(open.address, open.challenger, open.since, lost);
    hasChanged = true;
  }
  return hasChanged;
}

// A status may come twice, as in a log of two loggers: the next one comes a period later.
bool AddressBook::reported(Address source, MessageId id, Instant time) {
  if (!m_reporters[source.value]) {
    m_reporters.set(source.value);
    return true;
  }
  Contest& open = contestAt(source);
  if (open.challenger.isAkron()) return false;
  const auto after =
      static_cast<std::uint32_t>(std::min<std::int64_t>((time - open.since) / 1ms, UINT32_MAX));
  const bool isFirst = open.report == MessageId::Count;
  const Duration pause = open.goesOn ? kGivesWayAfter / 2 : messageOf(id).period / 2;
  if (!isFirst && (id != open.report || (after - open.reportedMs) * 1ms < pause)) return false;
  open.report = id;
  open.goesOn = !isFirst;
  open.reportedMs = after;
  planDecision();
  return true;
}

bool AddressBook::cannotClaim(Name name, Lost& lost) {
  bool hasChanged = false;
  for (std::size_t i = 0; i < m_names.size(); ++i) {
    const Address a = addressAt(i);
    if (m_names[i] != name || !has(a, kHeld)) continue;
    hasChanged = true;
    if (isContested(a)) {
      const Contest open = contestAt(a);
      ++m_lost[i];
      take(a, open.challenger, open.since, lost);
      continue;
    }
    lost.set(i);
    forgetFormer(a);
    clear(a, kHeld | kAkron | kForeign);
    m_reporters.reset(i);
    m_pins[i] = 0;
  }
  return hasChanged;
}

void AddressBook::take(Address a, Name name, Instant since, Lost& lost) {
  const Name before = m_names[a.value];
  const Pin pin = pinOf(m_pins[a.value]);
  const bool isOther = !before.isNull() && before != name;
  const Name former = formerHolder(a);
  // A NAME tells of a PIN in 21 bits of its number alone: another bus may have such a one, too.
  const bool keepsPin = !pin.isNull() && isNameOf(name, pin) && (former.isNull() || former == name);
  if (pin.isNull() ? isOther || !name.isAkron() : !keepsPin) lost.set(a.value);
  if (!keepsPin) m_pins[a.value] = 0;
  if (isContested(a)) end(contestAt(a));
  clear(a, kFormer | kAkron | kForeign);
  if (isOther) clear(a, kDrive);
  set(a, kHeld | (name.isAkron() ? kAkron : kForeign));
  m_reporters.reset(a.value);
  m_names[a.value] = name;
  m_claimedAt[a.value] = since;
  noteTurn({since, name.value, a, Turn::By::Name});
}

AddressBook::Contest& AddressBook::contestAt(Address a) {
  return *std::ranges::find_if(
      m_contests, [a](const Contest& contest) { return contest.since != kNotYet && contest.address == a; });
}

bool AddressBook::contest(Address a, Name challenger, Instant time) {
  if (isContested(a)) {
    Contest& open = contestAt(a);
    if (challenger.value >= open.challenger.value) return false;
    open.challenger = challenger;
    return true;
  }
  const auto free = std::ranges::find(m_contests, kNotYet, &Contest::since);
  if (free == m_contests.end()) return false;
  *free = {time, challenger, a};
  set(a, kContested);
  m_nextDecision = std::min(m_nextDecision, free->due());
  return true;
}

void AddressBook::end(Contest& contest) {
  clear(contest.address, kContested);
  contest = {};
  planDecision();
}

void AddressBook::planDecision() { m_nextDecision = std::ranges::min(m_contests, {}, &Contest::due).due(); }

bool AddressBook::giveUpContests(Name challenger, Address except) {
  bool hasChanged = false;
  for (Contest& contest : m_contests) {
    if (contest.since == kNotYet || contest.challenger != challenger || contest.address == except) continue;
    end(contest);
    hasChanged = true;
  }
  return hasChanged;
}

// In the order in which they fall due, however late this is called.
bool AddressBook::decide(Instant time, Lost& lost) {
  bool hasChanged = false;
  for (std::size_t n = 0; n < kContests; ++n) {
    const Contest* due = nullptr;
    for (const Contest& contest : m_contests) {
      if (contest.since == kNotYet || contest.due() > time) continue;
      if (due == nullptr || contest.due() < due->due()) due = &contest;
    }
    if (due == nullptr) break;
    const Contest decided = *due;
    if (isHeld(decided.address)) ++m_lost[decided.address.value];
    take(decided.address, decided.challenger, decided.since, lost);
    hasChanged = true;
  }
  return hasChanged;
}

}  // namespace deckpipe
