// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/pipe_service.h"

#include <algorithm>

#include "bus/j1939.h"
#include "protocol/lists.h"
#include "service/request_rules.h"

namespace deckpipe {

Pipe* PipeService::find(const DeviceKey& device) {
  const auto found = std::ranges::find(m_pipes, device, &Pipe::device);
  return found == m_pipes.end() ? nullptr : &*found;
}

Pipe& PipeService::pipe(const DeviceKey& device) {
  Pipe* known = find(device);
  return known != nullptr ? *known : m_pipes.emplace_back(device);
}

void PipeService::linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) {
  if (!isOpen) return end(now, live, EndReason::Closing, out);
  // Another device may be at an address by now.
  std::erase_if(m_pipes, [](const Pipe& pipe) { return pipe.device().kind == DeviceKey::Kind::Address; });
}

void PipeService::end(Instant now, const Live& live, EndReason, Outgoing& out) {
  for (Pipe& pipe : m_pipes) pipe.drop({now, live, source(), out});
}

void PipeService::status(const Live& live, ServiceStatus& into) const {
  for (const Pipe& pipe : m_pipes) statusOf(live, pipe.device(), into).pipe = pipe.status();
}

std::optional<Refusal> PipeService::intentCame(Instant now, const Live& live, const Intent& intent,
                                               Outgoing& out) {
  const Pipe::Turn turn{now, live, source(), out};
  const auto* write = std::get_if<intent::PipeWrite>(&intent);
  const auto* file = std::get_if<intent::PipeFile>(&intent);
  const auto* action = std::get_if<intent::PipeAction>(&intent);
  if (write == nullptr && file == nullptr && action == nullptr) return {};
  if (source() == kNullAddress) return Refusal::NoAddress;
  adopt(turn);
  if (action != nullptr) {
    Pipe* at = find(live.canonical(action->device));
    return at != nullptr ? at->act(turn, *action) : Refusal::NoDevice;
  }
  if (m_own.isDisputed()) return Refusal::Disputed;
  const DeviceKey& to = write != nullptr ? write->device : file->device;
  if (const Refusal why = live.whyNoPacketTo(now, to); why != Refusal::None) return why;
  Pipe& at = pipe(live.canonical(to));
  return write != nullptr ? at.write(turn, write->bytes) : at.sendFile(turn, *file);
}

void PipeService::received(Instant now, const Live& live, const Frame& frame, Outgoing& out) {
  for (Pipe& pipe : m_pipes) pipe.followDevice({now, live, source(), out});
  if (!frame.isExtended() || frame.isRemote() || frame.isError() || frame.length == 0 ||
      (frame.flags & Frame::kSent) != 0)
    return;
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn != pgn::kProprietaryA || !hasTypeOf(frame, MessageId::PipeData) || source() == kNullAddress)
    return;
  const Pipe::Turn turn{now, live, source(), out};
  adopt(turn);
  if (id.destination != source() || !live.bus().book.isAkron(id.source)) return;
  const DeviceKey device = live.canonical(DeviceKey::at(live.channel, id.source));
  if (frame.length > 1) {
    pipe(device).dataHeard(frame.length - 1u);
    Encoded ack{.length = 1};
    ack.data[0] = typeOf(MessageId::PipeAck);
    out.send(live, source(), MessageId::PipeAck, id.source, ack, true);
  } else if (Pipe* at = find(device); at != nullptr && !m_own.isDisputed()) {
    // An ack to a disputed address may be the other node's.
    at->ackHeard(turn, id.source);
  }
}

void PipeService::writeEnded(Instant now, const Live& live, FrameTag tag, WriteOutcome outcome,
                             Outgoing& out) {
  for (Pipe& pipe : m_pipes) pipe.writeEnded({now, live, source(), out}, tag, outcome);
}

void PipeService::adopt(const Pipe::Turn& turn) {
  for (std::size_t i = 0; i < m_pipes.size(); ++i) {
    if (m_pipes[i].device().kind != DeviceKey::Kind::Address) continue;
    const DeviceKey key = turn.live.canonical(m_pipes[i].device());
    if (key == m_pipes[i].device()) continue;
    if (Pipe* known = find(key)) {
      known->take(turn, std::move(m_pipes[i]));
      m_pipes.erase(m_pipes.begin() + static_cast<std::ptrdiff_t>(i--));
    } else {
      m_pipes[i].rename(key);
    }
  }
}

Instant PipeService::nextTime() const {
  Instant next = kNever;
  if (source() == kNullAddress) return next;
  for (const Pipe& pipe : m_pipes) next = std::min(next, pipe.deadline());
  return next;
}

void PipeService::timeCame(Instant now, const Live& live, Outgoing& out) {
  if (source() == kNullAddress) return;
  const Pipe::Turn turn{now, live, source(), out};
  adopt(turn);
  for (Pipe& pipe : m_pipes) pipe.timeCame(turn);
}

}  // namespace deckpipe
