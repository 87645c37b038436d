// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/services.h"

#include <algorithm>
#include <utility>

#include "bus/controller.h"
#include "bus/j1939.h"
#include "service/joystick_service.h"
#include "service/pipe_service.h"
#include "service/request_service.h"

namespace deckpipe {
Services::Services(const ServiceSettings& settings) : m_settings(settings), m_budget(settings.bitRate) {
  auto claim = std::make_unique<ClaimService>(settings.claim, settings.echoes);
  const ClaimService& own = *claim;
  add(std::move(claim));
  add(std::make_unique<RequestService>(m_budget, own));
  add(std::make_unique<PipeService>(own));
  using Echo = JoystickService::Echo;
  const Echo echo = settings.echoIsProven ? Echo::Proven : Echo::Unproven;
  add(std::make_unique<JoystickService>(settings.claim, settings.echoes ? echo : Echo::None));
  m_status.echoes = settings.echoes;
}

Service& Services::add(std::unique_ptr<Service> service) {
  return *m_services.emplace_back(Entry{std::move(service)}).service;
}

template <typename F>
void Services::callAt(std::size_t place, F&& call) {
  Entry& entry = m_services[place];
  if (entry.hasEnded) return;
  m_out.owner = static_cast<std::uint32_t>(place);
  call(*entry.service);
}

template <typename F>
void Services::forEach(F&& call) {
  for (std::size_t i = 0; i < m_services.size(); ++i) callAt(i, call);
}

template <typename F>
void Services::forEachBackwards(F&& call) {
  for (std::size_t i = m_services.size(); i-- > 0;) callAt(i, call);
}

void Services::linkChanged(Instant now, const State& state, bool isUp) {
  if (isUp == m_status.linkUp) return;
  m_status.linkUp = isUp;
  const Live live = liveOf(state);
  if (isUp) return begin(now, live);
  dropUnwritten(now, live);
  // A link that we close takes nothing along: what waits in the adapter may still go out.
  if (m_isClosed) {
    m_own.clear();
  } else {
    endOwn(now, live, WriteOutcome::Gone);
  }
  if (m_status.locked) return;
  forEachBackwards([&](Service& service) { service.linkChanged(now, live, false, m_out); });
  for (Entry& entry : m_services) entry.source = kNullAddress;
  m_out.frames.clear();
  complete(now, live);
}

void Services::setListenOnly(Instant now, const State& state, bool isListenOnly) {
  m_status.isListenOnly = isListenOnly;
  if (isListenOnly) endAll(now, liveOf(state), EndReason::Locked);
}

void Services::begin(Instant now, const Live& live) {
  if (!isOpen()) return;
  for (Entry& entry : m_services) entry.hasEnded = false;
  forEach([&](Service& service) { service.linkChanged(now, live, true, m_out); });
}

Refusal Services::unlock(Instant now, const Live& live) {
  if (!m_status.locked) return Refusal::None;
  if (m_isClosed || !m_status.linkUp) return Refusal::NoLink;
  if (m_status.isListenOnly) return Refusal::ListenOnly;
  m_status.locked = false;
  m_out.note(note::Unlocked{live.channel});
  begin(now, live);
  return Refusal::None;
}

void Services::close(Instant now, const State& state) {
  m_isClosed = true;
  if (m_status.locked) noteWaiting(liveOf(state), 0);
  endAll(now, liveOf(state), EndReason::Closing);
}

void Services::endAll(Instant now, const Live& live, EndReason reason) {
  if (m_status.locked || std::exchange(m_status.isEnding, true)) return;
  m_reason = reason;
  m_endBy = now + kEndingTime;
  if (!m_status.linkUp) return complete(now, live);  // that has ended everything already
  dropUnwritten(now, live);
  forEachBackwards([&](Service& service) {
    if (!service.endsLast()) service.end(now, live, reason, m_out);
  });
  followEnding(now, live);
}

void Services::followEnding(Instant now, const Live& live) {
  if (!m_status.isEnding) return;
  bool allEnded = true;
  for (Entry& entry : m_services) {
    if (entry.service->endsLast()) continue;
    entry.hasEnded = entry.hasEnded || entry.service->hasEnded();
    allEnded = allEnded && entry.hasEnded;
  }
  if (!allEnded && now < m_endBy) return;
  forEachBackwards([&](Service& service) {
    if (service.endsLast()) service.end(now, live, m_reason, m_out);
  });
  complete(now, live);
}

void Services::complete(Instant now, const Live& live) {
  m_status.isEnding = false;
  m_status.locked = true;
  m_endBy = kNever;
  giveUpAgain(now, live);
  for (Entry& entry : m_services) {
    entry.source = kNullAddress;
    entry.hasEnded = true;
  }
  noteWaiting(live, m_out.frames.size());  // what was said last is about to be handed to the adapter
  m_out.note(note::Locked{live.channel});
}

bool Services::controllerRead(Instant now, const State& state, const ControllerReading& reading) {
  if (!isOpen()) return false;
  const Live live = liveOf(state);
  forEach([&](Service& service) { service.controllerRead(now, live, reading, m_out); });
  followEnding(now, live);
  return !m_out.frames.empty();
}

Refusal Services::apply(Instant now, const State& state, const StampedIntent& intent) {
  return refuse(intent, carryOut(now, liveOf(state), intent));
}

Refusal Services::refuse(const StampedIntent& intent, Refusal why) {
  m_status.refusal = why;
  if (why != Refusal::None) m_status.refusedSerial = intent.serial;
  return why;
}

Refusal Services::carryOut(Instant now, const Live& live, const StampedIntent& intent) {
  if (std::holds_alternative<intent::Lock>(intent.value))
    return endAll(now, live, EndReason::Locked), Refusal::None;
  if (m_status.isEnding) return Refusal::Busy;
  if (std::holds_alternative<intent::Unlock>(intent.value)) return unlock(now, live);
  if (!m_status.linkUp) return Refusal::NoLink;
  if (m_status.locked) return Refusal::Locked;
  std::optional<Refusal> answer;
  forEach([&](Service& service) {
    if (!answer) answer = service.intentCame(now, live, intent.value, m_out);
  });
  return answer.value_or(Refusal::NotTaken);
}

// What was put out before from an address that is not ours any more would speak for whoever has it now.
void Services::dropLeft(Instant now, const Live& live) {
  const std::vector<Address> left = std::exchange(m_out.left, {});
  if (left.empty()) return;
  std::vector<OutFrame> dropped;
  const auto take = [&](const OutFrame& out) {
    const bool isOurs = std::ranges::count(left, J1939Id::of(out.frame.identifier()).source) == 0;
    if (!isOurs) dropped.push_back(out);
    return !isOurs;
  };
  std::erase_if(m_out.frames, take);
  std::erase_if(m_again, [&](const Again& again) { return take(again.frame); });
  for (const OutFrame& frame : dropped) writeEnded(now, live, frame.tag, WriteOutcome::NotTaken);
}

void Services::followAddresses(Instant now, const Live& live) {
  dropLeft(now, live);
  bool isLost = false;
  for (std::size_t i = 0; i < m_services.size(); ++i) {
    const Address before = std::exchange(m_services[i].source, m_services[i].service->source());
    if (before == kNullAddress || before == m_services[i].source) continue;
    callAt(i, [&](Service& service) { service.end(now, live, EndReason::AddressLost, m_out); });
    isLost = true;
  }
  if (isLost) noteWaiting(live, 0);  // what is about to be handed over is the claim of the next address
}

void Services::noteWaiting(const Live& live, std::size_t unwritten) {
  if (!m_settings.echoes) return;
  const std::size_t waiting = m_own.waiting() + unwritten;
  if (waiting > 0) m_out.note(note::StillWaits{live.channel, waiting});
}

void Services::received(Instant at, const State& state, const Frame& frame) {
  if (frame.channel != m_settings.channel.value) return;
  m_budget.heard(at, frame);
  const Live live = liveOf(state);
  if ((frame.flags & Frame::kConfirmed) != 0) {
    if (const auto own = m_own.take(frame))
      writeEnded(at, live, own->tag, m_status.echoes ? WriteOutcome::OnBus : WriteOutcome::CannotTell);
  }
  if (isRestart(frame)) endOwn(at, live, WriteOutcome::EchoLost);
  if (!isOpen()) return;
  forEach([&](Service& service) {
    service.received(at, live, frame, m_out);
    followAddresses(at, live);
  });
  followEnding(at, live);
}

void Services::writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome) {
  m_out.owner = tag.owner;
  m_services[tag.owner].service->writeEnded(now, live, tag, outcome, m_out);
  if (isOpen()) followAddresses(now, live);
}

