// SPDX-License-Identifier: GPL-3.0-or-later
// What comes on a live link, one by one and in order, with the state after each. Snapshots come 30 times a
// second and show only how things are; a line for every answer needs every frame. The subcommands on a live
// interface each have one and call follow() on every tick.
#pragma once

#include <functional>

#include "link/link_status.h"
#include "protocol/classify.h"
#include "state/log_view.h"

namespace deckpipe::ctl {

class BusFollower {
 public:
  // State and roles know the frame already, `what` it is was decided before.
  std::function<void(const Frame&, const Classified& what)> onFrame = [](auto&&...) {};
  std::function<void(const Note&)> onNote = [](auto&&...) {};
  // After each of these, and when time has passed.
  std::function<void()> onChange = [] {};
  // When time that passes has to be seen at the latest if nothing comes.
  std::function<Instant()> due = [] { return kNever; };

  // Up to the cursor of the view, which is the live edge.
  void follow(const LogView& view);
  const State& state() const { return m_state; }
  // The times that the link went down, and why it did last. Short gaps count too.
  unsigned linkDowns() const { return m_linkDowns; }
  const LinkError& linkDownReason() const { return m_linkDownReason; }
  // The device that a frame of PGN EF00 or a CANopen node's is from or for, as `what` says; null if none.
  const Device* deviceOf(const Frame& frame, const Classified& what) const;

 private:
  void passUntil(Instant time);

  State m_state;
  std::uint64_t m_next = 0;      // frame
  std::size_t m_notesTaken = 0;  // of those that stand before it
  unsigned m_linkDowns = 0;
  LinkError m_linkDownReason;
};

// Nanoseconds since 1970 at a log time of a live link.
std::int64_t wallTime(Instant logTime);

}  // namespace deckpipe::ctl
