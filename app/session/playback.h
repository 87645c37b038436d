// SPDX-License-Identifier: GPL-3.0-or-later
// Playback says where the cursor of a log stands, and moves it: by hand, with the log's end, or by playing. It reads
// no clock: the session passes the time in, of a clock that never falls.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "base/time.h"
#include "state/advance.h"

namespace deckpipe {

// A part of a log, in log time. The frames at its end are no part of it.
struct LoopSpan {
  Instant begin, end;
  friend bool operator==(const LoopSpan&, const LoopSpan&) = default;
};

class Playback {
 public:
  enum class Start : std::uint8_t {
    AtEnd,    // it goes with the end
    AtBegin,  // behind the first frame, once there is one
  };
  static constexpr double kSlowest = 0.1, kFastest = 100;
  // As fast as the state is found: the next frames are played once the state of those before is there.
  static constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  // Frames that an unbounded speed takes at a time: few at first, more while the state keeps up.
  static constexpr std::uint64_t kShortestStride = 1'024, kLongestStride = 131'072;
  // A longer time without a frame is skipped, if silences are.
  static constexpr Duration kSilence = 3s;
  // So long of playing it is told that a silence was skipped.
  static constexpr Duration kTellsSkipped = 3s;

  // Null: no log is open, and nothing but setSpeed() and setSkipsSilences() has an effect.
  explicit Playback(const FrameStore* frames = nullptr, Start start = Start::AtEnd)
      : m_frames(frames), m_isAtEnd(start == Start::AtEnd), m_awaitsFirst(start == Start::AtBegin) {}

  // Another log, or none. The speed, and whether silences are skipped, stay as they are.
  void open(const FrameStore* frames, Start start = Start::AtEnd);
  // Sets the log's end. `grows`: the end moves with time, also without frames.
  void reach(Cursor end, bool grows);
  // Moves the cursor that plays; at the log's end it stops playing and goes with the end. `found`: where the state
  // stands that was found last.
  void timeCame(Instant now, Cursor found);

  // Plays from the cursor, or from the begin of the loop where the cursor is outside of it. At the end it starts
  // over, or does nothing if the log grows. Returns whether it plays now and did not before.
  bool play(Instant now);
  // Stops playing, and going with the log's end. Returns false if the cursor stood already.
  bool pause();
  // To a time, to behind so many frames, by so many frames. All stop at the log's ends, and stop playing.
  void seek(Instant time);
  void seekFrames(std::uint64_t frames);
  void step(int frames);
  // To the end, and from then on with it.
  void goToEnd();
  // Times real time, kSlowest … kFastest, or kUnbounded. A log without times is always played unbounded.
  void setSpeed(double speed);
  // What is played again and again from now on; nothing, or a span without length: the log, once.
  void setLoop(std::optional<LoopSpan> span);
  void setSkipsSilences(bool skips) { m_skipsSilences = skips; }

  Cursor cursor() const { return m_cursor; }
  Instant begin() const { return m_begin; }
  Cursor end() const { return m_end; }
  bool isAtEnd() const { return m_isAtEnd; }
  bool isPlaying() const { return m_isPlaying; }
  double speed() const { return m_speed; }
  const std::optional<LoopSpan>& loop() const { return m_loop; }
  bool skipsSilences() const { return m_skipsSilences; }
  // The log time that was skipped last, while that is told; otherwise 0.
  Duration skipped() const { return m_skipped; }

 private:
  void stand(Cursor cursor);
  void playFrames(Cursor found);
  void skipSilence(Instant now);
  // The log has something of the loop.
  bool isLooping() const { return m_loop && m_loop->begin < m_end.time; }
  // The time at which playing ends.
  Instant playedEnd() const { return isLooping() ? std::min(m_loop->end, m_end.time) : m_end.time; }

  const FrameStore* m_frames;
  Instant m_begin;
  Cursor m_end;
  Cursor m_cursor;
  bool m_grows = false;
  bool m_isAtEnd;
  bool m_awaitsFirst;
  bool m_isPlaying = false;
  double m_speed = 1;
  Instant m_movedAt;  // when playing last moved the cursor
  std::optional<LoopSpan> m_loop;
  bool m_skipsSilences = false;
  Duration m_skipped{0};
  Instant m_skippedAt;
  std::uint64_t m_stride = kShortestStride;
  int m_waited = 0;  // calls since the cursor moved for which its state was not there
};

}  // namespace deckpipe
