// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/pipe_end.h"

#include <algorithm>

#include "protocol/catalogue.h"
#include "simulator/identity.h"

namespace deckpipe::simulator {

void PipeEnd::misbehave(const PipeFaults& how) {
  if (how == m_faults) return;
  m_faults = how;
  m_in = m_acks = m_out = 0;
  m_vanished = false;
}

void PipeEnd::clear() {
  m_shell.clear();
  m_peer = kNullAddress;
  m_ackBy = kNever;
  m_taken = m_sent = 0;
  m_outgoing.clear();
}

bool PipeEnd::isTakenByAnother(Instant now, Address from) const {
  const bool busy = m_ackBy != kNever || m_shell.isBusy();
  return from != m_peer && m_peer != kNullAddress && busy && now - m_heardAt < kPeerSilence;
}

void PipeEnd::received(Instant now, Address from, std::span<const std::uint8_t> characters) {
  timeCame(now);
  if (characters.empty()) {
    if (from != m_peer) return;
    m_heardAt = now;
    if (m_ackBy == kNever) return;
    m_ackBy = kNever;
    m_shell.delivered();
    send(now);
    return;
  }
  if (isTakenByAnother(now, from) || m_faults.packetsUnheard.hits(++m_in)) return;
  if (from != m_peer) {
    m_shell.clear();
    m_ackBy = kNever;
    m_peer = from;
  }
  m_heardAt = now;
  ++m_taken;
  acknowledge(now);
  m_shell.received(now, characters);
  send(now);
}

void PipeEnd::acknowledge(Instant now) {
  if (m_faults.acksLost.hits(++m_acks)) return;
  const Outgoing ack{now + kThinking + m_faults.ackLate, m_peer, MessageId::PipeAck,
                     encoded(MessageId::PipeAck)};
  m_outgoing.insert(m_outgoing.end(), m_faults.ackTwice ? 2 : 1, ack);
}

void PipeEnd::timeCame(Instant now) {
  if (now >= m_ackBy) {
    m_ackBy = kNever;
    m_shell.giveUp(m_onItsWay);
  }
  m_shell.timeCame(now);
  send(now);
}

void PipeEnd::send(Instant now) {
  if (m_ackBy != kNever) return;
  const std::string text = m_shell.take(kPacket);
  if (text.empty()) return;
  m_onItsWay = text.size();
  m_ackBy = now + kAckTimeout;
  ++m_sent;
  if (m_faults.packetsLost.hits(++m_out)) return;
  Encoded data;
  data.length = static_cast<std::uint8_t>(1 + text.size());
  data.data[0] = typeOf(MessageId::PipeData);
  std::ranges::copy(text, data.data.begin() + 1);
  m_outgoing.push_back({now + kThinking, m_peer, MessageId::PipeData, data});
}

void PipeEnd::takeOutgoing(std::vector<Outgoing>& out) {
  out.insert(out.end(), m_outgoing.begin(), m_outgoing.end());
  m_outgoing.clear();
}

bool PipeEnd::vanishes() {
  if (m_vanished || m_faults.vanishAfter == 0 || m_in + m_out < m_faults.vanishAfter) return false;
  m_vanished = true;
  return true;
}

std::string PipeEnd::status() const {
  return "PIPE IN " + std::to_string(m_taken) + " OUT " + std::to_string(m_sent) + "\r\n";
}

}  // namespace deckpipe::simulator
