// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/pipe_service.h"

#include <algorithm>
#include <utility>

#include "bus/j1939.h"
#include "control/pipe_event.h"
#include "service/ask_rules.h"

namespace deckpipe {
namespace {

using Progress = PipeStatus::Progress;
using Stall = PipeStatus::Stall;
using FileEnd = PipeStatus::FileEnd;
using What = wish::PipeAction::What;

const std::uint8_t kType = static_cast<std::uint8_t>(messageOf(MessageId::PipeData).firstByte);

void note(const Live& live, const DeviceKey& device, Address address, PipeEvent event, std::string_view file,
          Outgoing& out) {
  std::string text(device.pin.text());
  if (!file.empty()) text.append(" ").append(file);
  out.note(NoteKind::Pipe, live.channel, address, static_cast<std::uint64_t>(event), std::move(text));
}

}  // namespace

PipeService::Pipe* PipeService::find(const DeviceKey& device) {
  const auto found = std::ranges::find(m_pipes, device, &Pipe::device);
  return found == m_pipes.end() ? nullptr : &*found;
}

PipeService::Pipe& PipeService::pipe(const DeviceKey& device) {
  if (Pipe* known = find(device)) return *known;
  Pipe& made = m_pipes.emplace_back();
  made.device = device;
  return made;
}

void PipeService::linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) {
  if (!isOpen) dropAll(now, live, out);
}

void PipeService::end(Instant now, const Live& live, EndReason, Outgoing& out) { dropAll(now, live, out); }

void PipeService::status(const Live& live, ServiceStatus& into) const {
  for (const Pipe& pipe : m_pipes) statusOf(live, pipe.device, into).pipe = pipe.status;
}

std::optional<Refusal> PipeService::wants(Instant now, const Live& live, const Wish& wish, Outgoing& out) {
  const auto ifAddressed = [&](auto&& carryOut) {
    if (source() == kNullAddress) return Refusal::NoAddress;
    adopt(now, live, out);
    return carryOut();
  };
  if (const auto* it = std::get_if<wish::PipeWrite>(&wish))
    return ifAddressed([&] { return write(now, live, *it, out); });
  if (const auto* it = std::get_if<wish::PipeFile>(&wish))
    return ifAddressed([&] { return sendFile(now, live, *it, out); });
  if (const auto* it = std::get_if<wish::PipeAction>(&wish))
    return ifAddressed([&] { return act(now, live, *it, out); });
  return {};
}

Refusal PipeService::write(Instant now, const Live& live, const wish::PipeWrite& wish, Outgoing& out) {
  if (!live.addressOf(wish.device)) return Refusal::NoDevice;
  Pipe& to = pipe(live.canonical(wish.device));
  if (to.status.isSendingFile()) return Refusal::Busy;  // it would end up in the middle of the file
  if (to.waiting() + wish.bytes.size() > kMostTyped) return Refusal::TooMuch;
  to.typed += wish.bytes;
  sendNext(now, live, to, out);
  return Refusal::None;
}

Refusal PipeService::sendFile(Instant now, const Live& live, const wish::PipeFile& wish, Outgoing& out) {
  const auto address = live.addressOf(wish.device);
  if (!address) return Refusal::NoDevice;
  Pipe& to = pipe(live.canonical(wish.device));
  if (to.status.isSendingFile() || to.waiting() > 0 || to.flying) return Refusal::Busy;
  to.content = wish.content;
  to.status.file = wish.name;
  to.status.fileSize = wish.content->size();
  to.status.fileSent = 0;
  to.status.fileEnd = FileEnd::None;
  to.status.fileBegan = now;
  to.status.fileEnded = kNotYet;
  to.status.filePaused = 0ns;
  to.status.fileSkipped = to.status.fileResent = 0;
  note(live, to.device, *address, PipeEvent::FileBegan, wish.name, out);
  if (to.status.fileSize == 0) endFile(now, live, to, FileEnd::Done, out);
  sendNext(now, live, to, out);
  return Refusal::None;
}

