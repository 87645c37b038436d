// SPDX-License-Identifier: GPL-3.0-or-later
// What comes back of requests: the fate of their frames, and answers.
#include <algorithm>
#include <utility>

#include "bus/j1939.h"
#include "protocol/lists.h"
#include "service/request_service.h"

namespace deckpipe {
namespace {

using Progress = RequestStatus::Progress;

}  // namespace

bool RequestService::isHanded(const DeviceKey& device, Request request) const {
  return std::ranges::any_of(m_commands,
                             [&](const Handed& c) { return c.device == device && c.request == request; });
}

RequestService::Asked* RequestService::openWith(FrameTag tag, Request& request) {
  for (Asked& at : m_devices) {
    for (const Request each : kAllOf<Request>) {
      if (at.timing(each).tag != tag || !at.status(each).isOpen()) continue;
      request = each;
      return &at;
    }
  }
  return nullptr;
}

void RequestService::writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome,
                                Outgoing& out) {
  const bool isOnBus = outcome == WriteOutcome::OnBus || outcome == WriteOutcome::CannotTell ||
                       outcome == WriteOutcome::EchoLost;
  const auto handed = std::ranges::find(m_commands, tag, &Handed::tag);
  if (handed != m_commands.end()) {
    const Handed command = *handed;
    m_commands.erase(handed);
    // A lock or a lost address says of every command that it waits: that alone does not make it late.
    const bool isLate = isOnBus && command.isSaid && now >= command.since + kOnBusTime;
    // The controller may have thrown the command away: it is not waited for as one that was sent.
    if (isLate || outcome == WriteOutcome::EchoLost) {
      Request open{};
      if (Asked* at = openWith(tag, open)) at->status(open).sent = now;
      const bool isProven = outcome == WriteOutcome::OnBus;
      return commandEnded(now, live, command, isProven ? RequestEnd::WentOutLate : RequestEnd::CannotTell,
                          out);
    }
    if (outcome == WriteOutcome::Gone)
      return commandEnded(now, live, command, RequestEnd::GoneWithInterface, out);
  }
  Request request{};
  Asked* at = openWith(tag, request);
  if (at == nullptr || outcome == WriteOutcome::Gone) return;  // a lost link ends the polls
  RequestStatus& status = at->status(request);
  Timing& timing = at->timing(request);
  if (!isOnBus) {
    if (!timing.wasOnBus) end(now, live, *at, request, RequestEnd::NotOnBus, out);
    return;
  }
  status.progress = Progress::Waiting;
  timing.isOnBus = timing.wasOnBus = true;
  timing.deadline = now + ruleOf(request).patience;
  timing.lastStatus = now;
  status.sent = now;
  if (status.tries == 1) status.firstSent = now;
}

void RequestService::commandEnded(Instant now, const Live& live, const Handed& command, RequestEnd how,
                                  Outgoing& out) {
  Request request{};
  if (Asked* at = openWith(command.tag, request)) return end(now, live, *at, request, how, out);
  // Its asker was told an end before, by a lock or the like; this is the truth.
  RequestStatus& status = asked(command.device).status(command.request);
  status.end = how;
  status.ended = now;
  noteEnd(live, command.device, command.to, command.request, how, out);
}

void RequestService::sayNotOnBus(const Live& live, Handed& command, Outgoing& out) {
  if (std::exchange(command.isSaid, true)) return;
  out.note(note::RequestWaits{live.channel, command.to, command.device.pin, command.request});
  Request request{};
  if (Asked* at = openWith(command.tag, request)) at->status(request).progress = Progress::NotOnBusYet;
}

