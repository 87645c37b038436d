// SPDX-License-Identifier: GPL-3.0-or-later
// Walks a state through a log as advance() does, and finds on the way what changed and when: the events of
// base/event_kind.h. A silence or a time-out is told at the time at which it falls due, frame or no frame.
//
//   1. The events of a log are the same however often, and at which cursors, a walk through it stops.
//   2. They come in the order of their times.
//   3. The first value heard of anything is no change, but for faults, errors, and what keeps a device from moving.
//      Whoever is heard within kSettling of its channel's first frame was there before the log began. Behind a gap of
//      the link its PIN tells: one that was not known before has appeared, another one may have moved. What repeated
//      something before the gap and is not heard behind it is told as not back.
//   4. What changes faster than a person reads is told at the pace of EventSlot.
//   5. Of a log that was saved through a filter nothing is told that rests on a silence (EventBasis).
//
// A frame costs a comparison with what its device said before; no state is compared with another one.
#pragma once

#include <memory>
#include <vector>

#include "log/frame_store.h"
#include "log/note_store.h"
#include "state/bus_watch.h"
#include "state/device_watch.h"

namespace deckpipe {

class EventWalk {
 public:
  EventWalk();

  // From where the walk is to `to`, which must not lie before it. New events are appended to `out`.
  void advance(const FrameStore& frames, const NoteStore& notes, Cursor to, std::vector<Event>& out);
  // The same as that of a state that was advanced to the same cursor.
  const State& state() const { return *m_state; }

  // What the walk through a store calls (state/advance.h).
  const Cursor& cursor() const { return m_state->cursor(); }
  void timesAre(TimeGrain grain) { m_state->timesAre(grain); }
  void apply(const Frame& frame, Instant time);
  void apply(const Note& note);
  void timeCame(Instant time);

 private:
  // Goes through what falls due up to `time`, each at its own time.
  void catchUp(Instant time);
  void plan();
  void lookExtended(const Frame& frame, BusWatch& bus);
  void lookStandard(const Frame& frame, BusWatch& bus);
  void dropSilences(std::size_t since);
  void look(const Device& device, MessageId id, const Payload& data, BusWatch& bus);
  void lookAtIdentities(Channel channel, BusWatch& bus);
  std::size_t placeOf(const Device& device) const;

  std::unique_ptr<State> m_state;
  std::vector<DeviceWatch> m_devices;  // by place in Devices
  std::size_t m_used = 0;              // no device was ever seen behind these
  std::vector<BusWatch> m_buses;       // by channel
  std::vector<NodeWatch> m_nodes;      // by channel
  Instant m_due = kNever;              // nothing falls due before then
  std::vector<Event> m_found;
};

}  // namespace deckpipe