// The next packet, if one may go.
void PipeService::sendNext(Instant now, const Live& live, Pipe& pipe, Outgoing& out) {
  if (pipe.flying || pipe.status.progress == Progress::Settling) return;
  if (pipe.status.isPaused) return hold(now, pipe, Progress::Paused);
  Packet packet;
  if (pipe.waiting() > 0) {
    packet.bytes = pipe.typed.substr(pipe.typedFrom, kPacket);
    pipe.typedFrom += packet.bytes.size();
    if (pipe.waiting() == 0) {
      pipe.typed.clear();
      pipe.typedFrom = 0;
    }
  } else if (pipe.status.isSendingFile()) {
    packet.bytes = pipe.content->substr(pipe.status.fileSent, kPacket);
    packet.isOfFile = true;
  }
  pipe.status.waiting = static_cast<std::uint32_t>(pipe.waiting());
  if (packet.bytes.empty()) {
    pipe.status.progress = Progress::Idle;
    return;
  }
  pipe.flying = std::move(packet);
  fly(now, live, pipe, out);
}

void PipeService::fly(Instant now, const Live& live, Pipe& pipe, Outgoing& out) {
  Packet& packet = *pipe.flying;
  const auto to = live.addressOf(pipe.device);
  if (!to) return stall(now, live, pipe, Stall::Gone, out);
  packet.to = *to;
  packet.sent = now;
  packet.isOnBus = false;
  pipe.deadline = now + kAckTimeout;
  pipe.status.progress = Progress::Sending;
  Encoded data{.length = static_cast<std::uint8_t>(1 + packet.bytes.size())};
  data.data[0] = kType;
  std::ranges::transform(packet.bytes, data.data.begin() + 1,
                         [](char c) { return static_cast<std::uint8_t>(c); });
  packet.tag = out.send(live, source(), MessageId::PipeData, *to, data);
}

void PipeService::acknowledged(Instant now, const Live& live, Pipe& pipe, Outgoing& out) {
  PipeStatus& status = pipe.status;
  const Duration took = std::max<Duration>(now - pipe.flying->sent, 0ns);
  ++status.acks;
  status.ackLast = took;
  status.ackWorst = std::max(status.ackWorst, took);
  status.ackSum += took;
  if (status.progress == Progress::Stalled) {
    ++status.lateAcks;
    note(live, pipe.device, pipe.flying->to, PipeEvent::AckLate, {}, out);
    release(now, pipe);
  }
  const bool wasResent = pipe.flying->wasResent;
  passed(now, live, pipe, out);
  if (wasResent) return settle(now, pipe);
  sendNext(now, live, pipe, out);
}

// An ack may still come that is not the next packet's.
void PipeService::settle(Instant now, Pipe& pipe) {
  pipe.status.progress = Progress::Settling;
  pipe.deadline = now + kSettle;
}

// The packet in flight counts as delivered.
void PipeService::passed(Instant now, const Live& live, Pipe& pipe, Outgoing& out) {
  const Packet packet = std::move(*pipe.flying);
  pipe.flying.reset();
  pipe.deadline = kNever;
  pipe.status.sent += packet.bytes.size();
  if (!packet.isOfFile || !pipe.status.isSendingFile()) return;
  pipe.status.fileSent += packet.bytes.size();
  if (pipe.status.fileSent >= pipe.status.fileSize) endFile(now, live, pipe, FileEnd::Done, out);
}

void PipeService::endFile(Instant now, const Live& live, Pipe& pipe, FileEnd how, Outgoing& out) {
  if (!pipe.status.isSendingFile()) return;
  // Still stalled: what is in flight is no part of the file, and the doubt about it stays.
  if (pipe.status.progress != Progress::Stalled || !pipe.flying) release(now, pipe);
  pipe.status.isPaused = false;
  pipe.status.fileEnd = how;
  pipe.status.fileEnded = now;
  pipe.content.reset();
  const PipeEvent event = how == FileEnd::Done        ? PipeEvent::FileDone
                          : how == FileEnd::Cancelled ? PipeEvent::FileCancelled
                                                      : PipeEvent::FileAborted;
  note(live, pipe.device, live.addressOf(pipe.device).value_or(kNullAddress), event, pipe.status.file, out);
}

// Paused and stalled time is no time that the file took.
void PipeService::hold(Instant now, Pipe& pipe, Progress progress) {
  pipe.status.progress = progress;
  if (pipe.pausedSince == kNotYet) pipe.pausedSince = now;
}

