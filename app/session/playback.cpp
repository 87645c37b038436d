// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/playback.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace deckpipe {

void Playback::reach(Cursor end, bool grows) {
  m_end = end;
  m_grows = grows;
  m_begin = m_frames == nullptr || end.frames == 0 ? end.time : m_frames->timeAt(0);
  if (m_isAtEnd) m_cursor = end;
}

void Playback::timeCame(Instant now) {
  if (!m_isPlaying) return;
  const auto real = static_cast<double>((now - std::exchange(m_movedAt, now)).count());
  const Instant target = m_cursor.time + Duration{static_cast<std::int64_t>(real * m_speed)};
  if (target >= m_end.time) return goToEnd();
  m_cursor = cursorAt(*m_frames, target);
}

bool Playback::play(Instant now) {
  if (m_frames == nullptr || m_isPlaying || (m_isAtEnd && m_grows)) return false;
  if (m_cursor.frames >= m_end.frames && !m_grows) m_cursor = {0, m_begin};
  m_isAtEnd = false;
  m_isPlaying = true;
  m_movedAt = now;
  return true;
}

bool Playback::pause() {
  if (m_frames == nullptr || (!m_isPlaying && !m_isAtEnd)) return false;
  stand(m_cursor);
  return true;
}

void Playback::seek(Instant time) {
  if (m_frames == nullptr) return;
  stand(cursorAt(*m_frames, std::clamp(time, m_begin, std::max(m_begin, m_end.time))));
}

void Playback::seekFrames(std::uint64_t frames) {
  if (m_frames == nullptr) return;
  stand(cursorAfter(*m_frames, std::min(frames, m_frames->count())));
}

void Playback::step(int frames) {
  const std::uint64_t here = m_cursor.frames;
  const auto by = static_cast<std::uint64_t>(std::abs(std::int64_t{frames}));
  seekFrames(frames < 0 ? here - std::min(here, by) : here + by);
}

void Playback::goToEnd() {
  m_isPlaying = false;
  m_isAtEnd = true;
  m_cursor = m_end;
}

void Playback::setSpeed(double speed) { m_speed = std::clamp(speed, kSlowest, kFastest); }

void Playback::stand(Cursor cursor) {
  m_isPlaying = false;
  m_isAtEnd = false;
  m_cursor = cursor;
}

}  // namespace deckpipe