void Services::endOwn(Instant now, const Live& live, WriteOutcome outcome) {
  for (const OwnFrames::Own& own : m_own.takeAll()) writeEnded(now, live, own.tag, outcome);
}

void Services::echoesLost(Instant now, const State& state) {
  const Live live = liveOf(state);
  endOwn(now, live, WriteOutcome::EchoLost);
  followEnding(now, live);
}

void Services::wrote(Instant now, const State& state, const OutFrame& frame, WriteResult result) {
  const Live live = liveOf(state);
  if (result == WriteResult::Accepted) {
    if (!m_settings.echoes) {
      writeEnded(now, live, frame.tag, WriteOutcome::CannotTell);
    } else if (const auto givenUp = m_own.wrote(frame.frame, frame.tag, now)) {
      writeEnded(now, live, givenUp->tag, WriteOutcome::EchoLost);
    }
    return followEnding(now, live);
  }
  if (result == WriteResult::QueueFull && frame.triesAgain) {
    m_again.push_back({frame, now + kTryAgain});
    m_again.back().frame.triesAgain = false;
    return;
  }
  ++m_status.notTaken;
  const bool isFull = result == WriteResult::QueueFull;
  writeEnded(now, live, frame.tag, isFull ? WriteOutcome::QueueFull : WriteOutcome::NotTaken);
  followEnding(now, live);
}

