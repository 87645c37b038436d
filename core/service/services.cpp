// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/services.h"

#include <algorithm>
#include <utility>

namespace deckpipe {
namespace {

using How = note::OwnAddress::How;

}  // namespace

Services::Services(const ServiceSettings& settings)
    : m_settings(settings),
      m_budget(settings.bitRate),
      m_claim(settings.claim),
      m_requests(m_budget),
      m_pipes(settings.echoes) {}

void Services::linkChanged(Instant now, const State& state, bool isUp) {
  if (isUp == m_status.linkUp) return;
  m_status.linkUp = isUp;
  const Live live = liveOf(state);
  if (isUp) {
    if (!m_status.locked) m_claim.start(now, live, m_out);
    return;
  }
  m_requests.endAll(now, live, RequestEnd::LinkLost, m_out);
  m_pipes.endAll(now, live, m_out);
  m_claim.stop();
  m_out.frames.clear();
  if (live.own != kNullAddress) m_out.note(note::OwnAddress{live.channel, kNullAddress, How::LinkLost});
}

void Services::unlock(Instant now, const Live& live) {
  if (!std::exchange(m_status.locked, false)) return;
  m_out.note(note::Unlocked{live.channel});
  if (m_status.linkUp) m_claim.start(now, live, m_out);
}

void Services::lock(Instant now, const Live& live) {
  if (std::exchange(m_status.locked, true)) return;
  m_requests.endAll(now, live, RequestEnd::Cancelled, m_out);
  m_pipes.endAll(now, live, m_out);
  m_claim.stop();
  m_out.frames.clear();
  if (live.own != kNullAddress) m_out.note(note::OwnAddress{live.channel, kNullAddress, How::Locked});
  m_out.note(note::Locked{live.channel});
}

Refusal Services::apply(Instant now, const State& state, const Intent& intent) {
  const Refusal refusal = carryOut(now, liveOf(state), intent);
  m_status.refusal = refusal;
  if (refusal != Refusal::None) m_status.refusedSerial = intent.serial;
  return refusal;
}

Refusal Services::carryOut(Instant now, const Live& live, const Intent& intent) {
  m_requests.adopt(now, live, m_out);
  m_pipes.adopt(now, live, m_out);
  if (std::holds_alternative<wish::Lock>(intent.value)) return lock(now, live), Refusal::None;
  if (std::holds_alternative<wish::Unlock>(intent.value)) return unlock(now, live), Refusal::None;
  if (m_status.locked) return Refusal::Locked;
  if (!m_status.linkUp) return Refusal::NoLink;
  if (std::holds_alternative<wish::AskNames>(intent.value))
    return m_claim.askNames(live, m_out), Refusal::None;
  if (live.own == kNullAddress) return Refusal::NoAddress;
  struct Visitor {
    Services& services;
    Instant now;
    const Live& live;
    Refusal operator()(const wish::AskDevice& wish) const {
      return services.m_requests.ask(now, live, wish, services.m_out);
    }
    Refusal operator()(const wish::Repeat& wish) const {
      return services.m_requests.repeat(now, live, wish, services.m_out);
    }
    Refusal operator()(const wish::Cancel& wish) const {
      services.m_requests.cancel(now, live, wish.device, services.m_out);
      return Refusal::None;
    }
    Refusal operator()(const wish::PipeWrite& wish) const {
      return services.m_pipes.write(now, live, wish, services.m_out);
    }
    Refusal operator()(const wish::PipeFile& wish) const {
      return services.m_pipes.sendFile(now, live, wish, services.m_out);
    }
    Refusal operator()(const wish::PipeAction& wish) const {
      return services.m_pipes.act(now, live, wish, services.m_out);
    }
    Refusal operator()(const wish::Lock&) const { return Refusal::None; }
    Refusal operator()(const wish::Unlock&) const { return Refusal::None; }
    Refusal operator()(const wish::AskNames&) const { return Refusal::None; }
  };
  return std::visit(Visitor{*this, now, live}, intent.value);
}

void Services::addressChanged(Instant now, const Live& live, Address before) {
  if (before == kNullAddress || m_claim.address() == before) return;
  // What was asked was to be answered to the address that is no longer ours.
  m_requests.endAll(now, live, RequestEnd::AddressLost, m_out);
  m_pipes.endAll(now, live, m_out);
}

void Services::received(Instant now, const State& state, std::span<const Frame> frames) {
  timeCame(now, state);
  for (const Frame& frame : frames) {
    if (frame.channel != m_settings.channel.value) continue;
    m_budget.heard(now, frame);
    if (m_status.locked || !m_status.linkUp) continue;
    const Live live = liveOf(state);
    m_claim.received(now, live, frame, m_out);
    addressChanged(now, live, live.own);
    if (m_claim.address() == kNullAddress) continue;
    m_requests.received(now, live, frame, m_out);
    m_pipes.received(now, live, frame, m_out);
  }
}

void Services::timeCame(Instant now, const State& state) {
  if (m_status.locked || !m_status.linkUp) return;
  m_claim.timeCame(now, liveOf(state), m_out);
  if (m_claim.address() == kNullAddress) return;
  const Live live = liveOf(state);
  m_requests.adopt(now, live, m_out);
  m_pipes.adopt(now, live, m_out);
  m_requests.timeCame(now, live, m_out);
  m_pipes.timeCame(now, live, m_out);
}

Instant Services::nextTime() const {
  if (m_status.locked || !m_status.linkUp) return kNever;
  if (m_claim.address() == kNullAddress) return m_claim.nextTime();
  return std::min({m_claim.nextTime(), m_requests.nextTime(), m_pipes.nextTime()});
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
  m_status.claim = m_claim.status();
  m_status.busLoad = m_budget.load(now);
  m_status.devices.clear();
  const auto add = [&](const DeviceKey& key) {
    if (m_status.find(key) != nullptr) return;
    DeviceServices& device = m_status.devices.emplace_back();
    device.device = key;
    device.address = live.addressOf(key).value_or(kNullAddress);
    if (const Device* known = live.find(key)) device.takes = asksTakenBy(live, *known);
    if (const auto* requests = m_requests.statusOf(key)) device.requests = *requests;
    if (const PipeStatus* pipe = m_pipes.statusOf(key)) device.pipe = *pipe;
  };
  for (const DeviceKey& key : askableDevices(live)) add(key);
  m_requests.forEachDevice(add);
  m_pipes.forEachDevice(add);
  return m_status;
}

}  // namespace deckpipe
