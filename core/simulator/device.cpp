// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/device.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace deckpipe::simulator {
namespace {

// How long a controller takes to answer: ours, the manual does not give it.
constexpr Duration kThinking = 2ms;

// Of the answer to a fault poll: older firmware has no pCode error code.
constexpr int kShortFaultLength = 5;

void cut(Encoded& data, int length) {
  data.length = static_cast<std::uint8_t>(length);
  std::fill(data.data.begin() + data.length, data.data.end(), std::uint8_t{0});
}
void shorten(Encoded& data) { cut(data, data.length > 1 ? data.length - 1 : 2); }

std::string versionText(std::uint16_t version) { return toText(Value::version(version)); }

}  // namespace

Device::Device(Identity identity, Duration period, std::uint64_t seed, AddressClaim::Range range)
    : m_identity(std::move(identity)),
      m_period(period),
      m_claim(m_identity.name, range, seed),
      m_random(seed + 1),
      m_pipe(*this) {}

void Device::misbehave(const Misbehaviour& how) {
  if (how.answers != m_misbehaviour.answers) m_answers = 0;
  m_pipe.misbehave(how.pipe);
  m_misbehaviour = how;
}

void Device::powerOff() {
  m_running = false;
  m_claim.stop();
  m_outbox.clear();
  forget();
  m_tickAt = m_startAt = kNever;
}

void Device::powerOn(Instant now, Duration boot) {
  powerOff();
  m_startAt = now + boot;
}

void Device::reset(Instant now) { powerOn(now, m_misbehaviour.resetTakes); }

// What was under way with others, who knew it by the address it had.
void Device::forget() {
  m_late.clear();
  m_pipe.clear();
}

Instant Device::nextTime() const {
  return std::min({m_startAt, m_tickAt, m_claim.nextTime(), m_outbox.nextTime(), m_pipe.nextTime(),
                   m_late.empty() ? kNever : m_late.front().time});
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
    if (std::exchange(m_hasRun, true) && m_misbehaviour.elsewhere) {
      m_claim.startElsewhere(now, m_outbox);
    } else {
      m_claim.start(now, m_outbox);
    }
  }
  if (m_claim.timeCame(now, m_outbox) == AddressClaim::Event::Claimed) announce(now);
  if (m_tickAt <= now) {
    m_tickAt = m_tickAt + m_period;
    tick(now);
  }
  if (m_pipe.nextTime() <= now) {
    m_pipe.timeCame(now);
    sendPipe(now);
  }
  while (!m_late.empty() && m_late.front().time <= now) {
    m_outbox.post(m_late.front().time, m_late.front().frame);
    m_late.erase(m_late.begin());
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
  switch (m_claim.received(now, id, frame, m_outbox)) {
    case AddressClaim::Event::Answered: announce(now); break;
    case AddressClaim::Event::Lost: forget(); break;
    default: break;
  }
  if (isForUs(id) && frame.length > 0 && isAkron()) heardRequest(now, id, frame);
  heard(now, id, frame);
}

void Device::heardRequest(Instant now, const J1939Id& id, const Frame& frame) {
  if (hasTypeOf(frame, MessageId::PipeData)) {
    m_pipe.received(now, id.source, frame.bytes().subspan(1));
    sendPipe(now);
    if (!m_pipe.vanishes()) return;
    const Duration away = m_misbehaviour.pipe.returnAfter;
    powerOff();
    if (away > 0ns) m_startAt = now + away;
  } else if (frame.length == 1) {
    answerPoll(now, frame, id.source);
  }
}

void Device::answerPoll(Instant now, const Frame& frame, Address to) {
  const auto reply = [&](MessageId id, std::initializer_list<FieldValue> values) {
    Encoded data = encoded(id, values);
    if (id == MessageId::FaultResponse && m_misbehaviour.answers.shortFault) cut(data, kShortFaultLength);
    answer(now, id, data, to);
  };
  const FirmwareVersions& firmware = m_identity.firmware;
  const PcodeVersion& pcode = m_identity.pcode;
  const ConfigVersion& config = m_identity.config;
  if (hasTypeOf(frame, MessageId::FaultPoll)) {
    reply(MessageId::FaultResponse,
          {{"faults", Value::numbers(faultMap())}, {"pcode_error", Value::integer(errorCode())}});
  } else if (hasTypeOf(frame, MessageId::FirmwarePoll)) {
    reply(MessageId::FirmwareResponse, {{"fixed_boot", Value::version(firmware.fixedBoot)},
                                        {"bootloader", Value::version(firmware.bootloader)},
                                        {"system", Value::version(firmware.system)}});
  } else if (hasTypeOf(frame, MessageId::PcodePoll)) {
    reply(MessageId::PcodeResponse, {{"style", Value::integer(pcode.style)},
                                     {"subtype", Value::integer(pcode.subtype)},
                                     {"version", Value::version(pcode.version)}});
  } else if (hasTypeOf(frame, MessageId::ConfigPoll)) {
    reply(MessageId::ConfigResponse,
          {{"config_type", Value::integer(config.type)}, {"version", Value::version(config.version)}});
  }
}

