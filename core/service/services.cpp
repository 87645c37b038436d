// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/services.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "service/pipe_service.h"
#include "service/request_service.h"

namespace deckpipe {

Services::Services(const ServiceSettings& settings) : m_settings(settings), m_budget(settings.bitRate) {
  auto claim = std::make_unique<ClaimService>(settings.claim);
  const ClaimService& own = *claim;
  add(std::move(claim));
  add(std::make_unique<RequestService>(m_budget, own));
  add(std::make_unique<PipeService>(settings.echoes, own));
}

Service& Services::add(std::unique_ptr<Service> service) {
  return *m_services.emplace_back(Entry{std::move(service)}).service;
}

void Services::linkChanged(Instant now, const State& state, bool isUp) {
  if (isUp == m_status.linkUp) return;
  m_status.linkUp = isUp;
  if (m_status.locked) return;
  const Live live = liveOf(state);
  if (isUp) {
    for (Entry& entry : m_services) entry.service->linkChanged(now, live, true, m_out);
    return;
  }
  for (Entry& entry : m_services | std::views::reverse) entry.service->linkChanged(now, live, false, m_out);
  for (Entry& entry : m_services) entry.source = kNullAddress;
  m_out.frames.clear();
}

void Services::unlock(Instant now, const Live& live) {
  if (!std::exchange(m_status.locked, false)) return;
  m_out.note(NoteKind::Unlocked, live.channel, {}, 0);
  if (!m_status.linkUp) return;
  for (Entry& entry : m_services) entry.service->linkChanged(now, live, true, m_out);
}

void Services::lock(Instant now, const Live& live) {
  if (std::exchange(m_status.locked, true)) return;
  for (Entry& entry : m_services | std::views::reverse)
    entry.service->end(now, live, EndReason::Locked, m_out);
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
  for (Entry& entry : m_services) {
    if (const auto answer = entry.service->wants(now, live, intent.value, m_out)) return *answer;
  }
  return Refusal::NotTaken;
}

void Services::followAddresses(Instant now, const Live& live) {
  for (Entry& entry : m_services) {
    const Address before = std::exchange(entry.source, entry.service->source());
    if (before != kNullAddress && before != entry.source)
      entry.service->end(now, live, EndReason::AddressLost, m_out);
  }
}

void Services::received(Instant at, const State& state, const Frame& frame) {
  if (frame.channel != m_settings.channel.value) return;
  m_budget.heard(at, frame);
  if (!isOpen()) return;
  const Live live = liveOf(state);
  for (Entry& entry : m_services) {
    entry.service->received(at, live, frame, m_out);
    followAddresses(at, live);
  }
}

void Services::timeCame(Instant now, const State& state) {
  if (!isOpen()) return;
  const Live live = liveOf(state);
  for (Entry& entry : m_services) {
    entry.service->timeCame(now, live, m_out);
    followAddresses(now, live);
  }
}

Instant Services::nextTime() const {
  Instant next = kNever;
  if (!isOpen()) return next;
  for (const Entry& entry : m_services) next = std::min(next, entry.service->nextTime());
  return next;
}

void Services::takeFrames(std::vector<Frame>& out) {
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
  m_status.busLoad = m_budget.load(now);
  m_status.devices.clear();
  for (const Entry& entry : m_services) entry.service->status(live, m_status);
  return m_status;
}

}  // namespace deckpipe
