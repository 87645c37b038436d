// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/frame_test.h"

#include <optional>
#include <utility>

#include "model/log_walk.h"

namespace deckpipe {
namespace {

class FrameTest {
 public:
  FrameTest(std::shared_ptr<const LogDocument> log, const TraceFilter& filter)
      : m_log(std::move(log)), m_filter(filter), m_times(m_log->frames) {
    m_filter.bind(m_log->frames);
    if (m_filter.needsRoles()) m_walk.emplace(*m_log, 0);
  }
  bool passes(std::uint64_t index) {
    const Frame& frame = m_log->frames[index];
    const Instant time = m_times.at(index);
    const Classified what = m_walk ? m_walk->take(frame, time) : Classified{};
    return m_filter.matches({frame, index, time, what});
  }

 private:
  const std::shared_ptr<const LogDocument> m_log;
  TraceFilter m_filter;
  LogTimes m_times;
  std::optional<LogWalk> m_walk;
};

}  // namespace

std::function<bool(std::uint64_t)> frameTest(std::shared_ptr<const LogDocument> log,
                                             const TraceFilter& filter) {
  if (filter.isEmpty()) return {};
  return [test = std::make_shared<FrameTest>(std::move(log), filter)](std::uint64_t frame) {
    return test->passes(frame);
  };
}

}  // namespace deckpipe
