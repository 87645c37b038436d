// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a log file into a document on a thread of its own. The session draws from the document meanwhile.
#pragma once

#include <QDateTime>
#include <QString>
#include <atomic>
#include <optional>
#include <thread>

#include "log/log_format.h"
#include "state/log_view.h"

namespace deckpipe {

class LogOpening {
 public:
  using Outcome = Result<ReadSummary, ReadError>;

  LogOpening(std::shared_ptr<LogDocument> document, const QString& path, bool addsUpTimes = false);
  ~LogOpening();  // gives up what is not read yet

  double fraction() const { return m_fraction.load(std::memory_order_relaxed); }
  // Null until the reading has ended. Any thread may call it.
  const Outcome* outcome() const { return m_ended.load(std::memory_order_acquire) ? &*m_outcome : nullptr; }
  // When the file beside it that holds its notes was written, as it was before that was read; invalid if there was
  // none. Known with the outcome.
  QDateTime sidecarTime() const { return m_sidecarTime; }

 private:
  std::atomic<double> m_fraction = 0;
  std::atomic<bool> m_ended = false;
  std::optional<Outcome> m_outcome;
  QDateTime m_sidecarTime;
  std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace deckpipe
