// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_rows.h"

#include <algorithm>

#include "model/log_walk.h"
#include "model/message_text.h"

namespace deckpipe {
namespace {

// So short a way is walked on; a longer one is left to the index.
constexpr std::uint64_t kNear = 64;

}  // namespace

std::vector<TraceRow> readTraceRows(const LogDocument& log, std::span<const std::uint64_t> frames,
                                    std::optional<std::uint64_t> before, std::span<const TraceRow> known) {
  std::vector<TraceRow> rows;
  rows.reserve(frames.size());
  LogTimes times(log.frames);
  std::optional<Instant> timeBefore;
  const bool hasTimes = log.frames.hasTimes();
  if (before) timeBefore = times.at(*before);
  const std::uint64_t built = log.roles.built();
  std::optional<LogWalk> walk;
  for (const std::uint64_t i : frames) {
    const auto old = std::lower_bound(known.begin(), known.end(), i,
                                      [](const TraceRow& row, std::uint64_t at) { return row.index < at; });
    const bool isKnown = old != known.end() && old->index == i;
    TraceRow row;
    row.index = i;
    row.frame = log.frames[i];
    const Instant time = times.at(i);
    if (timeBefore && hasTimes) row.delta = time - *timeBefore;
    timeBefore = time;
    if (isKnown && old->isSettled) {
      row.what = old->what;
      row.isSettled = true;
    } else {
      if (!walk || walk->next() > i || i - walk->next() > kNear) walk.emplace(log, i);
      while (walk->next() < i) {
        const std::uint64_t between = walk->next();
        walk->take(log.frames[between], times.at(between));
      }
      row.what = walk->take(row.frame, time);
      row.isSettled = i < built;
    }
    if (isKnown && old->what == row.what) {
      row.title = old->title;
      row.summary = old->summary;
    } else {
      row.title = frameTitle(row.frame, row.what);
      row.summary = summaryText(row.frame, row.what);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Classified classifyAt(const LogDocument& log, std::uint64_t index) {
  LogWalk walk(log, index);
  return walk.take(log.frames[index], log.frames.timeAt(index));
}

}  // namespace deckpipe