std::uint32_t Device::faultMap() const {
  return m_misbehaviour.faultBits | (m_outbox.dropped() > 0 ? faultBit("can_output_overrun") : 0);
}

// Appendix A: on every successful claim, and after every answer to a request for the NAME. Nothing but a NAME
// may come from the null address.
void Device::announce(Instant now) {
  if (m_identity.pin && address() != kNullAddress)
    m_outbox.post(now, announcementFrame(*m_identity.pin, address()));
}

Frame Device::made(MessageId id, Encoded data, Address source, Address to) const {
  if (m_misbehaviour.wrongLengths) shorten(data);
  return j1939Frame(messageOf(id), data, source, to);
}

// Frames leave in the order they are posted, so one that is to come late is posted when its time has come.
void Device::post(Instant due, Duration late, const Frame& frame) {
  if (late <= 0ns) {
    m_outbox.post(due, frame);
    return;
  }
  const auto after = std::upper_bound(m_late.begin(), m_late.end(), due + late,
                                      [](Instant t, const DueFrame& f) { return t < f.time; });
  m_late.insert(after, {due + late, frame});
}

void Device::broadcastFrom(Instant now, MessageId id, const Encoded& data, Address source) {
  if (source == kNullAddress) return;
  Duration late = m_misbehaviour.late;
  if (m_misbehaviour.jitter > 0ns) late += m_misbehaviour.jitter * m_random.between(0, 1000) / 1000;
  m_outbox.post(now + late, made(id, data, source, kGlobalAddress));
}

void Device::answer(Instant now, MessageId id, Encoded data, Address to) {
  const AnswerFaults& faults = m_misbehaviour.answers;
  if (faults.lost.hits(++m_answers)) return;
  if (faults.wrongLength) shorten(data);
  Address source = address();
  if (faults.wrongSource) ++source.value;
  const Frame frame = made(id, data, source, to);
  for (int times = faults.twice ? 2 : 1; times > 0; --times) post(now + kThinking, faults.late, frame);
}

void Device::sendPipe(Instant now) {
  m_pipeOut.clear();
  m_pipe.takeOutgoing(m_pipeOut);
  for (const PipeEnd::Outgoing& packet : m_pipeOut) {
    const Duration wait = packet.due - now;
    const Duration late = wait - PipeEnd::kThinking;
    post(packet.due - late, late, made(packet.message, packet.data, address(), packet.to));
  }
}

std::string Device::banner() const {
  std::string text = m_identity.model;
  if (m_identity.pin) text += ' ' + std::string(m_identity.pin->text());
  return text + " v" + versionText(m_identity.firmware.system) + "\r\n";
}

std::string Device::versions() const {
  const FirmwareVersions& firmware = m_identity.firmware;
  char config[16];
  std::snprintf(config, sizeof config, "%08u", static_cast<unsigned>(m_identity.config.type));
  return "FIXED BOOT " + versionText(firmware.fixedBoot) + "\r\nBOOTLOADER " +
         versionText(firmware.bootloader) + "\r\nSYSTEM " + versionText(firmware.system) + "\r\nPCODE " +
         std::to_string(m_identity.pcode.style) + '.' + std::to_string(m_identity.pcode.subtype) + ' ' +
         versionText(m_identity.pcode.version) + "\r\nCONFIG " + config + ' ' +
         versionText(m_identity.config.version) + "\r\n";
}

std::string Device::status() const {
  char line[64];
  std::snprintf(line, sizeof line, "ADDRESS %02X\r\nFAULTS %08X\r\nERROR CODE %u\r\n",
                static_cast<unsigned>(address().value), static_cast<unsigned>(faultMap()),
                static_cast<unsigned>(errorCode()));
  return line + m_pipe.status() + ownStatus();
}

}  // namespace deckpipe::simulator
