// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/file_clock.h"

#include <algorithm>

namespace deckpipe {
namespace {

bool isNear(std::int64_t stamp, std::int64_t before) {
  const std::int64_t step = saturatedMinus(stamp, before);
  return step >= -FileClock::kBack.count() && step <= FileClock::kForward.count();
}

}  // namespace

FileClock::Verdict FileClock::next(std::span<const Frame> frames, Follows follows, std::int64_t now) {
  const Frame& frame = frames.front();
  if (!frame.hasStamp()) return {.kind = Kind::Timeless};
  Channel& channel = m_channels[frame.channel];
  if (channel.isKnown) {
    if (!isNear(frame.stamp, channel.lastStamp)) return step(channel, frames, follows, now);
    channel.lastStamp = frame.stamp;
    return {.time = saturatedPlus(frame.stamp, channel.offset), .offset = channel.offset};
  }
  channel.isKnown = true;
  channel.lastStamp = frame.stamp;
  const std::int64_t away = saturatedMinus(frame.stamp, now);
  const bool isFar = m_isStamped && (away > kForward.count() || away < -kForward.count());
  m_isStamped = true;
  if (!isFar) return {.time = frame.stamp};
  channel.offset = saturatedMinus(now, frame.stamp);
  return {.kind = Kind::NewOffset, .time = now, .offset = channel.offset};
}

FileClock::Verdict FileClock::step(Channel& channel, std::span<const Frame> frames, Follows follows,
                                   std::int64_t now) {
  const Frame& frame = frames.front();
  const auto after = frames.subspan(1, std::min(kLookAhead, frames.size() - 1));
  const auto next = std::ranges::find_if(
      after, [&](const Frame& other) { return other.channel == frame.channel && other.hasStamp(); });
  if (next == after.end() && after.size() < kLookAhead && follows == Follows::More)
    return {.kind = Kind::Undecided};
  if (next != after.end() && isNear(next->stamp, channel.lastStamp))
    return {.kind = Kind::Timeless, .isStep = true, .offset = channel.offset};

  const bool isBack = frame.stamp < channel.lastStamp;
  const Piece left{channel.offset, channel.lastStamp, now};
  channel.lastStamp = frame.stamp;
  if (isBack) {
    if (channel.earlier.size() == kMaxPieces) channel.earlier.erase(channel.earlier.begin());
    channel.earlier.push_back(left);
    channel.offset = saturatedMinus(now, frame.stamp);
    return {.kind = Kind::NewOffset, .isStep = true, .time = now, .offset = channel.offset};
  }
  const auto isMet = [&](const Piece& piece) {
    const std::int64_t past = saturatedMinus(frame.stamp, piece.lastStamp);
    return past >= -kReturn.count() &&
           past <= saturatedPlus(saturatedMinus(now, piece.ended), kReturn.count());
  };
  const auto met = std::ranges::find_if(channel.earlier, isMet);
  if (met == channel.earlier.end())
    return {.isStep = true, .time = saturatedPlus(frame.stamp, channel.offset), .offset = channel.offset};
  channel.offset = met->offset;
  channel.earlier.erase(met);
  return {.kind = Kind::NewOffset,
          .isStep = true,
          .time = std::max(now, saturatedPlus(frame.stamp, channel.offset)),
          .offset = channel.offset};
}

}  // namespace deckpipe
