// SPDX-License-Identifier: GPL-3.0-or-later
// A thread that works on the newest request: a newer request, or cancel(), gives up the one that is worked on,
// and requests between the two are never begun. For walks over a log that a window asks for: asking and reading
// never wait for work. The work function asks Turn::isGivenUp() often, as the destructor waits until it returns.
//
// A result is handed over whole and shared. Also work that was given up may hand one over, for a picture on the
// way is better than none; outcome() tells only what the newest request has found.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace deckpipe {

// For work that keeps its result elsewhere.
struct NoResult {};

template <typename Request, typename Result = NoResult>
class LatestRequestWorker {
 public:
  // A turn tells the work function whether its request still counts, and takes what it has found.
  class Turn {
   public:
    bool isGivenUp() const { return m_worker.m_newest.load(std::memory_order_relaxed) != m_number; }
    void handOver(std::shared_ptr<const Result> result) const {
      const std::lock_guard lock(m_worker.m_lock);
      m_worker.m_latest = std::move(result);
      m_worker.m_latestNumber = m_number;
    }

   private:
    friend class LatestRequestWorker;
    Turn(LatestRequestWorker& worker, std::uint64_t number) : m_worker(worker), m_number(number) {}
    LatestRequestWorker& m_worker;
    std::uint64_t m_number;
  };
  using Work = std::function<void(Request, const Turn&)>;

  // `first`: the result until there is another one.
  explicit LatestRequestWorker(Work work, std::shared_ptr<const Result> first = nullptr)
      : m_work(std::move(work)), m_latest(std::move(first)), m_thread([this] { run(); }) {}
  ~LatestRequestWorker() {
    {
      const std::lock_guard lock(m_lock);
      m_isEnding = true;
      ++m_newest;
    }
    m_wake.notify_one();
  }
  LatestRequestWorker(const LatestRequestWorker&) = delete;
  LatestRequestWorker& operator=(const LatestRequestWorker&) = delete;

  void request(Request request) {
    {
      const std::lock_guard lock(m_lock);
      m_request = std::move(request);
      ++m_newest;
    }
    m_wake.notify_one();
  }
  void cancel() {
    const std::lock_guard lock(m_lock);
    m_request.reset();
    ++m_newest;
  }

  // The last result that was handed over, whatever it was asked for.
  std::shared_ptr<const Result> latest() const {
    const std::lock_guard lock(m_lock);
    return m_latest;
  }
  // The result of the newest request; null while there is none, and once the request was cancelled.
  std::shared_ptr<const Result> outcome() const {
    const std::lock_guard lock(m_lock);
    return m_latestNumber == m_newest.load(std::memory_order_relaxed) ? m_latest : nullptr;
  }

 private:
  void run() {
    std::unique_lock lock(m_lock);
    for (;;) {
      m_wake.wait(lock, [this] { return m_request.has_value() || m_isEnding; });
      if (m_isEnding) return;
      Request request = *std::exchange(m_request, std::nullopt);
      const Turn turn(*this, m_newest.load(std::memory_order_relaxed));
      lock.unlock();
      m_work(std::move(request), turn);
      lock.lock();
    }
  }

  const Work m_work;
  mutable std::mutex m_lock;  // guards the members up to the thread
  std::condition_variable m_wake;
  std::optional<Request> m_request;        // that nobody works on yet
  std::atomic<std::uint64_t> m_newest{1};  // number of the newest request; cancelling and ending count too
  bool m_isEnding = false;
  std::shared_ptr<const Result> m_latest;
  std::uint64_t m_latestNumber = 0;  // of the request that it was found for
  std::jthread m_thread;             // last: it uses all of the above
};

}  // namespace deckpipe
