// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/health.h"

#include <algorithm>

#include "protocol/device_types.h"
#include "protocol/gateway.h"
#include "state/current.h"

namespace deckpipe {
namespace {

// Whoever lost its address not longer than this before two were seen there may be one of the two.
constexpr Duration kLostWithin = 10s;

// What the manual says of the device's type; null where it names none, or where the type is not known.
const DeviceTypeFacts* typeFactsOf(const Device& d) {
  const bool isNode = d.kind == Device::Kind::Node;
  return deviceTypeOf(isNode ? deviceTypeOfPart(d.part()) : d.pin.deviceType());
}

// Whether the announced type sends no such status: then another device sent it.
bool isForeign(const Device& d, MessageId id) {
  const DeviceTypeFacts* type = d.kind == Device::Kind::Pin ? typeFactsOf(d) : nullptr;
  return type != nullptr && messageOf(id).family == Family::Akron && isOwnPeriodicReport(messageOf(id)) &&
         !type->sends().has(id);
}

// When a status came last that another device sent; kNotYet if none did.
Instant lastForeign(const Device& d) {
  Instant last = kNotYet;
  for (const MessageId id : kOwnPeriodicReports) {
    if (isForeign(d, id)) last = std::max(last, d.report(id).at);
  }
  return last;
}

// What is judged: a device, or an address where there is none of Akron's.
struct Subject {
  const State& state;
  const ChannelState& channel;
  Address address;       // null: lost, or a CANopen node
  const Device* device;  // null: there is none

