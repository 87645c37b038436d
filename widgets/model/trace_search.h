// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the next or the previous frame that passes an expression, among those that the trace's filter lets
// through: on a thread of its own, newest question first. From the end it goes on at the begin, and back,
// until every frame was looked at. Asked by the trace panel.
#pragma once

#include <QObject>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "base/latest_request_worker.h"
#include "model/trace_filter.h"
#include "state/log_view.h"

namespace deckpipe {

class TraceSearch : public QObject {
  Q_OBJECT

 public:
  struct Question {
    std::shared_ptr<const LogDocument> log;
    TraceFilter shown;   // what the trace shows
    TraceFilter wanted;  // what is looked for among that
    std::uint64_t frames = 0;
    // Forwards this frame is the first that may be found, backwards the last one before it.
    std::uint64_t from = 0;
    bool isBackwards = false;
  };

  explicit TraceSearch(QObject* parent = nullptr);

  // What was asked before is given up.
  void find(Question question);
  void cancel();
  bool isSearching() const { return m_isSearching; }
  // How much of the log the newest question has looked at, 0 … 1.
  double fraction() const { return m_fraction.load(std::memory_order_relaxed); }

 Q_SIGNALS:
  // One of these for each question that is not given up. `wrapped`: beyond the end, or the begin.
  void found(quint64 frame, bool wrapped);
  void notFound();

 private:
  struct Answer {
    std::optional<std::uint64_t> frame;
    bool wrapped = false;
  };
  using Worker = LatestRequestWorker<Question, Answer>;
  // Nothing where it was given up.
  std::optional<Answer> look(Question& question, const Worker::Turn& turn);
  void tell();

  bool m_isSearching = false;
  std::atomic<double> m_fraction = 0;
  Worker m_worker;  // last: it uses all of the above
};

}  // namespace deckpipe
