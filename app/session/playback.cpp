// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/playback.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace deckpipe {

void Playback::open(const FrameStore* frames, Start start) {
  Playback next(frames, start);
  next.m_speed = m_speed;
  next.m_skipsSilences = m_skipsSilences;
  *this = next;
}

void Playback::reach(Cursor end, bool grows) {
  m_end = end;
  m_grows = grows;
  m_begin = m_frames == nullptr || end.frames == 0 ? end.time : m_frames->timeAt(0);
  if (m_isAtEnd) m_cursor = end;
  if (m_awaitsFirst && end.frames > 0) stand(cursorAfter(*m_frames, 1));
}

void Playback::timeCame(Instant now, Cursor found) {
  if (!m_isPlaying) return;
  const auto real = static_cast<double>((now - std::exchange(m_movedAt, now)).count());
  if (now - m_skippedAt >= kTellsSkipped) m_skipped = Duration{0};
  if (std::isinf(m_speed) || !m_frames->hasTimes()) return playFrames(found);
  Instant target = m_cursor.time + Duration{static_cast<std::int64_t>(real * m_speed)};
  if (target >= playedEnd()) {
    if (!isLooping()) return goToEnd();
    target = m_loop->begin + (target - m_loop->begin) % (playedEnd() - m_loop->begin);
  }
  m_cursor = cursorAt(*m_frames, target);
  if (m_skipsSilences) skipSilence(now);
}

// The state that is asked for is always a near one, and it is the last that was asked for: so the window sees each, and
// the walk decides how fast it goes.
void Playback::playFrames(Cursor found) {
  if (found != m_cursor) {
    ++m_waited;
    return;
  }
  const int waited = std::exchange(m_waited, 0);
  if (waited == 0) m_stride = std::min(2 * m_stride, kLongestStride);
  if (waited > 2) m_stride = std::max(m_stride / 2, kShortestStride);
  const std::uint64_t end = isLooping() ? m_frames->firstAtOrAfter(playedEnd()) : m_end.frames;
  if (m_cursor.frames < end && end - m_cursor.frames > m_stride) {
    m_cursor = cursorAfter(*m_frames, m_cursor.frames + m_stride);
  } else if (isLooping()) {
    m_cursor = cursorAt(*m_frames, m_loop->begin);
  } else {
    goToEnd();
  }
}

// A silence that one tick passes whole needs no skipping.
void Playback::skipSilence(Instant now) {
  const std::uint64_t next = m_cursor.frames;
  const bool isLast = next >= m_end.frames;
  if (isLast && m_grows) return;
  const Instant from = next == 0 ? m_begin : m_frames->timeAt(next - 1);
  const Instant to = isLast ? m_end.time : m_frames->timeAt(next);
  if (to - from <= kSilence || to <= m_cursor.time) return;
  const Duration skipped = to - m_cursor.time;
  if (to < playedEnd()) {
    m_cursor = cursorAt(*m_frames, to);
  } else if (isLooping()) {
    m_cursor = cursorAt(*m_frames, m_loop->begin);
  } else {
    return goToEnd();
  }
  m_skipped = skipped;
  m_skippedAt = now;
}

bool Playback::play(Instant now) {
  if (m_frames == nullptr || m_isPlaying || (m_isAtEnd && m_grows && !isLooping())) return false;
  if (isLooping() && (m_cursor.time < m_loop->begin || m_cursor.time >= playedEnd())) {
    m_cursor = cursorAt(*m_frames, m_loop->begin);
  } else if (m_cursor.frames >= m_end.frames && m_cursor.time >= m_end.time && !m_grows) {
    m_cursor = {0, m_begin};
  }
  m_isAtEnd = false;
  m_isPlaying = true;
  m_movedAt = now;
  m_stride = kShortestStride;
  m_waited = 0;
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
  stand(m_end);
  m_isAtEnd = true;
}

void Playback::setSpeed(double speed) {
  m_speed = speed == kUnbounded ? speed : std::clamp(speed, kSlowest, kFastest);
}

void Playback::setLoop(std::optional<LoopSpan> span) {
  if (m_frames == nullptr || (span && span->end <= span->begin)) span.reset();
  m_loop = span;
}

void Playback::stand(Cursor cursor) {
  m_isPlaying = false;
  m_isAtEnd = false;
  m_awaitsFirst = false;
  m_skipped = Duration{0};
  m_cursor = cursor;
}

}  // namespace deckpipe
