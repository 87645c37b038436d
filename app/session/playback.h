// SPDX-License-Identifier: GPL-3.0-or-later
// Playback says where the cursor of a log stands, and moves it: by hand, with the log's end, or by playing. It reads
// no clock: the session passes the time in, of a clock that never falls.
#pragma once

#include "base/time.h"
#include "state/advance.h"

namespace deckpipe {

class Playback {
 public:
  static constexpr double kSlowest = 0.25, kFastest = 16;

  // Stands at the log's end and goes with it. Null: no log is open, and nothing but setSpeed() has an effect.
  explicit Playback(const FrameStore* frames = nullptr) : m_frames(frames) {}

  // Sets the log's end. `grows`: the end moves with time, also without frames.
  void reach(Cursor end, bool grows);
  // Moves the cursor that plays; at the log's end it stops playing and goes with the end.
  void timeCame(Instant now);

  // Plays from the cursor. At the end it starts over, or does nothing if the log grows. Returns whether it plays now
  // and did not before.
  bool play(Instant now);
  // Stops playing, and going with the log's end. Returns false if the cursor stood already.
  bool pause();
  // To a time, to behind so many frames, by so many frames. All stop at the log's ends, and stop playing.
  void seek(Instant time);
  void seekFrames(std::uint64_t frames);
  void step(int frames);
  // To the end, and from then on with it.
  void goToEnd();
  // Times real time, kSlowest … kFastest.
  void setSpeed(double speed);

  Cursor cursor() const { return m_cursor; }
  Instant begin() const { return m_begin; }
  Cursor end() const { return m_end; }
  bool isAtEnd() const { return m_isAtEnd; }
  bool isPlaying() const { return m_isPlaying; }
  double speed() const { return m_speed; }

 private:
  void stand(Cursor cursor);

  const FrameStore* m_frames;
  Instant m_begin;
  Cursor m_end;
  Cursor m_cursor;
  bool m_grows = false;
  bool m_isAtEnd = true;
  bool m_isPlaying = false;
  double m_speed = 1;
  Instant m_movedAt;  // when playing last moved the cursor
};

}  // namespace deckpipe