  // While the link is down, answers get no older than they were then.
  Instant now() const { return channel.heardUntil(state.cursor().time); }
  // Whether nothing came for `after` since `last`, or since the link came up, and is missing.
  bool isMissing(Instant last, Duration after = kSilentAfter) const {
    return last == kNotYet || now() - channel.missedFrom(last) >= after;
  }
  bool hasAddress() const { return address != kNullAddress; }
  const Joystick* joystick() const { return hasAddress() ? channel.joysticks.find(address) : nullptr; }
  bool isNode() const { return device != nullptr && device->kind == Device::Kind::Node; }
  // A status counts as long as it is fresh, and the device's own.
  bool has(MessageId id) const {
    return device != nullptr && device->report(id).isKnown() && !device->isStale(id) &&
           !channel.isBeforeGap(device->report(id).at) && !isForeign(*device, id);
  }
  // Whether such a status came before a gap, and who is there now has not said its PIN.
  bool isAnothers(MessageId id) const {
    return device->kind != Device::Kind::Pin && channel.isBeforeGap(device->report(id).at);
  }
  bool hasPosition() const { return has(MessageId::PositionLimitStatus); }
  PositionLimitStatus position() const { return device->position().value(); }
  Instant lastHeard() const {
    return device != nullptr ? device->lastHeard : channel.nodes[address].lastHeard;
  }
  // Nobody was heard there since the link came back: nobody has to be there.
  bool isFormer() const { return channel.isBeforeGap(lastHeard()); }
};

Subject subjectOf(const State& state, const Device& device) {
  const bool isNode = device.kind == Device::Kind::Node;
  return {state, state.channel(device.channel), isNode ? kNullAddress : device.address, &device};
}

// A device of Akron's, or one that speaks as they do; a node if it has shown that it is a monitor.
bool canBeRequested(const Subject& s) {
  if (s.device == nullptr) return false;
  if (!s.isNode()) return true;
  const Device& d = *s.device;
  return d.part() != 0 || d.isKnownNow(MessageId::FaultResponse) ||
         d.isKnownNow(MessageId::PositionLimitStatus) || d.isKnownNow(MessageId::DigitalOutputs);
}

// What the device has to repeat, as far as its type says it, or without one what it sends. The heartbeat of a gateway
// is not among it: it is on by default, and can be switched off (Gateway manual).
EnumSet<MessageId> repeats(const Subject& s) {
  if (s.device == nullptr) return {};
  const Device& d = *s.device;
  EnumSet<MessageId> heard;
  for (const MessageId id : kOwnPeriodicReports) {
    if (messageOf(id).family == Family::Akron && d.report(id).isKnown() && !s.isAnothers(id)) heard.add(id);
  }
  if (const DeviceTypeFacts* type = typeFactsOf(d); type != nullptr) return type->repeats;
  return heard.isEmpty() ? heard : repeatedBySenderOf(heard);
}

// Whether something of it comes by itself. Controls have to send joystick messages, but from an address of 33 to
// 38 hex that no message ties to their PIN. Statuses of before a gap oblige only the PIN that sent them.
bool sendsByItself(const Subject& s) {
  const Joystick* stick = s.joystick();
  if (stick != nullptr && !s.channel.isBeforeGap(std::max(stick->basic.at, stick->extended.at))) return true;
  if (s.device == nullptr) return !s.channel.wereOwn[s.address.value] && s.channel.nodes[s.address].isSteady;
  if (s.isNode()) return s.device->hasPeriod();
  const bool hasSent = s.device->lastStatus != kNotYet &&
                       (s.device->kind == Device::Kind::Pin || !s.channel.isBeforeGap(s.device->lastStatus));
  return hasSent || !repeats(s).isEmpty();
}

// So long after the last beat it is missing.
Duration missingAfter(const Subject& s) {
  if (s.device != nullptr) return s.device->silentAfter();
  return s.joystick() != nullptr ? kSilentAfter : silentAfter(s.channel.nodes[s.address].period);
}

// When something came last that comes by itself.
Instant lastBeat(const Subject& s) {
  const Joystick* stick = s.joystick();
  Instant last = stick != nullptr ? std::max(stick->basic.at, stick->extended.at) : kNotYet;
  if (s.device != nullptr) return std::max(last, s.device->lastStatus);
  return last == kNotYet ? s.lastHeard() : last;
}

void takeShared(const Subject& s, Health& h);

// Whoever lost its address to another device may still send from there: then nothing that came is its own for sure,
// and nothing is missing for sure.
bool isLost(const Subject& s, const Health& h) { return h.sharedAddress != kNullAddress && !s.hasAddress(); }

bool isSilent(const Subject& s) {
  if (s.state.isFiltered() || s.isFormer()) return false;
  // One that has sent nothing of the kind yet has as long for it.
  const Instant last = lastBeat(s) != kNotYet ? lastBeat(s) : s.lastHeard();
  if (!sendsByItself(s) || !s.isMissing(last, missingAfter(s))) return false;
  Health h;
  if (!s.hasAddress()) takeShared(s, h);
  return !isLost(s, h);
}

AnswerAge ageOf(const Subject& s, Instant answered) {
  const Device& d = *s.device;
  // What happened before a gap may have been another device's.
  const auto isFollowedBy = [&](Instant at) {
    return answered < at && !s.channel.isBeforeGap(at) && !s.state.isFiltered();
  };
  if (isFollowedBy(d.restarted)) return AnswerAge::BeforeRestart;
  if (isFollowedBy(d.resumed)) return AnswerAge::BeforeSilence;
  if (s.channel.isBeforeGap(answered)) return AnswerAge::BeforeGap;
  // An answer that came while the statuses were missing is as good as any.
  if (isSilent(s) && s.now() - answered >= missingAfter(s)) return AnswerAge::BeforeSilence;
  return isLinkDown(s.state, d.channel) ? AnswerAge::BeforeLinkDown : AnswerAge::Current;
}

// That two devices send from one address.
struct Shared {
  Instant since = kNotYet;  // kNotYet: they do not
  bool isCertain = false;   // not by the pace of statuses alone
};

// They do if their PINs or NAMEs say so in turn (AddressBook::sharedSince), if their statuses come twice a period
// (pace.h), if statuses come that the announced type does not send, or if a PIN is announced, with no claim under way,
// under the NAME of another device.
Shared sharedAt(const Subject& s, Address address) {
  Shared shared;
  const auto found = [&](Instant at, bool isCertain) {
    shared.since = shared.since == kNotYet ? at : std::min(shared.since, at);
    shared.isCertain = shared.isCertain || isCertain;
  };
  const AddressBook& book = s.channel.book;
  if (const Instant since = book.sharedSince(address, s.now()); since != kNotYet) found(since, true);
  for (const Device& d : s.state.devices().all()) {
    if (d.kind != Device::Kind::Pin && d.kind != Device::Kind::Address) continue;
    if (&s.state.channel(d.channel) != &s.channel || d.address != address) continue;
    // Two that say different things are one, heard by two loggers, if what these wrote was put into one log with more
    // than a period between. Only a log whose link is known was not made so.
    const bool isFromOneLink = s.channel.link != ChannelLink::Unknown;
    if (d.doubled != kNotYet && s.now() - d.doubled <= kDoubledFor)
      found(d.doubledSince, !d.isOnlyEqual && isFromOneLink);
    const Instant foreign = lastForeign(d);
    if (foreign != kNotYet && !s.channel.isBeforeGap(foreign) && s.now() - foreign <= kDoubledFor)
      found(foreign, true);
    const Name holder = book.holder(address);
    if (d.kind == Device::Kind::Pin && holder.isAkron() && !isNameOf(holder, d.pin) &&
        book.claim(address, d.announced) == ClaimState::Claimed)
      found(d.addressSince, true);
  }
  return shared;
}

// Of the address that it has, or lost last: whoever lost it to the other one may still send from there.
void takeShared(const Subject& s, Health& h) {
  if (s.isNode()) return;
  const bool hasLost = !s.hasAddress() && s.device != nullptr;
  const Address address = hasLost ? s.device->previousAddress() : s.address;
  if (address == kNullAddress) return;
  const Shared shared = sharedAt(s, address);
  if (shared.since == kNotYet) return;
  // It left before: the two are others.
  if (hasLost && shared.since - s.device->formerAddresses.front().until > kLostWithin) return;
  h.sharedAddress = address;
  h.isOnlyEqual = !shared.isCertain;
}

bool isOld(const Health& h) { return h.answered != kNotYet && h.answer != AnswerAge::Current; }

ClaimState claimOf(const Subject& s) {
  return s.hasAddress() ? s.channel.book.claim(s.address, s.now()) : ClaimState::NoClaim;
}

// A node answers for its faults and for its error code apart, each at its own time.
void takeAnswers(const Subject& s, Health& h) {
  const Device& d = *s.device;
  if (const auto faults = d.faults(); faults.isKnown()) {
    h.answered = faults.at;
    h.answer = ageOf(s, faults.at);
    const FaultStatus status = faults.value();
    const NamedFaults named{status.map, status.pcodeError.value_or(0)};
    (isOld(h) ? h.oldFaults : h.faults) = named;
  }
  const auto& code = d.operationalErrorCode;
  if (code.isKnown() && code.value != 0 && ageOf(s, code.at) == AnswerAge::Current)
    h.faults.errorCode = code.value;
  // The code belongs to the error that is over: the next one is asked anew.
  if (d.isErrorOver) h.faults.errorCode = 0;
}

Axes axesThatAre(const Subject& s, PositionState state) {
  if (!s.hasPosition()) return {};
  const PositionLimitStatus p = s.position();
  return {p.rotation.state == state, p.elevation.state == state};
}

// Without position feedback an axis has no soft limits to send.
bool isNotFitted(const Subject& s, MessageId id) {
  const Axes axes = axesThatAre(s, PositionState::NotFitted);
  return (id == MessageId::RotationSoftLimits && axes.rotation) ||
         (id == MessageId::ElevationSoftLimits && axes.elevation);
}

Health factsOf(const Subject& s) {
  Health h;
  takeShared(s, h);
  if (s.device == nullptr) return h;
  const Device& d = *s.device;
  takeAnswers(s, h);
  for (const MessageId id : kOwnPeriodicReports) {
    // It comes, if in a wrong length.
    if (isForeign(d, id) || d.isMalformedNow(id, s.now()) || s.isAnothers(id)) continue;
    if (d.isStale(id) && d.hasPeriod(id) && !isNotFitted(s, id)) h.late.add(id);
    if (repeats(s).has(id) && !d.report(id).isKnown()) h.neverHeard.add(id);
  }
  h.sensorError = axesThatAre(s, PositionState::SensorError);
  h.invalid = axesThatAre(s, PositionState::Invalid);
  return h;
}

bool anyStop(const Subject& s, Status2 status) {
  if (!s.hasPosition()) return false;
  const PositionLimitStatus p = s.position();
  return std::ranges::count(p.plusStop, status) + std::ranges::count(p.minusStop, status) > 0;
}

bool isMalformed(const Subject& s) {
  return s.device != nullptr ? s.device->malformed != 0 : s.channel.nodes[s.address].malformed != 0;
}

bool isJoystickStopped(const Subject& s) {
  const Joystick* stick = s.joystick();
  return stick != nullptr && stick->timedOut && !isSilent(s);
}

using Rule = bool (*)(const Subject&, const Health&);
constexpr EnumTable<HealthCause, Rule> kRules{{
    {HealthCause::Silent, [](const Subject& s, const Health&) { return isSilent(s); }},
    {HealthCause::TwoAtOneAddress,
     [](const Subject&, const Health& h) { return h.sharedAddress != kNullAddress; }},
    {HealthCause::FaultsNamed,
     [](const Subject& s, const Health& h) { return canBeRequested(s) && !h.faults.isEmpty(); }},
    {HealthCause::SensorError, [](const Subject&, const Health& h) { return !h.sensorError.isEmpty(); }},
    {HealthCause::OperationalError,
     [](const Subject& s, const Health&) {
       return s.hasPosition() && s.position().operationalError == Status2::On;
     }},
    {HealthCause::Faulted,
     [](const Subject& s, const Health&) {
       return s.has(MessageId::MiniDigitalOutputs) && s.device->miniOutputs().value().deviceFaulted;
     }},
    {HealthCause::StopError, [](const Subject& s, const Health&) { return anyStop(s, Status2::Error); }},
    {HealthCause::Disabled,
     [](const Subject& s, const Health&) {
       return s.has(MessageId::DigitalOutputs) && !s.device->outputs().value().enable;
     }},
    {HealthCause::PositionInvalid, [](const Subject&, const Health& h) { return !h.invalid.isEmpty(); }},
    {HealthCause::Late,
     [](const Subject& s, const Health& h) { return !h.late.isEmpty() && !isSilent(s) && !isLost(s, h); }},
    {HealthCause::NotOperational,
     [](const Subject& s, const Health&) {
       return s.has(MessageId::Heartbeat) && s.device->heartbeat().value() != gateway::kOperational;
     }},
    {HealthCause::JoystickStopped, [](const Subject& s, const Health&) { return isJoystickStopped(s); }},
    {HealthCause::AddressLost,
     [](const Subject& s, const Health&) { return !s.isNode() && s.device != nullptr && !s.hasAddress(); }},
    {HealthCause::AddressContested,
     [](const Subject& s, const Health& h) {
       return h.sharedAddress == kNullAddress && claimOf(s) == ClaimState::Contested;
     }},
    {HealthCause::CannotClaim,
     [](const Subject& s, const Health&) { return claimOf(s) == ClaimState::CannotClaim; }},
    {HealthCause::Malformed, [](const Subject& s, const Health&) { return isMalformed(s); }},
    {HealthCause::FaultsNotAnswered,
     [](const Subject& s, const Health&) {
       return canBeRequested(s) && isUnanswered(*s.device, Request::Fault, s.now());
     }},
    {HealthCause::FaultsRefused,
     [](const Subject& s, const Health&) {
       return canBeRequested(s) && s.device->hasRefused(Request::Fault) &&
              !isUnanswered(*s.device, Request::Fault, s.now());
     }},
    {HealthCause::LinkDown,
     [](const Subject& s, const Health&) { return isLinkDown(s.channel, s.state.cursor().time); }},
    {HealthCause::Filtered, [](const Subject& s, const Health&) { return s.state.isFiltered(); }},
    {HealthCause::Idle,
     [](const Subject& s, const Health&) {
       return (!sendsByItself(s) || s.isFormer()) && s.isMissing(s.lastHeard());
     }},
    {HealthCause::FaultsAwaited,
     [](const Subject& s, const Health& h) {
       return canBeRequested(s) && h.answered == kNotYet &&
              s.device->askedInVain(Request::Fault) != kNotYet && !s.device->hasRefused(Request::Fault) &&
              !isUnanswered(*s.device, Request::Fault, s.now());
     }},
    {HealthCause::FaultsOld, [](const Subject& s, const Health& h) { return canBeRequested(s) && isOld(h); }},
    {HealthCause::FaultsNeverAsked,
     [](const Subject& s, const Health& h) {
       return canBeRequested(s) && h.answered == kNotYet &&
              s.device->askedInVain(Request::Fault) == kNotYet && !s.device->hasRefused(Request::Fault);
     }},
    {HealthCause::StatusNeverHeard, [](const Subject&, const Health& h) { return !h.neverHeard.isEmpty(); }},
    {HealthCause::NotAnnounced,
     [](const Subject& s, const Health&) {
       return s.device == nullptr && s.channel.book.isAkron(s.address);
     }},
    {HealthCause::CannotBeAsked,
     [](const Subject& s, const Health&) {
       return !canBeRequested(s) && (s.device != nullptr || !s.channel.book.isAkron(s.address));
     }},
}};

// What rests on something that did not come.
constexpr EnumSet<HealthCause> kSilences(HealthCause::Silent, HealthCause::Late, HealthCause::JoystickStopped,
                                         HealthCause::FaultsNotAnswered, HealthCause::Idle,
                                         HealthCause::FaultsAwaited, HealthCause::FaultsNeverAsked,
                                         HealthCause::StatusNeverHeard, HealthCause::NotAnnounced);

Health unknownSince(Instant linkDown) {
  Health h;
  h.causes.add(HealthCause::LinkDown);
  h.since = linkDown;
  return h;
}

Health judge(const Subject& s) {
  if (kRules[HealthCause::LinkDown](s, {})) return unknownSince(s.channel.linkDown);
  Health h = factsOf(s);
  for (const HealthCause cause : kAllOf<HealthCause>) {
    if (kRules[cause](s, h)) h.causes.add(cause);
  }
  if (s.state.isFiltered()) h.causes = h.causes - kSilences;
  // Only where a cause speaks of it, so that a health changes only when its words do.
  if (h.has(HealthCause::Silent)) h.since = lastBeat(s);
  if (h.has(HealthCause::Idle)) h.since = s.lastHeard();
  h.isSinceLinkUp = s.channel.isBeforeGap(h.since);
  if (h.isSinceLinkUp) h.since = s.channel.linkUp;
  if (!h.has(HealthCause::FaultsOld)) {
    h.answered = kNotYet;
    h.answer = AnswerAge::Current;
  }
  if (!h.has(HealthCause::Late)) h.late = {};
  if (!h.has(HealthCause::StatusNeverHeard)) h.neverHeard = {};
  if (h.has(HealthCause::FaultsNotAnswered)) h.asked = s.device->askedInVain(Request::Fault);
  return h;
}

}  // namespace

HealthCause Health::worst() const {
  const auto first = std::ranges::find_if(kAllOf<HealthCause>, [this](HealthCause c) { return has(c); });
  return first == kAllOf<HealthCause>.end() ? HealthCause::Count : *first;
}

Severity Health::severity() const { return isFine() ? Severity::Fine : kHealthCauses[worst()].severity; }

Health healthOf(const State& state, const Device& device) { return judge(subjectOf(state, device)); }

Health healthOf(const State& state, Channel channel, Address address) {
  return judge({state, state.channel(channel), address, nullptr});
}

AnswerAge ageOfAnswer(const State& state, const Device& device, Instant answered) {
  return ageOf(subjectOf(state, device), answered);
}

Address sharedAddressOf(const State& state, const Device& device) {
  Health health;
  takeShared(subjectOf(state, device), health);
  return health.sharedAddress;
}

bool isUnanswered(const Device& device, Request request, Instant now) {
  const Instant first = device.askedInVain(request);
  return first != kNotYet && now - first >= kUnansweredAfter;
}

}  // namespace deckpipe
