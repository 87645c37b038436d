// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/pipe.h"

#include <algorithm>
#include <utility>

#include "control/pipe_event.h"
#include "protocol/lists.h"

namespace deckpipe {
namespace {

using Progress = PipeStatus::Progress;
using Stall = PipeStatus::Stall;
using FileEnd = PipeStatus::FileEnd;
using Rest = PipeStatus::Rest;
using What = intent::PipeAction::What;

void notePipe(const Pipe::Turn& turn, const DeviceKey& device, Address address, PipeEvent event,
              const std::string& file = {}) {
  turn.out.note(note::Pipe{turn.live.channel, address, device.pin, event, file});
}

Address addressOf(const Pipe::Turn& turn, const DeviceKey& device) {
  return turn.live.addressOf(device).value_or(kNullAddress);
}

constexpr bool isHeld(Progress progress) {
  return progress == Progress::Paused || progress == Progress::Stalled;
}

}  // namespace

// Paused and stalled time is no time that the file took.
void Pipe::countHeld(Instant now) {
  if (m_heldSince == kNotYet) return;
  if (m_status.isSendingFile()) m_status.filePaused += now - m_heldSince;
  m_heldSince = now;
}

bool Pipe::move(Instant now, PipeMove what) {
  const auto to = after(m_status.progress, what);
  if (!to) return false;
  if (isHeld(m_status.progress)) countHeld(now);
  if (!isHeld(*to)) {
    m_heldSince = kNotYet;
    m_status.stall = Stall::None;
  } else if (m_heldSince == kNotYet) {
    m_heldSince = now;
  }
  m_status.progress = *to;
  if (*to == Progress::Settling && what != PipeMove::GiveUp) settle(now);
  return true;
}

void Pipe::settle(Instant now) { m_deadline = m_inAdapter.empty() ? now + kSettle : kNever; }

void Pipe::giveUpInFlight() {
  if (m_inFlight->fate == Packet::Fate::InAdapter) m_inAdapter.push_back(m_inFlight->tag);
  m_inFlight.reset();
}

// Where nothing is under way.
void Pipe::begin(Instant now) {
  m_begun = now;
  m_status.textSkipped = m_status.textResent = m_status.notTaken = 0;
}

Refusal Pipe::write(const Turn& turn, const std::string& bytes) {
  if (m_status.isSendingFile()) return Refusal::Busy;  // it would end up in the middle of the file
  if (waiting() + bytes.size() > kMaxTyped) return Refusal::TooMuch;
  if (!isUnderWay()) begin(turn.now);
  m_status.rest = Rest::Ask;
  m_status.notTaken = 0;
  m_typed += bytes;
  sendNext(turn);
  return Refusal::None;
}

Refusal Pipe::sendFile(const Turn& turn, const intent::PipeFile& intent) {
  if (isUnderWay()) return Refusal::Busy;
  begin(turn.now);
  m_content = intent.content;
  m_status.file = intent.name;
  m_status.fileSize = intent.content->size();
  m_status.fileSent = 0;
  m_status.fileEnd = FileEnd::None;
  m_status.fileBegan = turn.now;
  m_status.fileEnded = kNotYet;
  m_status.filePaused = 0ns;
  m_status.fileSkipped = m_status.fileResent = 0;
  notePipe(turn, m_device, addressOf(turn, m_device), PipeEvent::FileBegan, intent.name);
  if (m_status.fileSize == 0) endFile(turn, FileEnd::Done);
  sendNext(turn);
  return Refusal::None;
}

// The next packet, if one may go.
void Pipe::sendNext(const Turn& turn) {
  m_status.waiting = static_cast<std::uint32_t>(waiting());
  if (!after(m_status.progress, PipeMove::Next)) return;
  if (m_status.isPaused) {
    move(turn.now, PipeMove::Hold);
    return;
  }
  Packet packet;
  if (waiting() > 0) {
    packet.bytes = m_typed.substr(m_typedFrom, kPacket);
    m_typedFrom += packet.bytes.size();
    if (waiting() == 0) {
      m_typed.clear();
      m_typedFrom = 0;
    }
  } else if (m_status.isSendingFile()) {
    packet.bytes = m_content->substr(m_status.fileSent, kPacket);
    packet.isOfFile = true;
  }
  m_status.waiting = static_cast<std::uint32_t>(waiting());
  if (packet.bytes.empty()) {
    m_status.rest = Rest::Ask;
    move(turn.now, PipeMove::Nothing);
    return;
  }
  m_inFlight = std::move(packet);
  move(turn.now, PipeMove::Next);
  fly(turn);
}

void Pipe::fly(const Turn& turn) {
  Packet& packet = *m_inFlight;
  packet.fate = Packet::Fate::NotSent;
  packet.to = addressOf(turn, m_device);
  m_status.refusal = turn.live.whyNoPacketTo(turn.now, m_device);
  if (m_status.refusal != Refusal::None) return stall(turn, Stall::NotSent);
  packet.sent = turn.now;
  packet.fate = Packet::Fate::InAdapter;
  m_deadline = turn.now + kAckTimeout;
  Encoded data{.length = static_cast<std::uint8_t>(1 + packet.bytes.size())};
  data.data[0] = typeOf(MessageId::PipeData);
  std::ranges::transform(packet.bytes, data.data.begin() + 1,
                         [](char c) { return static_cast<std::uint8_t>(c); });
  packet.tag = turn.out.send(turn.live, turn.from, MessageId::PipeData, packet.to, data);
}

void Pipe::writeEnded(const Turn& turn, FrameTag tag, WriteOutcome outcome) {
  if (std::erase(m_inAdapter, tag) > 0) return settle(turn.now);
  if (!m_inFlight || m_inFlight->tag != tag) return;
  switch (outcome) {
    case WriteOutcome::OnBus:
    case WriteOutcome::CannotTell:
    case WriteOutcome::EchoLost:
      m_inFlight->fate = Packet::Fate::OnBus;
      m_inFlight->sent = turn.now;
      m_deadline = turn.now + kAckTimeout;
      move(turn.now, PipeMove::LateEcho);
      return;
    case WriteOutcome::QueueFull:
    case WriteOutcome::NotTaken:
      m_inFlight->fate = Packet::Fate::NotSent;
      return stall(turn, Stall::NotTaken);
    case WriteOutcome::Gone:
      m_inFlight->fate = Packet::Fate::OnBus;
      return;  // perhaps; a lost link ends the pipe
  }
}

void Pipe::ackHeard(const Turn& turn, Address source) {
  if (!m_inFlight || m_inFlight->to != source || m_inFlight->fate != Packet::Fate::OnBus) {
    ++m_status.strayAcks;
    return;
  }
  const Duration took = std::max<Duration>(turn.now - m_inFlight->sent, 0ns);
  m_inARow = 0;
  ++m_status.acks;
  m_status.ackLast = took;
  m_status.ackWorst = std::max(m_status.ackWorst, took);
  m_status.ackSum += took;
  if (m_status.progress == Progress::Stalled) {
    ++m_status.lateAcks;
    notePipe(turn, m_device, m_inFlight->to, PipeEvent::AckLate);
  }
  move(turn.now, m_inFlight->wasResent ? PipeMove::AckAgain : PipeMove::Ack);
  passed(turn);
  sendNext(turn);
}

// The packet in flight counts as delivered.
void Pipe::passed(const Turn& turn) {
  const Packet packet = std::move(*m_inFlight);
  m_inFlight.reset();
  if (m_status.progress != Progress::Settling) m_deadline = kNever;
  m_status.sent += packet.bytes.size();
  if (!packet.isOfFile || !m_status.isSendingFile()) return;
  m_status.fileSent += packet.bytes.size();
  if (m_status.fileSent >= m_status.fileSize) endFile(turn, FileEnd::Done);
}

void Pipe::endFile(const Turn& turn, FileEnd how) {
  if (!m_status.isSendingFile()) return;
  countHeld(turn.now);
  m_status.isPaused = false;
  m_status.rest = Rest::Ask;
  m_status.fileEnd = how;
  m_status.fileEnded = turn.now;
  m_content.reset();
  const PipeEvent event = how == FileEnd::Done        ? PipeEvent::FileDone
                          : how == FileEnd::Cancelled ? PipeEvent::FileCancelled
                                                      : PipeEvent::FileAborted;
  notePipe(turn, m_device, addressOf(turn, m_device), event, m_status.file);
}

void Pipe::stall(const Turn& turn, Stall why) {
  if (!move(turn.now, PipeMove::Silence)) return;
  m_deadline = kNever;
  m_status.stall = why;
  notePipe(turn, m_device, m_inFlight->to, PipeEvent::Stalled);
  const Rest rest = std::exchange(m_status.rest, Rest::Ask);
  if (rest == Rest::Ask || why != Stall::NoAck || m_inARow >= kMaxMissingAcks) return;
  m_status.rest = rest;
  ++m_inARow;
  if ((rest == Rest::Skip ? skip(turn) : resend(turn)) != Refusal::None) m_status.rest = Rest::Ask;
}

PipeStatus::Stall Pipe::whyNoAck(const Live& live) const {
  if (m_inFlight->fate == Packet::Fate::InAdapter) return Stall::NotOnBus;
  const auto address = live.addressOf(m_device);
  if (!address) return Stall::Gone;
  return *address != m_inFlight->to ? Stall::Moved : Stall::NoAck;
}

void Pipe::followDevice(const Turn& turn) {
  const Device* device = turn.live.find(m_device);
  // Whoever says who it is from another address has moved.
  if (device != nullptr && isUnderWay() && device->restarted > std::max(m_begun, device->addressSince))
    return deviceRestarted(turn);
  if (m_status.progress == Progress::Stalled && m_inFlight->fate != Packet::Fate::NotSent)
    m_status.stall = whyNoAck(turn.live);
}

// It does not know any more what was sent before, and the rest alone would be another text.
void Pipe::deviceRestarted(const Turn& turn) {
  ++m_status.restarts;
  const std::size_t inFlight = m_inFlight && !m_inFlight->isOfFile ? m_inFlight->bytes.size() : 0;
  m_status.notTaken = static_cast<std::uint32_t>(waiting() + inFlight);
  notePipe(turn, m_device, addressOf(turn, m_device), PipeEvent::DeviceRestarted);
  drop(turn, FileEnd::Restarted);
}

Refusal Pipe::act(const Turn& turn, const intent::PipeAction& action) {
  switch (action.what) {
    case What::Pause: m_status.isPaused = true; break;
    case What::Resume: m_status.isPaused = false; break;
    case What::Cancel: cancelFile(turn); break;
    case What::Resend: return decide(turn, Rest::Resend, action.forTheRest);
    case What::Skip: return decide(turn, Rest::Skip, action.forTheRest);
    case What::Abort: drop(turn); return Refusal::None;
  }
  sendNext(turn);
  return Refusal::None;
}

Refusal Pipe::decide(const Turn& turn, Rest what, bool forTheRest) {
  m_status.rest = forTheRest ? what : Rest::Ask;  // before it may end with what it is about
  m_inARow = 1;
  const Refusal why = what == Rest::Skip ? skip(turn) : resend(turn);
  if (why != Refusal::None) m_status.rest = Rest::Ask;
  return why;
}

Refusal Pipe::resend(const Turn& turn) {
  if (!after(m_status.progress, PipeMove::Resend) || m_inFlight->fate == Packet::Fate::InAdapter)
    return Refusal::Busy;
  if (const Refusal why = turn.live.whyNoPacketTo(turn.now, m_device); why != Refusal::None) return why;
  move(turn.now, PipeMove::Resend);
  if (m_inFlight->fate == Packet::Fate::OnBus) {
    ++m_status.resent;
    ++(m_inFlight->isOfFile ? m_status.fileResent : m_status.textResent);
    m_inFlight->wasResent = true;
    notePipe(turn, m_device, m_inFlight->to, PipeEvent::Resent);
  }
  fly(turn);
  return Refusal::None;
}

Refusal Pipe::skip(const Turn& turn) {
  if (!after(m_status.progress, PipeMove::Skip)) return Refusal::Busy;
  if (m_inFlight->fate == Packet::Fate::InAdapter) m_inAdapter.push_back(m_inFlight->tag);
  move(turn.now, PipeMove::Skip);
  ++m_status.skipped;
  ++(m_inFlight->isOfFile ? m_status.fileSkipped : m_status.textSkipped);
  notePipe(turn, m_device, m_inFlight->to, PipeEvent::Skipped);
  passed(turn);
  return Refusal::None;
}

// A packet whose ack is in doubt goes with its file.
void Pipe::cancelFile(const Turn& turn) {
  const bool isInDoubt = m_status.progress == Progress::Stalled && m_inFlight->isOfFile;
  endFile(turn, FileEnd::Cancelled);
  if (!isInDoubt) return;
  giveUpInFlight();
  move(turn.now, PipeMove::GiveUp);
  settle(turn.now);
}

void Pipe::drop(const Turn& turn, FileEnd how) {
  const bool wasInFlight = m_inFlight.has_value();
  const bool had = wasInFlight || waiting() > 0;
  if (wasInFlight) giveUpInFlight();
  m_status.isPaused = false;
  m_status.rest = Rest::Ask;
  m_typed.clear();
  m_typedFrom = 0;
  m_status.waiting = 0;
  if (m_status.isSendingFile()) {
    endFile(turn, how);
  } else if (had) {
    notePipe(turn, m_device, addressOf(turn, m_device), PipeEvent::Dropped);
  }
  move(turn.now, PipeMove::GiveUp);
  if (wasInFlight) settle(turn.now);
}

void Pipe::take(const Turn& turn, Pipe&& other) {
  if (other.isBusy() && isBusy()) {
    other.drop(turn);
    drop(turn);
    m_inAdapter.insert(m_inAdapter.end(), other.m_inAdapter.begin(), other.m_inAdapter.end());
    move(turn.now, PipeMove::Joined);
  } else if (other.isBusy()) {
    std::swap(*this, other);
    std::swap(m_device, other.m_device);
  }
  const PipeStatus& more = other.m_status;
  m_status.sent += more.sent;
  m_status.received += more.received;
  m_status.skipped += more.skipped;
  m_status.resent += more.resent;
  m_status.lateAcks += more.lateAcks;
  m_status.strayAcks += more.strayAcks;
  m_status.restarts += more.restarts;
  m_status.acks += more.acks;
  m_status.ackSum += more.ackSum;
  m_status.ackWorst = std::max(m_status.ackWorst, more.ackWorst);
}

void Pipe::timeCame(const Turn& turn) {
  if (m_deadline > turn.now) return;
  m_deadline = kNever;
  if (move(turn.now, PipeMove::Settled)) return sendNext(turn);
  if (m_status.progress == Progress::Sending) stall(turn, whyNoAck(turn.live));
}

}  // namespace deckpipe
