// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the frames of a log, or some of them, in the format that the file name asks for (formatToWrite()) on
// a thread of its own, while the log may go on growing: of the frames that were there at the beginning. The
// file appears whole or not at all. The window makes one for each saving, shows how far it is, and destroys
// it; destroying it gives up what is not written.
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <thread>

#include "log/log_format.h"
#include "state/log_view.h"

class QSaveFile;

namespace deckpipe {

struct SavedPart {
  std::uint64_t begin = 0;
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
  // Which of them; empty: all. Asked on the saving's thread, of every frame from the log's first on.
  std::function<bool(std::uint64_t frame)> passes{};
};

class LogSaving : public QObject {
  Q_OBJECT
 public:
  enum class Outcome { Saved, Cancelled, Failed };

  LogSaving(std::shared_ptr<const LogDocument> document, const QString& path, SavedPart part = {},
            QObject* parent = nullptr);
  ~LogSaving() override;

  QString path() const { return m_path; }
  QString formatName() const;
  // Nothing where that shows only as they are looked through.
  std::optional<std::uint64_t> frames() const;
  // Known once it is saved.
  std::uint64_t written() const { return m_written.load(std::memory_order_relaxed); }
  double fraction() const { return m_fraction.load(std::memory_order_relaxed); }
  void cancel() { m_thread.request_stop(); }

 Q_SIGNALS:
  // Once. `reason`: the system's words, where it failed.
  void ended(deckpipe::LogSaving::Outcome outcome, const QString& reason);

 private:
  void write(const std::stop_token& stop);
  bool writeFrames(QSaveFile& file, const std::stop_token& stop);

  std::shared_ptr<const LogDocument> m_document;
  QString m_path;
  const LogFormat& m_format;
  SavedPart m_part;
  std::atomic<std::uint64_t> m_written = 0;
  std::atomic<double> m_fraction = 0;
  std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace deckpipe
