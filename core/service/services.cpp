// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/services.h"

#include <algorithm>
#include <utility>

#include "service/pipe_service.h"
#include "service/request_service.h"

namespace deckpipe {

Services::Services(const ServiceSettings& settings) : m_settings(settings), m_budget(settings.bitRate) {
  auto claim = std::make_unique<ClaimService>(settings.claim, settings.echoes);
  const ClaimService& own = *claim;
  add(std::move(claim));
  add(std::make_unique<RequestService>(m_budget, own));
  add(std::make_unique<PipeService>(own));
  m_status.echoes = settings.echoes;
}

Service& Services::add(std::unique_ptr<Service> service) {
  return *m_services.emplace_back(Entry{std::move(service)}).service;
}

template <typename F>
void Services::forEach(F&& call) {
  for (std::size_t i = 0; i < m_services.size(); ++i) {
    m_out.owner = static_cast<std::uint32_t>(i);
    call(*m_services[i].service);
  }
}

template <typename F>
void Services::forEachBackwards(F&& call) {
  for (std::size_t i = m_services.size(); i-- > 0;) {
    m_out.owner = static_cast<std::uint32_t>(i);
    call(*m_services[i].service);
  }
}

void Services::linkChanged(Instant now, const State& state, bool isUp) {
  if (isUp == m_status.linkUp) return;
  m_status.linkUp = isUp;
  const Live live = liveOf(state);
  if (isUp) {
    if (!m_status.locked) forEach([&](Service& service) { service.linkChanged(now, live, true, m_out); });
    return;
  }
  dropAgain(now, live);
  for (const OwnFrames::Own& own : m_own.takeAll()) writeEnded(now, live, own.tag, WriteOutcome::Gone);
  if (m_status.locked) return;
  forEachBackwards([&](Service& service) { service.linkChanged(now, live, false, m_out); });
  for (Entry& entry : m_services) entry.source = kNullAddress;
  m_out.frames.clear();
}

void Services::unlock(Instant now, const Live& live) {
  if (!std::exchange(m_status.locked, false)) return;
  m_out.note(NoteKind::Unlocked, live.channel, {}, 0);
  if (m_status.linkUp) forEach([&](Service& service) { service.linkChanged(now, live, true, m_out); });
}

void Services::lock(Instant now, const Live& live) {
  if (std::exchange(m_status.locked, true)) return;
  dropAgain(now, live);
  noteWaiting(live);
  forEachBackwards([&](Service& service) { service.end(now, live, EndReason::Locked, m_out); });
  for (Entry& entry : m_services) entry.source = kNullAddress;
  m_out.frames.clear();
  m_out.note(NoteKind::Locked, live.channel, {}, 0);
}

Refusal Services::apply(Instant now, const State& state, const Intent& intent) {
  const Refusal refusal = carryOut(now, liveOf(state), intent);
  m_status.refusal = refusal;
  if (refusal != Refusal::None) m_status.refusedSerial = intent.serial;
  return refusal;
}

Refusal Services::carryOut(Instant now, const Live& live, const Intent& intent) {
  if (std::holds_alternative<wish::Lock>(intent.value)) return lock(now, live), Refusal::None;
  if (std::holds_alternative<wish::Unlock>(intent.value)) return unlock(now, live), Refusal::None;
  if (m_status.locked) return Refusal::Locked;
  if (!m_status.linkUp) return Refusal::NoLink;
  std::optional<Refusal> answer;
  forEach([&](Service& service) {
    if (!answer) answer = service.wants(now, live, intent.value, m_out);
  });
  return answer.value_or(Refusal::NotTaken);
}

void Services::followAddresses(Instant now, const Live& live) {
  bool isLost = false;
  for (std::size_t i = 0; i < m_services.size(); ++i) {
    Entry& entry = m_services[i];
    const Address before = std::exchange(entry.source, entry.service->source());
    if (before == kNullAddress || before == entry.source) continue;
    m_out.owner = static_cast<std::uint32_t>(i);
    entry.service->end(now, live, EndReason::AddressLost, m_out);
    isLost = true;
  }
  if (isLost) noteWaiting(live);
}

// Nothing takes back what the adapter has.
void Services::noteWaiting(const Live& live) {
  if (m_own.waiting() > 0) m_out.note(NoteKind::StillWaits, live.channel, {}, m_own.waiting());
}

void Services::received(Instant at, const State& state, const Frame& frame) {
  if (frame.channel != m_settings.channel.value) return;
  m_budget.heard(at, frame);
  const Live live = liveOf(state);
  if ((frame.flags & Frame::kConfirmed) != 0) {
    if (const auto own = m_own.take(frame)) writeEnded(at, live, own->tag, WriteOutcome::OnBus);
  }
  if (!isOpen()) return;
  forEach([&](Service& service) {
    service.received(at, live, frame, m_out);
    followAddresses(at, live);
  });
}

void Services::writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome) {
  m_out.owner = tag.owner;
  m_services[tag.owner].service->writeEnded(now, live, tag, outcome, m_out);
  followAddresses(now, live);
}

void Services::wrote(Instant now, const State& state, const OutFrame& frame, WriteResult result) {
  const Live live = liveOf(state);
  if (result == WriteResult::Accepted) {
    if (!m_settings.echoes) return writeEnded(now, live, frame.tag, WriteOutcome::CannotTell);
    return m_own.wrote(frame.frame, frame.tag, now);
  }
  if (result == WriteResult::QueueFull && frame.triesAgain) {
    m_again.push_back({frame, now + kTryAgain});
    m_again.back().frame.triesAgain = false;
    return;
  }
  ++m_status.notTaken;
  const bool isFull = result == WriteResult::QueueFull;
  writeEnded(now, live, frame.tag, isFull ? WriteOutcome::QueueFull : WriteOutcome::NotTaken);
}

void Services::dropAgain(Instant now, const Live& live) {
  for (const Again& again : std::exchange(m_again, {})) {
    ++m_status.notTaken;
    writeEnded(now, live, again.frame.tag, WriteOutcome::QueueFull);
  }
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
}

Instant Services::nextTime() const {
  Instant next = kNever;
  if (!isOpen()) return next;
  for (const Again& again : m_again) next = std::min(next, again.due);
  for (const Entry& entry : m_services) next = std::min(next, entry.service->nextTime());
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
