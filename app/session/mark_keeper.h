// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the marks that a person makes in a log of a file: writes the sidecar beside the log (sidecar.h) anew, with all
// notes of the log, on a thread of its own. Marks that are made while it writes are written together after that. The
// session calls keep() after each mark and asks for the status on its tick. A sidecar that is not the one that was
// read, or that was not read whole, is never replaced.
#pragma once

#include <QDateTime>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "session/known_sidecars.h"
#include "session/snapshot.h"

namespace deckpipe {

// The file beside a log that holds its notes.
QString sidecarOf(const QString& logPath);
// Writes a whole file, or leaves it as it was. Returns the system's words why not; empty if it is on the disk.
QString writeWholeFile(const QString& path, const std::string& text);
// When the sidecar beside a log was written; invalid if there is none.
QDateTime sidecarTime(const QString& logPath);

class MarkKeeper {
 public:
  // Does what writeWholeFile() does.
  using Write = std::function<QString(const QString& path, const std::string& text)>;
  // A disk that takes longer is said not to answer.
  static constexpr Duration kHangs = 2s;
  static constexpr std::chrono::milliseconds kPatience{2'000};

  struct Status {
    bool isBusy = false;  // marks are being written
    // Why marks are in memory alone; nothing if they are in the file, or are being written.
    std::optional<UnkeptMarks> unkept{};
    friend bool operator==(const Status&, const Status&) = default;
  };

  explicit MarkKeeper(Write write = writeWholeFile) : m_write(std::move(write)) {}
  // Those that it read and wrote. Whoever else writes sidecars tells them too.
  std::shared_ptr<KnownSidecars> sidecars() const { return m_sidecars; }
  // Waits for the disk so long as kPatience; what hangs longer is left to itself.
  ~MarkKeeper();
  MarkKeeper(const MarkKeeper&) = delete;
  MarkKeeper& operator=(const MarkKeeper&) = delete;

  // The log of this file was read; `sidecarTime` is from before that. Marks of an earlier log are still written.
  void opened(const QString& path, const ReadSummary& read, const QDateTime& sidecarTime);
  // Neither this nor the rest waits for the disk.
  void keep(std::shared_ptr<const LogDocument> log);
  // The marks so far are in another file.
  void forget();
  // The status of the log that was opened last. `now`: bootTime().
  Status status(Instant now) const;

 private:
  struct Work;

  Write m_write;
  std::shared_ptr<KnownSidecars> m_sidecars = std::make_shared<KnownSidecars>();  // the threads' too
  std::vector<std::shared_ptr<Work>> m_works;  // their threads' too; the last is that of the open log
};

}  // namespace deckpipe
