// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_search.h"

#include <algorithm>
#include <utility>

#include "model/log_walk.h"

namespace deckpipe {
namespace {

constexpr std::uint64_t kBlock = 16'384;  // of frames that are looked at between two glances at the time
constexpr std::uint64_t kGlance = 256;

}  // namespace

TraceSearch::TraceSearch(QObject* parent)
    : QObject(parent), m_worker([this](Question question, const Worker::Turn& turn) {
        m_fraction.store(0, std::memory_order_relaxed);
        const auto answer = look(question, turn);
        if (!answer) return;
        turn.handOver(std::make_shared<const Answer>(*answer));
        QMetaObject::invokeMethod(this, &TraceSearch::tell, Qt::QueuedConnection);
      }) {}

void TraceSearch::find(Question question) {
  m_isSearching = true;
  m_fraction.store(0, std::memory_order_relaxed);
  m_worker.request(std::move(question));
}

void TraceSearch::cancel() {
  m_isSearching = false;
  m_worker.cancel();
}

void TraceSearch::tell() {
  const auto answer = m_worker.outcome();
  if (answer == nullptr || !std::exchange(m_isSearching, false)) return;
  if (answer->frame) {
    Q_EMIT found(*answer->frame, answer->wrapped);
  } else {
    Q_EMIT notFound();
  }
}

std::optional<TraceSearch::Answer> TraceSearch::look(Question& question, const Worker::Turn& turn) {
  const FrameStore& frames = question.log->frames;
  question.shown.bind(frames);
  question.wanted.bind(frames);
  const bool needsRoles = question.shown.needsRoles() || question.wanted.needsRoles();
  const std::uint64_t count = std::min(question.frames, frames.count());
  const std::uint64_t from = std::min(question.from, count);
  LogTimes times(frames);
  std::optional<LogWalk> walk;
  std::uint64_t looked = 0;
  // The first or last frame of [begin, end) that passes.
  const auto lookAt = [&](std::uint64_t begin, std::uint64_t end) -> std::optional<std::uint64_t> {
    std::optional<std::uint64_t> last;
    if (needsRoles && (!walk || walk->next() != begin)) walk.emplace(*question.log, begin);
    for (std::uint64_t i = begin; i < end; ++i) {
      if (i % kGlance == 0 && turn.isGivenUp()) return {};
      const Instant time = times.at(i);
      const Classified what = needsRoles ? walk->take(frames[i], time) : Classified{};
      const FilterFrame frame{frames[i], i, time, what};
      if (!question.shown.matches(frame) || !question.wanted.matches(frame)) continue;
      last = i;
      if (!question.isBackwards) break;
    }
    return last;
  };
  const auto lookThrough = [&](std::uint64_t begin, std::uint64_t end) -> std::optional<std::uint64_t> {
    while (begin < end && !turn.isGivenUp()) {
      const std::uint64_t some = std::min(kBlock, end - begin);
      const std::uint64_t first = question.isBackwards ? end - some : begin;
      if (const auto frame = lookAt(first, first + some)) return frame;
      looked += some;
      if (!turn.isGivenUp()) m_fraction.store(static_cast<double>(looked) / static_cast<double>(count));
      if (question.isBackwards) {
        end -= some;
      } else {
        begin += some;
      }
    }
    return {};
  };
  Answer answer;
  answer.frame = question.isBackwards ? lookThrough(0, from) : lookThrough(from, count);
  if (!answer.frame) {
    answer.frame = question.isBackwards ? lookThrough(from, count) : lookThrough(0, from);
    answer.wrapped = true;
  }
  if (turn.isGivenUp()) return {};
  return answer;
}

}  // namespace deckpipe
