// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/request_service.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "bus/j1939.h"
#include "protocol/lists.h"

namespace deckpipe {
namespace {

using Progress = RequestStatus::Progress;

// What a request and its whole answer take of the bus.
unsigned costOf(Request request) {
  const auto bits = [](MessageId id) {
    Frame frame;
    frame.id = kExtendedBit;
    frame.length = static_cast<std::uint8_t>(messageOf(id).maxLength());
    return estimatedBits(frame);
  };
  unsigned sum = bits(ruleOf(request).request);
  for (const MessageId answer : ruleOf(request).answers) sum += answer == kNoAnswer ? 0 : bits(answer);
  return sum;
}

Refusal whyNothingIsTaken(const Live& live, const Device& device) {
  return live.bus().isBeforeGap(device.lastHeard) ? Refusal::NotHeard : Refusal::NotTaken;
}

}  // namespace

RequestService::Asked& RequestService::asked(const DeviceKey& device) {
  for (Asked& known : m_devices) {
    if (known.device == device) return known;
  }
  return m_devices.emplace_back(Asked{device, {}, {}});
}

const RequestService::Asked* RequestService::find(const DeviceKey& device) const {
  for (const Asked& known : m_devices) {
    if (known.device == device) return &known;
  }
  return nullptr;
}

void RequestService::linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) {
  if (!isOpen) return endAll(now, live, RequestEnd::LinkLost, out);
  // Another device may be at an address by now.
  std::erase_if(m_devices, [](const Asked& at) { return at.device.kind == DeviceKey::Kind::Address; });
}

void RequestService::end(Instant now, const Live& live, EndReason reason, Outgoing& out) {
  endAll(now, live, reason == EndReason::AddressLost ? RequestEnd::AddressLost : RequestEnd::Cancelled, out);
}

std::optional<Refusal> RequestService::intentCame(Instant now, const Live& live, const Intent& intent,
                                                  Outgoing& out) {
  const auto ifAddressed = [&](auto&& carryOut) {
    if (source() == kNullAddress) return Refusal::NoAddress;
    adopt(now, live, out);
    return carryOut();
  };
  if (const auto* it = std::get_if<intent::SendRequests>(&intent))
    return ifAddressed([&] { return request(now, live, *it, out); });
  if (const auto* it = std::get_if<intent::Repeat>(&intent))
    return ifAddressed([&] { return repeat(now, live, *it, out); });
  if (const auto* it = std::get_if<intent::Cancel>(&intent))
    return ifAddressed([&] { return cancel(now, live, *it, out); });
  return {};
}

void RequestService::status(const Live& live, ServiceStatus& into) const {
  for (const DeviceKey& key : requestTargets(live)) statusOf(live, key, into);
  for (const Asked& known : m_devices) statusOf(live, known.device, into).requests = known.statuses;
  for (const Handed& command : m_commands) {
    if (command.isSaid) into.waitingCommands.push_back({command.device, command.request, command.since});
  }
}

void RequestService::queue(RequestStatus& status, Timing& timing, Instant due) {
  status.progress = Progress::Queued;
  status.tries = 0;
  timing = {.to = timing.to, .due = due};
  ++status.asked;
}

Refusal RequestService::request(Instant now, const Live& live, const intent::SendRequests& intent,
                                Outgoing& out) {
  if (intent.device.isNull()) {
    for (const DeviceKey& key : requestTargets(live))
      request(now, live, {key, intent.requests & kPolls}, out);
    return Refusal::None;
  }
  const Device* device = live.find(intent.device);
  if (device == nullptr || device->address == kNullAddress) return live.whyNowhere(intent.device);
  const RequestSet takes = requestsTakenBy(live, *device) & intent.requests;
  if (takes.isEmpty()) return whyNothingIsTaken(live, *device);
  // A silent device may be polled; nothing is sent to an address that is contested.
  const Refusal why = live.whyNotTo(now, intent.device);
  if (m_own.isDisputed() && (takes & kPolls) != takes) return Refusal::Disputed;
  if (why == Refusal::Contested || (why != Refusal::None && (takes & kPolls) != takes)) return why;
  Asked& at = asked(live.canonical(intent.device));
  Refusal refusal = Refusal::Busy;
  takes.forEach([&](Request request) {
    RequestStatus& status = at.status(request);
    // A repeated poll that waits for its turn may as well come now.
    if (status.progress == Progress::Waiting || (status.isOpen() && status.period == 0ns)) return;
    if (isHanded(at.device, request)) return;
    queue(status, at.timing(request), now);
    refusal = Refusal::None;
    if (isCommand(request)) send(now, live, at, request, out);
  });
  sendDue(now, live, out);
  return refusal;
}