void PipeService::release(Instant now, Pipe& pipe) {
  if (pipe.pausedSince != kNotYet && pipe.status.isSendingFile())
    pipe.status.filePaused += now - pipe.pausedSince;
  pipe.pausedSince = kNotYet;
  pipe.status.stall = Stall::None;
  if (pipe.status.progress != Progress::Settling)
    pipe.status.progress = pipe.flying ? Progress::Sending : Progress::Idle;
}

void PipeService::stall(Instant now, const Live& live, Pipe& pipe, Stall why, Outgoing& out) {
  pipe.deadline = kNever;
  pipe.status.stall = why;
  hold(now, pipe, Progress::Stalled);
  note(live, pipe.device, pipe.flying->to, PipeEvent::Stalled, {}, out);
}

PipeStatus::Stall PipeService::whyNoAck(const Live& live, const Pipe& pipe) {
  const auto address = live.addressOf(pipe.device);
  if (!address) return Stall::Gone;
  if (!pipe.flying->isOnBus) return pipe.status.stall == Stall::NotTaken ? Stall::NotTaken : Stall::NotOnBus;
  return *address != pipe.flying->to ? Stall::Moved : Stall::NoAck;
}

Refusal PipeService::act(Instant now, const Live& live, const wish::PipeAction& wish, Outgoing& out) {
  Pipe* at = find(live.canonical(wish.device));
  if (at == nullptr) return Refusal::NoDevice;
  const bool isStalled = at->status.progress == Progress::Stalled;
  switch (wish.what) {
    case What::Pause: at->status.isPaused = true; break;
    case What::Resume:
      at->status.isPaused = false;
      if (at->status.progress == Progress::Paused) release(now, *at);
      break;
    case What::Cancel: cancelFile(now, live, *at, out); break;
    case What::Resend:
      if (!isStalled || at->status.stall == Stall::NotOnBus) return Refusal::Busy;
      release(now, *at);
      ++at->status.resent;
      if (at->flying->isOfFile) ++at->status.fileResent;
      at->flying->wasResent = true;
      note(live, at->device, at->flying->to, PipeEvent::Resent, {}, out);
      fly(now, live, *at, out);
      return Refusal::None;
    case What::Skip:
      if (!isStalled) return Refusal::Busy;
      release(now, *at);
      ++at->status.skipped;
      if (at->flying->isOfFile) ++at->status.fileSkipped;
      note(live, at->device, at->flying->to, PipeEvent::Skipped, {}, out);
      passed(now, live, *at, out);
      settle(now, *at);
      return Refusal::None;
    case What::Abort: drop(now, live, *at, out); return Refusal::None;
  }
  sendNext(now, live, *at, out);
  return Refusal::None;
}

// A packet whose ack is in doubt goes with its file.
void PipeService::cancelFile(Instant now, const Live& live, Pipe& pipe, Outgoing& out) {
  const bool isInDoubt = pipe.status.progress == Progress::Stalled && pipe.flying && pipe.flying->isOfFile;
  if (isInDoubt) pipe.flying.reset();
  endFile(now, live, pipe, FileEnd::Cancelled, out);
  if (isInDoubt) settle(now, pipe);
}

// Nothing more of all that waits; what is in flight may or may not arrive.
void PipeService::drop(Instant now, const Live& live, Pipe& pipe, Outgoing& out) {
  const bool wasFlying = pipe.flying.has_value();
  const bool had = wasFlying || pipe.waiting() > 0;
  pipe.flying.reset();
  if (pipe.status.progress != Progress::Settling) pipe.deadline = kNever;
  pipe.status.isPaused = false;
  pipe.typed.clear();
  pipe.typedFrom = 0;
  pipe.status.waiting = 0;
  if (pipe.status.isSendingFile()) {
    endFile(now, live, pipe, FileEnd::Aborted, out);
  } else if (had) {
    note(live, pipe.device, live.addressOf(pipe.device).value_or(kNullAddress), PipeEvent::Dropped, {}, out);
  }
  release(now, pipe);
  if (wasFlying) settle(now, pipe);
}

void PipeService::dropAll(Instant now, const Live& live, Outgoing& out) {
  for (Pipe& pipe : m_pipes) drop(now, live, pipe, out);
}

