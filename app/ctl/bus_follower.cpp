// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus_follower.h"

#include <algorithm>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "link/can_link.h"
#include "protocol/catalogue.h"
#include "session/clocks.h"

namespace deckpipe::ctl {

void BusFollower::passUntil(Instant time) {
  for (Instant at = due(); at <= time && at != kNever; at = std::max(due(), at + Duration(1))) {
    m_state.timeCame(at);
    onChange();
  }
  m_state.timeCame(time);
}

void BusFollower::follow(const LogView& view) {
  if (view.document == nullptr) return;
  const FrameStore& frames = view.document->frames;
  const std::uint64_t end = view.cursor.frames;
  const std::vector<Note> notes = view.document->notes.between(m_next, end + 1);
  std::size_t next = m_notesTaken;
  LogTimes times(frames);
  const auto takeNotes = [&] {
    for (; next < notes.size() && notes[next].frame <= m_next; ++next) {
      m_state.apply(notes[next]);
      ++m_notesTaken;
      if (const auto* down = std::get_if<note::LinkDown>(&notes[next].value)) {
        ++m_linkDowns;
        m_linkDownReason = {.fault = down->fault, .detail = std::string(down->words.str())};
      }
      onNote(notes[next]);
      onChange();
    }
  };
  for (takeNotes(); m_next < end; takeNotes()) {
    const Frame& frame = frames[m_next];
    const Instant time = times.at(m_next);
    passUntil(time);
    const Classified what = frame.channel < kMaxChannels
                                ? classify(frame, time, m_state.channel({frame.channel}).book)
                                : Classified{};
    m_state.apply(frame, time);
    ++m_next;
    m_notesTaken = 0;
    onFrame(frame, what);
    onChange();
  }
  passUntil(view.cursor.time);
  onChange();
}

const Device* BusFollower::deviceOf(const Frame& frame, const Classified& what) const {
  const Channel channel{frame.channel};
  if (what.message == MessageId::Count || frame.isError()) return nullptr;
  if (!frame.isExtended()) {
    const CobId id = CobId::of(frame.identifier());
    return id.hasNode() ? m_state.devices().byNode(channel, id.node) : nullptr;
  }
  const J1939Id id = J1939Id::of(frame.identifier());
  const bool isSender = messageOf(what.message).device == DeviceEnd::Sender;
  return m_state.devices().byAddress(channel, isSender ? id.source : id.destination);
}

std::int64_t wallTime(Instant logTime) { return CanLink::systemClock() - (bootTime() - logTime).count(); }

}  // namespace deckpipe::ctl
