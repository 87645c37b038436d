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
    : QObject(parent), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

TraceSearch::~TraceSearch() {
  // Answers go to this object: none may be given any more once it is half gone.
  m_thread.request_stop();
  m_thread.join();
}

void TraceSearch::find(Question question) {
  m_isSearching = true;
  {
    const std::lock_guard lock(m_lock);
    m_fraction.store(0, std::memory_order_relaxed);
    ++m_serial;
    m_question = std::move(question);
  }
  m_wake.notify_one();
}

void TraceSearch::cancel() {
  m_isSearching = false;
  const std::lock_guard lock(m_lock);
  ++m_serial;
  m_question.reset();
}

bool TraceSearch::isGivenUp(const std::stop_token& stop) const {
  const std::lock_guard lock(m_lock);
  return stop.stop_requested() || m_serial != m_looking;
}

void TraceSearch::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::optional<Question> question;
    {
      std::unique_lock lock(m_lock);
      if (!m_wake.wait(lock, stop, [this] { return m_question.has_value(); })) return;
      question = std::exchange(m_question, std::nullopt);
      m_looking = m_serial;
    }
    const auto answer = look(*question, stop);
    if (!answer) continue;
    QMetaObject::invokeMethod(
        this, [this, serial = m_looking, answer = *answer] { tell(serial, answer); }, Qt::QueuedConnection);
  }
}

void TraceSearch::tell(std::uint64_t serial, const Answer& answer) {
  {
    const std::lock_guard lock(m_lock);
    if (serial != m_serial) return;
  }
  m_isSearching = false;
  if (answer.frame) {
    Q_EMIT found(*answer.frame, answer.wrapped);
  } else {
    Q_EMIT notFound();
  }
}

std::optional<TraceSearch::Answer> TraceSearch::look(Question& question, const std::stop_token& stop) {
  const FrameStore& frames = question.log->frames;
  question.shown.bind(frames);
  question.wanted.bind(frames);
  const bool needsRoles = question.shown.needsRoles() || question.wanted.needsRoles();
  const std::uint64_t count = std::min(question.frames, frames.count());
  const std::uint64_t from = std::min(question.from, count);
  LogTimes times(frames);
  std::optional<LogWalk> walk;
  bool isGiven = false;
  std::uint64_t looked = 0;
  // The first or last frame of [begin, end) that passes.
  const auto lookAt = [&](std::uint64_t begin, std::uint64_t end) -> std::optional<std::uint64_t> {
    std::optional<std::uint64_t> last;
    if (needsRoles && (!walk || walk->next() != begin)) walk.emplace(*question.log, begin);
    for (std::uint64_t i = begin; i < end; ++i) {
      if (i % kGlance == 0 && isGivenUp(stop)) {
        isGiven = true;
        return {};
      }
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
    while (begin < end && !isGiven) {
      const std::uint64_t some = std::min(kBlock, end - begin);
      const std::uint64_t first = question.isBackwards ? end - some : begin;
      if (const auto frame = lookAt(first, first + some)) return frame;
      looked += some;
      if (!isGiven) m_fraction.store(static_cast<double>(looked) / static_cast<double>(count));
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
  if (!answer.frame && !isGiven) {
    answer.frame = question.isBackwards ? lookThrough(from, count) : lookThrough(0, from);
    answer.wrapped = true;
  }
  if (isGiven) return {};
  return answer;
}

}  // namespace deckpipe