void PipeService::received(Instant now, const Live& live, const Frame& frame, Outgoing& out) {
  // While a person decides, the device may go, or come back elsewhere.
  for (Pipe& pipe : m_pipes) {
    if (pipe.status.progress == Progress::Stalled && pipe.flying) pipe.status.stall = whyNoAck(live, pipe);
  }
  if (!frame.isExtended() || frame.isRemote() || frame.isError() || frame.length == 0 ||
      (frame.flags & Frame::kSent) != 0)
    return;
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn != pgn::kProprietaryA || frame.data[0] != kType || source() == kNullAddress) return;
  adopt(now, live, out);
  if (id.destination != source() || !live.bus().roles.isAkron(id.source)) return;
  const DeviceKey device = live.canonical(DeviceKey::at(live.channel, id.source));
  if (frame.length > 1) return dataHeard(live, device, id.source, frame, out);
  Pipe* at = find(device);
  if (at == nullptr) return;
  const bool isAck = at->flying && at->flying->to == id.source && at->flying->isOnBus;
  if (isAck) {
    acknowledged(now, live, *at, out);
  } else {
    ++at->status.strayAcks;
  }
}

void PipeService::writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome,
                             Outgoing& out) {
  for (Pipe& pipe : m_pipes) {
    if (!pipe.flying || pipe.flying->tag != tag) continue;
    switch (outcome) {
      case WriteOutcome::OnBus:
      case WriteOutcome::CannotTell:
        pipe.flying->isOnBus = true;
        pipe.flying->sent = now;
        pipe.deadline = now + kAckTimeout;
        if (pipe.status.progress == Progress::Stalled) release(now, pipe);
        break;
      case WriteOutcome::QueueFull:
      case WriteOutcome::NotTaken: stall(now, live, pipe, Stall::NotTaken, out); break;
      case WriteOutcome::Gone: break;  // a lost link ends the pipe
    }
  }
}

void PipeService::dataHeard(const Live& live, const DeviceKey& device, Address from, const Frame& frame,
                            Outgoing& out) {
  pipe(device).status.received += frame.length - 1u;
  Encoded ack{.length = 1};
  ack.data[0] = kType;
  out.send(live, source(), MessageId::PipeAck, from, ack, true);
}

void PipeService::adopt(Instant now, const Live& live, Outgoing& out) {
  for (std::size_t i = 0; i < m_pipes.size(); ++i) {
    if (m_pipes[i].device.kind != DeviceKey::Kind::Address) continue;
    const DeviceKey key = live.canonical(m_pipes[i].device);
    if (key == m_pipes[i].device) continue;
    if (Pipe* known = find(key)) {
      join(now, live, m_pipes[i], *known, out);
      m_pipes.erase(m_pipes.begin() + static_cast<std::ptrdiff_t>(i--));
    } else {
      m_pipes[i].device = key;
    }
  }
}

// Where both are under way nobody could tell whose the next ack is.
void PipeService::join(Instant now, const Live& live, Pipe& from, Pipe& into, Outgoing& out) {
  if (from.isBusy() && into.isBusy()) {
    drop(now, live, from, out);
    drop(now, live, into, out);
    settle(now, into);
  } else if (from.isBusy()) {
    std::swap(from, into);
    std::swap(from.device, into.device);
  }
  PipeStatus& sum = into.status;
  const PipeStatus& more = from.status;
  sum.sent += more.sent;
  sum.received += more.received;
  sum.skipped += more.skipped;
  sum.resent += more.resent;
  sum.lateAcks += more.lateAcks;
  sum.strayAcks += more.strayAcks;
  sum.acks += more.acks;
  sum.ackSum += more.ackSum;
  sum.ackWorst = std::max(sum.ackWorst, more.ackWorst);
}

Instant PipeService::nextTime() const {
  Instant next = kNever;
  if (source() == kNullAddress) return next;
  for (const Pipe& pipe : m_pipes) next = std::min(next, pipe.deadline);
  return next;
}

void PipeService::timeCame(Instant now, const Live& live, Outgoing& out) {
  if (source() == kNullAddress) return;
  adopt(now, live, out);
  for (Pipe& pipe : m_pipes) {
    if (pipe.deadline > now) continue;
    pipe.deadline = kNever;
    if (pipe.status.progress == Progress::Settling) {
      pipe.status.progress = Progress::Idle;
      sendNext(now, live, pipe, out);
    } else if (pipe.flying) {
      stall(now, live, pipe, whyNoAck(live, pipe), out);
    }
  }
}

}  // namespace deckpipe