void Services::giveUpAgain(Instant now, const Live& live) {
  for (const Again& again : std::exchange(m_again, {})) {
    ++m_status.notTaken;
    writeEnded(now, live, again.frame.tag, WriteOutcome::NotTaken);
  }
}

void Services::dropUnwritten(Instant now, const Live& live) {
  giveUpAgain(now, live);
  for (const OutFrame& frame : std::exchange(m_out.frames, {}))
    writeEnded(now, live, frame.tag, WriteOutcome::NotTaken);
}

void Services::timeCame(Instant now, const State& state) {
  if (!isOpen()) return;
  const Live live = liveOf(state);
  std::erase_if(m_again, [&](const Again& again) {
    if (again.due > now) return false;
    m_out.frames.push_back(again.frame);
    return true;
  });
  forEach([&](Service& service) {
    service.timeCame(now, live, m_out);
    followAddresses(now, live);
  });
  followEnding(now, live);
}

Instant Services::nextTime() const {
  Instant next = kNever;
  if (!isOpen()) return next;
  if (m_status.isEnding) next = m_endBy;
  for (const Again& again : m_again) next = std::min(next, again.due);
  for (const Entry& entry : m_services) {
    if (!entry.hasEnded) next = std::min(next, entry.service->nextTime());
  }
  return next;
}

void Services::takeFrames(std::vector<OutFrame>& out) {
  m_status.sent += m_out.frames.size();
  out.insert(out.end(), m_out.frames.begin(), m_out.frames.end());
  m_out.frames.clear();
}

void Services::takeNotes(std::vector<Note>& out) {
  std::ranges::move(m_out.notes, std::back_inserter(out));
  m_out.notes.clear();
}

ServiceStatus Services::status(Instant now, const State& state) {
  const Live live = liveOf(state);
  m_status.unconfirmed = m_own.waitingSince(now - kOnBusTime);
  m_status.busLoad = m_budget.load(now);
  m_status.devices.clear();
  m_status.waitingCommands.clear();
  for (const Entry& entry : m_services) entry.service->status(live, m_status);
  return m_status;
}

}  // namespace deckpipe
