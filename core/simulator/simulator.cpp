// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/simulator.h"

#include <algorithm>

#include "simulator/intruder.h"

namespace deckpipe::simulator {

template <typename F>
void Simulator::forEach(F&& f) const {
  for (const Member& member : m_members) {
    f(*member.device);
    if (member.intruder) f(*member.intruder);
  }
}

std::size_t Simulator::add(std::unique_ptr<Device> device, Duration boot) {
  m_members.push_back({std::move(device), boot, nullptr});
  return m_members.size() - 1;
}

void Simulator::powerOn(Instant now) {
  for (const Member& member : m_members) member.device->powerOn(now, member.boot);
}

void Simulator::misbehave(Instant when, std::size_t index, const Misbehaviour& how) {
  plan({when, index, how});
}

void Simulator::press(Instant when, std::size_t index, Button button) { plan({when, index, button}); }

void Simulator::plan(Planned what) {
  const auto later = std::upper_bound(m_plan.begin(), m_plan.end(), what.when,
                                      [](Instant t, const Planned& planned) { return t < planned.when; });
  m_plan.insert(later, std::move(what));
}

void Simulator::apply(Instant now, const Planned& planned) {
  Member& member = m_members[planned.index];
  if (const auto* how = std::get_if<Misbehaviour>(&planned.what)) {
    member.device->misbehave(*how);
    return;
  }
  switch (std::get<Button>(planned.what)) {
    case Button::PowerOff: member.device->powerOff(); break;
    case Button::PowerOn:
      if (!member.device->isPowered()) member.device->powerOn(now, member.boot);
      break;
    case Button::Reset:
      if (member.device->isPowered()) member.device->reset(now);
      break;
  }
}

Instant Simulator::nextTime() const {
  Instant next = m_plan.empty() ? kNever : m_plan.front().when;
  next = std::min(next, m_background.nextTime());
  forEach([&](const Device& device) { next = std::min(next, device.nextTime()); });
  return next;
}

void Simulator::timeCame(Instant now) {
  for (Instant t = nextTime(); t <= now && t != kNever; t = nextTime()) step(t);
}

void Simulator::received(Instant now, const Frame& frame) {
  timeCame(now);
  forEach([&](Device& device) { device.received(now, frame); });
  exchange(now);
}

void Simulator::takeFrames(std::vector<DueFrame>& out) {
  out.insert(out.end(), m_out.begin(), m_out.end());
  m_out.clear();
}

void Simulator::step(Instant now) {
  while (!m_plan.empty() && m_plan.front().when <= now) {
    const Planned due = std::move(m_plan.front());
    m_plan.erase(m_plan.begin());
    apply(now, due);
  }
  for (Member& member : m_members) placeIntruder(now, member);
  m_background.takeDue(now, m_out);  // nothing that a device listens to
  forEach([&](Device& device) { device.timeCame(now); });
  exchange(now);
}

void Simulator::placeIntruder(Instant now, Member& member) {
  const bool wanted = member.device->misbehaviour().addressTaken;
  if (!wanted) {
    member.intruder.reset();
  } else if (!member.intruder && member.device->address() != kNullAddress) {
    member.intruder = std::make_unique<Intruder>(member.device->address(), ++m_intruders);
    member.intruder->powerOn(now, Duration{0});
  }
}

// Passes on what was sent until nobody has sent anything more at this instant.
void Simulator::exchange(Instant now) {
  for (;;) {
    m_onBus.clear();
    forEach([&](Device& device) {
      m_fresh.clear();
      device.takeFrames(m_fresh);
      for (const DueFrame& frame : m_fresh) m_onBus.emplace_back(&device, frame);
    });
    if (m_onBus.empty()) return;
    for (const auto& [sender, sent] : m_onBus) {
      m_out.push_back(sent);
      forEach([&, from = sender, frame = sent.frame](Device& device) {
        if (&device != from) device.received(now, frame);
      });
    }
  }
}

}  // namespace deckpipe::simulator
