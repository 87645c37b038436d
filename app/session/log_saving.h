// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the frames of a log, or some of them, in the format that the file name asks for (formatToWrite()) on
// a thread of its own, while the log may go on growing: of the frames that were there at the beginning, with
// their notes (PartWriter). The file appears whole or not at all, and after it the sidecar if it needs one
// (sidecar.h). One that was there is replaced or removed. If it holds what is not known here, nothing is written
// at all (known_sidecars.h). The window makes one for each saving, shows how far it is, and destroys it; destroying
// it gives up what is not written.
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "log/log_format.h"
#include "session/known_sidecars.h"
#include "session/mark_keeper.h"
#include "session/part_writer.h"
#include "session/whole_file.h"
#include "state/log_view.h"

namespace deckpipe {

struct SavedPart {
  std::uint64_t begin = 0;
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
  // Which of them; empty: all. Asked on the saving's thread, of every frame from the log's first on.
  std::function<bool(std::uint64_t frame)> passes{};
  std::string filter{};  // that test as the person wrote it
  LabelsByPin labels{};
  std::uint64_t missing = 0;  // ReadSummary::missing() of the file that the log was read from
};

class LogSaving : public QObject {
  Q_OBJECT
 public:
  enum class Outcome {
    Saved,
    Cancelled,
    Failed,
    IsGrowing,       // the file is a recording that some program is writing
    SidecarUnknown,  // the sidecar beside the file is none that was read or written here: nothing is replaced
  };

  LogSaving(std::shared_ptr<const LogDocument> document, const QString& path, SavedPart part = {},
            std::shared_ptr<KnownSidecars> sidecars = std::make_shared<KnownSidecars>());
  ~LogSaving() override;

  QString path() const { return m_path; }
  // Nothing where that shows only as they are looked through.
  std::optional<std::uint64_t> frames() const;
  // Known once it is saved: frames of the log, and frames that were added to them.
  std::uint64_t written() const { return m_written.load(std::memory_order_relaxed); }
  std::uint64_t added() const { return m_added.load(std::memory_order_relaxed); }
  // The file beside it that was written too; empty without one.
  QString sidecar() const {
    return m_hasSidecar.load(std::memory_order_relaxed) ? sidecarOf(m_path) : QString();
  }
  // The log had so many notes when this began, all of which are saved with a whole log.
  std::size_t notes() const { return m_notes; }
  double fraction() const { return m_fraction.load(std::memory_order_relaxed); }
  void cancel() { m_thread.request_stop(); }

 Q_SIGNALS:
  // Once. `reason`: the system's words alone: of Failed, and of a log that was saved, why its sidecar was not.
  void ended(deckpipe::LogSaving::Outcome outcome, const QString& reason);

 private:
  void write(const std::stop_token& stop);
  bool writeFrames(WholeFile& file, LogWriter& writer, const std::stop_token& stop);
  // The reason why not; empty if it is there, or none is needed.
  QString writeSidecar(const std::string& text);

  std::shared_ptr<const LogDocument> m_document;
  const std::size_t m_notes;
  const Instant m_ranUntil;  // before the frames are counted: those that came until then are among them
  QString m_path;
  const LogFormat& m_format;
  SavedPart m_part;
  const std::shared_ptr<KnownSidecars> m_sidecars;
  bool m_isToEnd = false;
  std::atomic<std::uint64_t> m_written = 0;
  std::atomic<std::uint64_t> m_added = 0;
  std::atomic<bool> m_hasSidecar = false;
  std::atomic<double> m_fraction = 0;
  std::jthread m_thread;  // last: it uses all of the above
};

}  // namespace deckpipe
