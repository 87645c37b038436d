// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/keyframes.h"

#include <algorithm>

namespace deckpipe {

std::shared_ptr<const State> Keyframes::nearest(Cursor cursor) const {
  const std::lock_guard lock(m_lock);
  std::size_t i = std::min<std::uint64_t>(cursor.frames / kEvery, m_states.size());
  // A cursor may stand at an earlier time than its last frame only by mistake; never walk backwards.
  while (i > 0 && m_states[i - 1]->cursor().time > cursor.time) --i;
  return i == 0 ? nullptr : m_states[i - 1];
}

State Keyframes::at(Cursor cursor) const {
  const auto from = nearest(cursor);
  State state = from ? *from : State();
  advance(state, m_frames, m_notes, cursor);
  return state;
}

bool Keyframes::build() {
  const std::uint64_t target = (count() + 1) * kEvery;
  if (m_frames.count() < target) return false;
  auto state = std::make_shared<const State>(at(cursorAfter(m_frames, target)));
  const std::lock_guard lock(m_lock);
  if ((m_states.size() + 1) * kEvery == target) m_states.push_back(std::move(state));
  return true;
}

void Keyframes::offer(const State& state) {
  if (state.cursor().frames != (count() + 1) * kEvery) return;
  auto copy = std::make_shared<const State>(state);
  const std::lock_guard lock(m_lock);
  if ((m_states.size() + 1) * kEvery == copy->cursor().frames) m_states.push_back(std::move(copy));
}

void Keyframes::invalidateAfter(std::uint64_t frame) {
  const std::lock_guard lock(m_lock);
  m_states.resize(std::min<std::uint64_t>(m_states.size(), frame / kEvery));
}

std::size_t Keyframes::count() const {
  const std::lock_guard lock(m_lock);
  return m_states.size();
}

}  // namespace deckpipe
