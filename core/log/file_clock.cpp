// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/file_clock.h"

#include <algorithm>

namespace deckpipe {
namespace {

bool isNear(std::int64_t stamp, std::int64_t before) {
  const std::int64_t step = saturatedMinus(stamp, before);
  return step >= -FileClock::kBack.count() && step <= FileClock::kForward.count();
}

bool isFar(std::int64_t stamp, std::int64_t other) {
  const std::int64_t away = saturatedMinus(stamp, other);
  return away > FileClock::kForward.count() || away < -FileClock::kForward.count();
}

}  // namespace

FileClock::Verdict FileClock::next(std::span<const Frame> frames, Follows follows, std::int64_t now) {
  const Frame& frame = frames.front();
  if (!frame.hasStamp()) return {.kind = Kind::Timeless};
  Channel& channel = m_channels[frame.channel];
  if (channel.isKnown) {
    if (!isNear(frame.stamp, channel.lastStamp)) return step(channel, frames, follows, now);
    channel.lastStamp = frame.stamp;
    channel.isLone = false;
    return {.time = saturatedPlus(frame.stamp, channel.offset), .offset = channel.offset};
  }
  channel.isKnown = true;
  channel.lastStamp = frame.stamp;
  const bool isAway = m_isStamped && isFar(frame.stamp, now);
  m_isStamped = true;
  if (!isAway) return {.time = frame.stamp};
  channel.offset = saturatedMinus(now, frame.stamp);
  return {.kind = Kind::NewOffset, .time = now, .offset = channel.offset};
}

// A leap forward to a time that no earlier piece knows needs more than one stamp to be believed.
FileClock::Holds FileClock::isHeld(std::int64_t lastStamp, std::span<const Frame> frames, Follows follows,
                                   bool isReturn) {
  const Frame& frame = frames.front();
  const bool isLeap = frame.stamp > lastStamp && !isReturn;
  const auto after = frames.subspan(1, std::min(kLookAhead, frames.size() - 1));
  std::size_t confirming = 0;
  for (const Frame& other : after) {
    if (other.channel != frame.channel || !other.hasStamp()) continue;
    if (isNear(other.stamp, lastStamp)) return Holds::No;
    if (++confirming == kConfirming || !isLeap) return Holds::Yes;
  }
  if (after.size() == kLookAhead) return Holds::Yes;
  if (follows == Follows::More) return Holds::Undecided;
  return isLeap ? Holds::No : Holds::Yes;
}

bool FileClock::isDoubtful(const Channel& channel) const {
  if (!channel.isLone) return false;
  if (channel.offset != 0) return true;  // it was placed by the others
  const std::int64_t time = saturatedPlus(channel.lastStamp, channel.offset);
  return std::ranges::none_of(m_channels, [&](const Channel& other) {
    return other.isKnown && &other != &channel && !isFar(saturatedPlus(other.lastStamp, other.offset), time);
  });
}

const FileClock::Piece* FileClock::pieceMet(const Channel& channel, std::int64_t stamp, std::int64_t now) {
  const auto isMet = [&](const Piece& piece) {
    const std::int64_t past = saturatedMinus(stamp, piece.lastStamp);
    return past >= -kReturn.count() &&
           past <= saturatedPlus(saturatedMinus(now, piece.ended), kReturn.count());
  };
  const auto met = std::ranges::find_if(channel.earlier, isMet);
  return met == channel.earlier.end() ? nullptr : &*met;
}

FileClock::Verdict FileClock::step(Channel& channel, std::span<const Frame> frames, Follows follows,
                                   std::int64_t now) {
  const Frame& frame = frames.front();
  const bool isBack = frame.stamp < channel.lastStamp;
  const Piece* met = isBack ? nullptr : pieceMet(channel, frame.stamp, now);
  switch (isHeld(channel.lastStamp, frames, follows, met != nullptr)) {
    case Holds::Undecided: return {.kind = Kind::Undecided};
    case Holds::No: return {.kind = Kind::Timeless, .isStep = true, .offset = channel.offset};
    case Holds::Yes: break;
  }
  const bool beginsPiece = isBack || (met == nullptr && isDoubtful(channel));
  const Piece left{channel.offset, channel.lastStamp, now};
  channel.lastStamp = frame.stamp;
  channel.isLone = false;
  if (beginsPiece) {
    if (channel.earlier.size() == kMaxPieces) channel.earlier.erase(channel.earlier.begin());
    channel.earlier.push_back(left);
    channel.offset = saturatedMinus(now, frame.stamp);
    return {.kind = Kind::NewOffset, .isStep = true, .time = now, .offset = channel.offset};
  }
  if (met == nullptr)
    return {.isStep = true, .time = saturatedPlus(frame.stamp, channel.offset), .offset = channel.offset};
  channel.offset = met->offset;
  channel.earlier.erase(channel.earlier.begin() + (met - channel.earlier.data()));
  return {.kind = Kind::NewOffset,
          .isStep = true,
          .time = std::max(now, saturatedPlus(frame.stamp, channel.offset)),
          .offset = channel.offset};
}

}  // namespace deckpipe