void RequestService::received(Instant now, const Live& live, const Frame& frame, Outgoing& out) {
  if (!frame.isExtended() || frame.isRemote() || frame.isError() || (frame.flags & Frame::kSent) != 0) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  if (source() == kNullAddress || id.pgn != pgn::kProprietaryA || frame.length == 0) return;
  adopt(now, live, out);
  if (id.destination == kGlobalAddress) return broadcastHeard(now, live, id.source, frame, out);
  if (id.destination != source()) return;
  for (Asked& at : m_devices) {
    for (const Request request : kAllOf<Request>) {
      if (request == Request::Reset || at.timing(request).to != id.source) continue;
      const RequestRule& rule = ruleOf(request);
      for (std::size_t part = 0; part < rule.answers.size(); ++part) {
        if (rule.answers[part] == kNoAnswer || !hasTypeOf(frame, rule.answers[part])) continue;
        // The address may have gone to somebody else since.
        if (live.addressOf(at.device) != id.source) continue;
        if (!allows(messageOf(rule.answers[part]).lengths, frame.length)) {
          ++at.status(request).wrong;
          if (at.timing(request).wasOnBus) at.timing(request).wrong = true;
        } else {
          answered(now, live, at, request, part, out);
        }
      }
    }
  }
}

void RequestService::answered(Instant now, const Live& live, Asked& at, Request request, std::size_t part,
                              Outgoing& out) {
  RequestStatus& status = at.status(request);
  Timing& timing = at.timing(request);
  if (status.progress == Progress::Waiting) {
    if (!timing.wasOnBus) {  // it answers nothing of ours
      ++status.unasked;
      return;
    }
    const unsigned whole = wholeAnswer(ruleOf(request));
    if ((timing.answers >> part & 1u) != 0) ++status.unasked;
    timing.answers = static_cast<std::uint8_t>(timing.answers | 1u << part);
    if (timing.answers != whole) return;
    // An acknowledgement to our address may be the other node's that sends from it.
    const bool canTell = !isCommand(request) || !m_own.isDisputed();
    end(now, live, at, request, canTell ? RequestEnd::Answered : RequestEnd::CannotTell, out);
    return;
  }
  const bool wasGivenUp = status.end == RequestEnd::NoAnswer || status.end == RequestEnd::WrongAnswer ||
                          status.end == RequestEnd::NotOnBus || status.end == RequestEnd::WentOutLate ||
                          status.end == RequestEnd::CannotTell;
  if (!wasGivenUp || now - status.ended > kLate || (isCommand(request) && m_own.isDisputed())) {
    if (timing.spare > 0) {
      --timing.spare;
    } else {
      ++status.unasked;
    }
    return;
  }
  status.end = RequestEnd::AnsweredLate;
  status.latency = std::max<Duration>(now - status.sent, 0ns);
  status.ended = now;
  noteEnd(live, at.device, timing.to, request, status.end, out);
}

// A reset has no acknowledgement: the device comes back under its PIN, perhaps at another address. It
// announces itself whenever NAMEs are asked for, too; what tells a restart is that its statuses stopped
// before.
void RequestService::broadcastHeard(Instant now, const Live& live, Address source, const Frame& frame,
                                    Outgoing& out) {
  constexpr MessageId kAnnouncement = MessageId::AddressAnnouncement;
  const bool isAnnouncement =
      hasTypeOf(frame, kAnnouncement) && allows(messageOf(kAnnouncement).lengths, frame.length);
  const auto pin = isAnnouncement ? announcedPin(frame) : std::nullopt;
  for (Asked& at : m_devices) {
    Timing& timing = at.timing(Request::Reset);
    if (at.status(Request::Reset).progress != Progress::Waiting || !timing.isOnBus) continue;
    if (!isAnnouncement) {
      if (source == timing.to) timing.lastStatus = now;
      continue;
    }
    const bool isIt =
        at.device.kind == DeviceKey::Kind::Pin ? pin == at.device.pin : source == at.device.address;
    if (isIt && now - timing.lastStatus >= kRestart)
      end(now, live, at, Request::Reset, RequestEnd::Answered, out);
  }
}

}  // namespace deckpipe
