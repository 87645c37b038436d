// SPDX-License-Identifier: GPL-3.0-or-later
// Whole logs for tests of models and panels, and the view of one that the session would hand over.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "log/log_format.h"
#include "state/advance.h"
#include "state/log_view.h"

namespace deckpipe::test {

inline void buildIndexes(LogDocument& log) {
  while (log.roles.build(100'000)) {
  }
  const Cursor end = cursorAfter(log.frames, log.frames.count());
  while (log.events.build(end) || log.exchanges.build(100'000) || log.keyframes.build()) {
  }
}

inline std::shared_ptr<LogDocument> logOf(const std::vector<Frame>& frames) {
  auto log = std::make_shared<LogDocument>();
  log->frames.channel("can0");
  if (!log->frames.append(frames)) std::abort();
  buildIndexes(*log);
  return log;
}

inline std::shared_ptr<LogDocument> logOfText(std::string_view candump) {
  auto log = std::make_shared<LogDocument>();
  if (!readLog(BytesInMemory(candump), {log->frames, log->skipped})) std::abort();
  buildIndexes(*log);
  return log;
}

// With the cursor behind so many frames; without a number it stands at the end and goes with it.
inline LogView viewOf(const std::shared_ptr<const LogDocument>& log,
                      std::optional<std::uint64_t> cursor = {}) {
  LogView view;
  view.document = log;
  view.state = std::make_shared<State>();
  if (!log) return view;
  view.frameCount = log->frames.count();
  view.begin = view.frameCount == 0 ? Instant{} : log->frames.timeAt(0);
  view.end = log->frames.lastTime();
  view.cursor = cursorAfter(log->frames, cursor.value_or(view.frameCount));
  view.atEnd = !cursor.has_value();
  return view;
}

}  // namespace deckpipe::test
