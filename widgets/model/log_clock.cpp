// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/log_clock.h"

#include <algorithm>

#include "text/time_text.h"

namespace deckpipe {
namespace {

// Frames without a stamp are few; a longer run of them has no clock.
constexpr std::uint64_t kLookAt = 256;
constexpr int kMostDates = 400;

QDateTime localOf(std::int64_t stampNs) { return QDateTime::fromMSecsSinceEpoch(stampNs / 1'000'000); }

}  // namespace

LogClock::LogClock(const LogView& view) {
  if (!view.document || view.frameCount == 0 || !view.hasTimes()) return;
  const FrameStore& frames = view.document->frames;
  std::vector<std::uint64_t> begins{0};
  const auto& jumps = frames.jumps();
  for (std::size_t i = 0; i < jumps.size() && jumps[i] < view.frameCount; ++i) begins.push_back(jumps[i]);
  begins.push_back(view.frameCount);
  for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
    const std::uint64_t end = std::min(begins[i + 1], begins[i] + kLookAt);
    for (std::uint64_t at = begins[i]; at < end; ++at) {
      const Frame& frame = frames[at];
      if (!frame.hasStamp() || !isDate(frame.stamp)) continue;
      const Instant begin = frames.timeAt(at);
      // A stamp that log time does not follow is none of this clock.
      if (saturatedPlus(frame.stamp, frames.offsetOf(frame.channel, at)) != begin.ns) continue;
      const Instant until = begins[i + 1] == view.frameCount ? view.end : frames.timeAt(begins[i + 1]);
      m_pieces.push_back({frame.stamp, begin, until - begin});
      break;
    }
  }
}

QDateTime LogClock::first() const { return hasDates() ? localOf(m_pieces.front().stamp) : QDateTime(); }

QDateTime LogClock::last() const { return hasDates() ? localOf(m_pieces.back().end()) : QDateTime(); }

std::optional<Instant> LogClock::at(const QDateTime& local) const {
  const std::int64_t stamp = local.toMSecsSinceEpoch() * 1'000'000;
  for (const Piece& piece : m_pieces) {
    // A typed time has milliseconds, a stamp has finer ones.
    const std::int64_t begin = piece.stamp - piece.stamp % 1'000'000;
    if (begin <= stamp && stamp <= piece.end())
      return piece.begin + std::max(Duration{stamp - piece.stamp}, Duration{0});
  }
  return {};
}

std::vector<QDate> LogClock::datesOf(QTime time) const {
  std::vector<QDate> dates;
  for (const Piece& piece : m_pieces) {
    const QDate last = localOf(piece.end()).date();
    for (QDate date = localOf(piece.stamp).date(); date <= last && dates.size() < kMostDates;
         date = date.addDays(1)) {
      if (at(QDateTime(date, time)) && std::ranges::find(dates, date) == dates.end()) dates.push_back(date);
    }
  }
  return dates;
}

}  // namespace deckpipe
