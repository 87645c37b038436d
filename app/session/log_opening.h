// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a log file into a document on a thread of its own. The session draws from the document meanwhile.
#pragma once

#include <QString>
#include <atomic>
#include <optional>
#include <thread>

#include "log/log_format.h"
#include "state/log_view.h"

namespace deckpipe {

class LogOpening {
 public:
  LogOpening(std::shared_ptr<LogDocument> document, const QString& path, bool addsUpTimes = false);
  ~LogOpening();  // gives up what is not read yet

  double fraction() const { return m_fraction.load(std::memory_order_relaxed); }
  // Null until the reading has ended. Any thread may call it.
  const Result<ReadSummary, ReadError>* outcome() const {
    return m_ended.load(std::memory_order_acquire) ? &*m_outcome : nullptr;
  }

 private:
  std::atomic<double> m_fraction = 0;
  std::atomic<bool> m_ended = false;
  std::optional<Result<ReadSummary, ReadError>> m_outcome;
  std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace deckpipe
