// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the frames of a log as candump text on a thread of its own, while the log may go on growing: the
// frames that were there at the beginning are saved. The file appears whole or not at all. The window makes
// one for each saving, shows how far it is, and destroys it; destroying it gives up what is not written.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <thread>

#include "state/log_view.h"

namespace deckpipe {

class LogSaving : public QObject {
  Q_OBJECT
 public:
  enum class Outcome { Saved, Cancelled, Failed };

  LogSaving(std::shared_ptr<const LogDocument> document, const QString& path, QObject* parent = nullptr);
  ~LogSaving() override;

  QString path() const { return m_path; }
  std::uint64_t frames() const { return m_frames; }
  double fraction() const { return m_fraction.load(std::memory_order_relaxed); }
  void cancel() { m_thread.request_stop(); }

 Q_SIGNALS:
  // Once. `reason`: the system's words, where it failed.
  void ended(deckpipe::LogSaving::Outcome outcome, const QString& reason);

 private:
  void write(const std::stop_token& stop);

  std::shared_ptr<const LogDocument> m_document;
  QString m_path;
  std::uint64_t m_frames;
  std::atomic<double> m_fraction = 0;
  std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace deckpipe
