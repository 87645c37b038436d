// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/frame_test.h"

#include <utility>

namespace deckpipe {

FrameTest::FrameTest(std::shared_ptr<const LogDocument> log, const TraceFilter& filter)
    : m_log(std::move(log)), m_filter(filter) {
  bind();
  if (m_filter.needsRoles()) m_walk.emplace(*m_log, 0);
}

bool FrameTest::passes(std::uint64_t index, Instant time) {
  const Frame& frame = m_log->frames[index];
  const Classified what = m_walk ? m_walk->take(frame, time) : Classified{};
  return m_filter.matches({frame, index, time, what});
}

std::function<bool(std::uint64_t)> frameTest(std::shared_ptr<const LogDocument> log,
                                             const TraceFilter& filter) {
  if (filter.isEmpty()) return {};
  struct Timed {
    FrameTest test;
    LogTimes times;
  };
  auto timed = std::make_shared<Timed>(Timed{FrameTest(log, filter), LogTimes(log->frames)});
  return [timed](std::uint64_t frame) { return timed->test.passes(frame, timed->times.at(frame)); };
}

}  // namespace deckpipe
