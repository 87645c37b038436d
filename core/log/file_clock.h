// SPDX-License-Identifier: GPL-3.0-or-later
// FileClock: what the stamps of a log file say about time. The stamps of each channel are one clock.
// FrameStore asks it for each frame of a file, in order, before the frame is published.
//
// 1. A step is judged against the last stamp of the same channel: back by more than kBack, or forward by more
//    than kForward. Smaller differences are no step, whichever way they go.
// 2. If the next stamp of the channel undoes the step, that one frame has no time of its own: it takes the time
//    of the frame before. A step forward that brings the clock back to no earlier piece has none either until
//    kConfirming further stamps confirm it: none of them undoes it, and the file does not end before.
// 3. A step back that holds begins a piece. Its time goes on from the frame before.
// 4. A step forward that holds is time that passed. But if it brings the clock back to an earlier piece of the
//    channel, within kReturn, the offset of that piece returns. An earlier piece is met where it stopped, or
//    where its clock would stand by now.
//    Nor is a step forward time if it is the channel's first and refutes its one stamp before, which no other channel
//    agrees with: then it begins a piece, too.
// 5. Each step is one mark.
// 6. A channel whose first stamp lies more than kForward from log time starts at the time of the frame before,
//    without a mark.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/time.h"
#include "bus/frame.h"

namespace deckpipe {

// Whether more frames of the file will follow the ones at hand.
enum class Follows : bool { Nothing, More };

class FileClock {
 public:
  static constexpr Duration kBack = 100ms;
  static constexpr Duration kForward = 1h;
  static constexpr Duration kReturn = 1s;
  // Number of frames after a step among which the next stamp of its channel is looked for.
  static constexpr std::size_t kLookAhead = 64;
  // Stamps of the channel that have to follow a step forward, none of them back at the time before it.
  static constexpr std::size_t kConfirming = 3;

  enum class Kind : std::uint8_t {
    Plain,      // the offset of the channel stays as it is
    NewOffset,  // `offset` holds from this frame on, and this frame is at `time`
    Timeless,   // the frame keeps the time of the frame before
    Undecided,  // the frames at hand do not tell yet; ask again with more
  };
  struct Verdict {
    Kind kind = Kind::Plain;
    bool isStep = false;
    std::int64_t time = 0;    // log time of the frame in ns, unless Timeless or Undecided
    std::int64_t offset = 0;  // log time minus stamp in ns
  };

  // `frames` begins with the frame in question. `now` is the log time in ns of the frame before.
  Verdict next(std::span<const Frame> frames, Follows follows, std::int64_t now);

 private:
  struct Piece {
    std::int64_t offset = 0;
    std::int64_t lastStamp = 0;
    std::int64_t ended = 0;  // log time of its last frame
  };
  struct Channel {
    bool isKnown = false;
    bool isLone = true;  // only one stamp came
    std::int64_t lastStamp = 0;
    std::int64_t offset = 0;
    std::vector<Piece> earlier;
  };
  // Pieces beyond this number are forgotten, the oldest first.
  static constexpr std::size_t kMaxPieces = 64;

  enum class Holds : std::uint8_t { Yes, No, Undecided };
  static Holds isHeld(std::int64_t lastStamp, std::span<const Frame> frames, Follows follows, bool isReturn);
  // Whether the last stamp of a channel is its only one, and no other channel agrees with it.
  bool isDoubtful(const Channel& channel) const;
  static const Piece* pieceMet(const Channel& channel, std::int64_t stamp, std::int64_t now);
  Verdict step(Channel& channel, std::span<const Frame> frames, Follows follows, std::int64_t now);

  std::array<Channel, 256> m_channels{};
  bool m_isStamped = false;  // some frame had a stamp
};

}  // namespace deckpipe