Refusal RequestService::repeat(Instant now, const Live& live, const intent::Repeat& intent, Outgoing& out) {
  if (intent.device.isNull()) {
    std::vector<DeviceKey> keys = requestTargets(live);
    if (intent.period == 0ns) {
      for (const Asked& known : m_devices) keys.push_back(known.device);
    }
    for (const DeviceKey& key : keys) repeat(now, live, {key, intent.requests, intent.period}, out);
    return Refusal::None;
  }
  const DeviceKey key = live.canonical(intent.device);
  if (intent.period == 0ns) {
    if (find(key) == nullptr) return Refusal::None;
    Asked& at = asked(key);
    intent.requests.forEach([&](Request request) {
      RequestStatus& status = at.status(request);
      if (status.period == 0ns) return;
      status.period = 0ns;
      if (status.progress != Progress::Queued) return;
      status.progress = status.end == RequestEnd::None ? Progress::Idle : Progress::Ended;
      at.timing(request) = {};
      --status.asked;
    });
    return Refusal::None;
  }
  const Device* device = live.find(key);
  if (device == nullptr || device->address == kNullAddress) return live.whyNowhere(key);
  const RequestSet takes = requestsTakenBy(live, *device) & intent.requests & kPolls;
  if (takes.isEmpty()) return whyNothingIsTaken(live, *device);
  Asked& at = asked(key);
  takes.forEach([&](Request request) {
    RequestStatus& status = at.status(request);
    status.period = std::max<Duration>(intent.period, intent::Repeat::kShortestPeriod);
    if (!status.isOpen()) {
      queue(status, at.timing(request), now);
    } else if (status.progress == Progress::Queued) {
      at.timing(request).due = std::min(at.timing(request).due, now);
    }
  });
  sendDue(now, live, out);
  return Refusal::None;
}

Refusal RequestService::cancel(Instant now, const Live& live, const intent::Cancel& intent, Outgoing& out) {
  const DeviceKey key = live.canonical(intent.device);
  for (Asked& at : m_devices) {
    if (key.isNull() || at.device == key) endDevice(now, live, at, RequestEnd::Cancelled, out);
  }
  return Refusal::None;
}

void RequestService::endAll(Instant now, const Live& live, RequestEnd how, Outgoing& out) {
  for (Asked& at : m_devices) endDevice(now, live, at, how, out);
  for (Handed& command : m_commands) sayNotOnBus(live, command, out);
}

void RequestService::endDevice(Instant now, const Live& live, Asked& at, RequestEnd how, Outgoing& out) {
  for (const Request request : kAllOf<Request>) {
    at.status(request).period = 0ns;
    if (at.status(request).isOpen()) end(now, live, at, request, how, out);
  }
}

void RequestService::send(Instant now, const Live& live, Asked& at, Request request, Outgoing& out) {
  const auto to = live.addressOf(at.device);
  if (!to) return end(now, live, at, request, RequestEnd::Gone, out);
  const RequestRule& rule = ruleOf(request);
  RequestStatus& status = at.status(request);
  Timing& timing = at.timing(request);
  // What may be asked of it can change after the intent: a drive is said to be one.
  if (!requestsTakenBy(live, *live.find(at.device)).has(request)) {
    status.period = 0ns;
    return end(now, live, at, request, RequestEnd::Cancelled, out);
  }
  // A command was refused before; a poll waits until it is decided whose the address is.
  if (live.bus().book.isContested(*to)) {
    if (status.progress == Progress::Waiting) {  // an earlier try may still be answered
      timing.deadline = now + kClaimTime;
      return;
    }
    status.progress = Progress::Queued;
    timing.due = now + kClaimTime;
    timing.deadline = kNever;
    return;
  }
  status.progress = Progress::Waiting;
  ++status.tries;
  status.sent = now;
  if (status.tries == 1) status.firstSent = now;
  timing.to = *to;
  timing.answers = 0;
  timing.isOnBus = false;
  timing.deadline = isCommand(request) ? kNever : now + rule.patience;
  Encoded data{.length = 1};
  data.data[0] = typeOf(rule.request);
  timing.tag = out.send(live, source(), rule.request, *to, data);
  if (isCommand(request)) m_commands.push_back({timing.tag, at.device, request, *to, now});
  m_nextPoll = std::max(m_nextPoll, now) + m_budget.gapAfter(now, costOf(request));
  // Of what is repeated only changes are noted, at its end.
  if (status.tries == 1 && status.period == 0ns) {
    if (isCommand(request)) noteAngles(live, at.device, *to, request, out);
    out.note(note::Asked{live.channel, *to, at.device.pin, request});
  }
}

// A report that is stale says nothing of where the device stands now.
void RequestService::noteAngles(const Live& live, const DeviceKey& key, Address to, Request request,
                                Outgoing& out) {
  const Device* device = live.find(key);
  if (device == nullptr || !device->position().isKnown() || device->isStale(MessageId::PositionLimitStatus))
    return;
  const auto angle = [](const PositionReading& reading) {
    note::NotedAngle noted;
    if (reading.state == PositionState::Ok) noted.tenths = reading.tenths;
    return noted;
  };
  const PositionLimitStatus position = device->position().value();
  const note::AnglesBefore before{
      live.channel, to, key.pin, request, angle(position.rotation), angle(position.elevation)};
  if (before.rotation.tenths || before.elevation.tenths) out.note(before);
}

