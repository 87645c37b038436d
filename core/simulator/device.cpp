// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/device.h"

#include <algorithm>
#include <utility>

namespace deckpipe::simulator {
namespace {

// How long a controller takes to answer, and to come back after a reset: ours, the manual gives neither.
constexpr Duration kThinking = 2ms;
constexpr Duration kReset = 1500ms;

}  // namespace

Device::Device(Identity identity, Duration period, std::uint64_t seed, AddressClaim::Range range)
    : m_identity(std::move(identity)),
      m_period(period),
      m_claim(m_identity.name, range, seed),
      m_random(seed + 1) {}

void Device::powerOn(Instant now, Duration boot) {
  m_running = false;
  m_claim.stop();
  m_outbox.clear();
  m_tickAt = kNever;
  m_startAt = now + boot;
}

void Device::reset(Instant now) { powerOn(now, kReset); }

Instant Device::nextTime() const {
  return std::min({m_startAt, m_tickAt, m_claim.nextTime(), m_outbox.nextTime()});
}

void Device::timeCame(Instant now) {
  for (Instant t = nextTime(); t <= now && t != kNever; t = nextTime()) step(t);
}

void Device::step(Instant now) {
  if (m_startAt <= now) {
    m_startAt = kNever;
    m_running = true;
    if (m_period > 0ns) m_tickAt = now + m_period;
    started(now);
    m_claim.start(now, m_outbox);
  }
  if (m_claim.timeCame(now, m_outbox) == AddressClaim::Event::Claimed) announce(now);
  if (m_tickAt <= now) {
    m_tickAt = m_tickAt + m_period;
    tick(now);
  }
  const std::size_t before = m_ready.size();
  m_outbox.takeDue(now, m_ready);
  if (m_misbehaviour.silent) m_ready.resize(before);
}

void Device::takeFrames(std::vector<DueFrame>& out) {
  out.insert(out.end(), m_ready.begin(), m_ready.end());
  m_ready.clear();
}

void Device::received(Instant now, const Frame& frame) {
  timeCame(now);
  if (!m_running || !frame.isExtended() || frame.isRemote() || frame.isError() || frame.length > 8) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  if (m_claim.received(now, id, frame, m_outbox) == AddressClaim::Event::Answered) announce(now);
  if (isForUs(id) && frame.length == 1) answerPoll(now, id, frame);
  heard(now, id, frame);
}

// Appendix A: on every successful claim, and after every answer to a request for the NAME. Nothing but a NAME
// may come from the null address.
void Device::announce(Instant now) {
  if (m_identity.pin && address() != kNullAddress)
    m_outbox.post(now, announcementFrame(*m_identity.pin, address()));
}

void Device::answerPoll(Instant now, const J1939Id& id, const Frame& frame) {
  const auto isPoll = [&](MessageId poll) { return frame.data[0] == messageOf(poll).firstByte; };
  if (isPoll(MessageId::FaultPoll)) {
    const std::uint32_t overrun = m_outbox.dropped() > 0 ? faultBit("can_output_overrun") : 0;
    answer(now, MessageId::FaultResponse,
           encoded(MessageId::FaultResponse, {{"faults", Value::numbers(m_misbehaviour.faultBits | overrun)},
                                              {"pcode_error", Value::integer(pcodeError())}}),
           id.source);
  } else if (isPoll(MessageId::FirmwarePoll)) {
    const FirmwareVersions& v = m_identity.firmware;
    answer(now, MessageId::FirmwareResponse,
           encoded(MessageId::FirmwareResponse, {{"fixed_boot", versionValue(v.fixedBoot)},
                                                 {"bootloader", versionValue(v.bootloader)},
                                                 {"system", versionValue(v.system)}}),
           id.source);
  } else if (isPoll(MessageId::PcodePoll)) {
    const PcodeVersion& v = m_identity.pcode;
    answer(now, MessageId::PcodeResponse,
           encoded(MessageId::PcodeResponse, {{"style", Value::integer(v.style)},
                                              {"subtype", Value::integer(v.subtype)},
                                              {"version", versionValue(v.version)}}),
           id.source);
  } else if (isPoll(MessageId::ConfigPoll)) {
    const ConfigVersion& v = m_identity.config;
    answer(now, MessageId::ConfigResponse,
           encoded(MessageId::ConfigResponse,
                   {{"config_type", Value::integer(v.type)}, {"version", versionValue(v.version)}}),
           id.source);
  }
}

Frame Device::made(MessageId id, Encoded data, Address source, Address to) const {
  if (m_misbehaviour.wrongLengths) {
    data.length = static_cast<std::uint8_t>(data.length > 1 ? data.length - 1 : 2);
    std::fill(data.data.begin() + data.length, data.data.end(), std::uint8_t{0});
  }
  return j1939Frame(messageOf(id), data, source, to);
}

void Device::broadcastFrom(Instant now, MessageId id, const Encoded& data, Address source) {
  if (source == kNullAddress) return;
  Duration late = m_misbehaviour.late;
  if (m_misbehaviour.jitter > 0ns) late += m_misbehaviour.jitter * m_random.between(0, 1000) / 1000;
  m_outbox.post(now + late, made(id, data, source, kGlobalAddress));
}

void Device::answer(Instant now, MessageId id, const Encoded& data, Address to) {
  m_outbox.post(now + kThinking, made(id, data, address(), to));
}

}  // namespace deckpipe::simulator
