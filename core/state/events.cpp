// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/events.h"

#include <algorithm>

#include "state/advance.h"
#include "state/event_walk.h"
#include "state/keyframes.h"

namespace deckpipe {

Events::Events(const FrameStore& frames, const NoteStore& notes, Keyframes& keyframes)
    : m_frames(frames), m_notes(notes), m_keyframes(keyframes) {}

Events::~Events() = default;

bool Events::build(const Cursor& to) {
  if (m_walk == nullptr) m_walk = std::make_unique<EventWalk>();
  const Cursor from = m_walk->cursor();
  if (from.frames >= to.frames && from.time >= to.time) return false;
  const std::uint64_t stop = (from.frames / Keyframes::kEvery + 1) * Keyframes::kEvery;
  const bool isFarther = stop < to.frames;
  m_walk->advance(m_frames, m_notes, isFarther ? cursorAfter(m_frames, stop) : to, m_found);
  if (m_walk->cursor().frames == stop) m_keyframes.offer(m_walk->state());
  const std::lock_guard lock(m_lock);
  const std::size_t room = kMax - m_list.size();
  m_list.insert(m_list.end(), m_found.begin(),
                m_found.begin() + static_cast<std::ptrdiff_t>(std::min(room, m_found.size())));
  m_found.clear();
  return true;
}

void Events::restart() {
  m_walk.reset();
  m_found.clear();
  const std::lock_guard lock(m_lock);
  m_list.clear();
  ++m_generation;
}

unsigned Events::generation() const {
  const std::lock_guard lock(m_lock);
  return m_generation;
}

std::size_t Events::count() const {
  const std::lock_guard lock(m_lock);
  return m_list.size();
}

std::vector<Event> Events::after(std::size_t first) const {
  const std::lock_guard lock(m_lock);
  return {m_list.begin() + static_cast<std::ptrdiff_t>(std::min(first, m_list.size())), m_list.end()};
}

}  // namespace deckpipe