void RequestService::end(Instant now, const Live& live, Asked& at, Request request, RequestEnd how,
                         Outgoing& out) {
  RequestStatus& status = at.status(request);
  Timing& timing = at.timing(request);
  const bool isNews = status.period == 0ns || how != status.end;
  status.progress = Progress::Ended;
  status.end = how;
  status.ended = now;
  if (how == RequestEnd::Answered) {
    ++status.answered;
    status.latency = std::max<Duration>(now - status.sent, 0ns);
  }
  if (isNews) noteEnd(live, at.device, timing.to, request, how, out);
  // Each try may still be answered.
  const int tries = how == RequestEnd::Answered ? status.tries - 1 : 0;
  timing = {.to = timing.to,
            .spare = static_cast<std::uint8_t>(tries * std::popcount(wholeAnswer(ruleOf(request))))};
  if (status.period == 0ns) return;
  // Without an address nothing was sent: it is looked for again a period from now, never at once.
  const bool wasSent = status.sent != kNotYet && how != RequestEnd::Gone;
  const Instant next = wasSent ? status.sent + status.period : now + status.period;
  queue(status, timing, std::max(next, now));
}

void RequestService::noteEnd(const Live& live, const DeviceKey& device, Address to, Request request,
                             RequestEnd how, Outgoing& out) {
  out.note(note::RequestEnded{live.channel, to, device.pin, request, how});
}

void RequestService::expire(Instant now, const Live& live, Asked& at, Request request, Outgoing& out) {
  const RequestRule& rule = ruleOf(request);
  if (!at.timing(request).isOnBus) return end(now, live, at, request, RequestEnd::NotOnBus, out);
  if (at.status(request).tries < rule.tries) return send(now, live, at, request, out);
  end(now, live, at, request, at.timing(request).wrong ? RequestEnd::WrongAnswer : RequestEnd::NoAnswer, out);
}

Instant RequestService::nextTime() const {
  Instant next = kNever;
  if (source() == kNullAddress) return next;
  for (const Handed& command : m_commands) {
    if (!command.isSaid) next = std::min(next, command.since + kOnBusTime);
  }
  for (const Asked& at : m_devices) {
    for (const Request request : kAllOf<Request>) {
      if (at.statuses[request].progress == Progress::Waiting)
        next = std::min(next, at.timings[request].deadline);
      if (at.statuses[request].progress == Progress::Queued)
        next = std::min(next, std::max(at.timings[request].due, m_nextPoll));
    }
  }
  return next;
}

void RequestService::timeCame(Instant now, const Live& live, Outgoing& out) {
  if (source() == kNullAddress) return;
  adopt(now, live, out);
  for (Handed& command : m_commands) {
    if (command.since + kOnBusTime <= now) sayNotOnBus(live, command, out);
  }
  for (Asked& at : m_devices) {
    for (const Request request : kAllOf<Request>) {
      if (at.status(request).progress == Progress::Waiting && at.timing(request).deadline <= now)
        expire(now, live, at, request, out);
    }
  }
  sendDue(now, live, out);
}

// Who has waited longest is next; of two the one that is first in the list.
void RequestService::sendDue(Instant now, const Live& live, Outgoing& out) {
  while (m_nextPoll <= now) {
    Asked* next = nullptr;
    Request kind{};
    Instant due = now;
    for (Asked& at : m_devices) {
      for (const Request request : kAllOf<Request>) {
        if (at.status(request).progress != Progress::Queued || at.timing(request).due > due) continue;
        if (next != nullptr && at.timing(request).due == due) continue;
        next = &at;
        kind = request;
        due = at.timing(request).due;
      }
    }
    if (next == nullptr) return;
    send(now, live, *next, kind, out);
  }
}

void RequestService::adopt(Instant now, const Live& live, Outgoing& out) {
  for (Handed& command : m_commands) command.device = live.canonical(command.device);
  for (std::size_t i = 0; i < m_devices.size(); ++i) {
    if (m_devices[i].device.kind != DeviceKey::Kind::Address) continue;
    const DeviceKey key = live.canonical(m_devices[i].device);
    if (key == m_devices[i].device) continue;
    const bool isKnown = find(key) != nullptr;
    if (!isKnown) {
      m_devices[i].device = key;
    } else {  // the device was asked under its PIN before: of two in flight to it one has to end
      endDevice(now, live, m_devices[i], RequestEnd::Cancelled, out);
      m_devices.erase(m_devices.begin() + static_cast<std::ptrdiff_t>(i--));
    }
  }
}

}  // namespace deckpipe
