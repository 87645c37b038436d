// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the log of a live source to a journal while it grows, on a thread of its own. The bus thread has no
// part in it: the recorder reads the log as views do. A disk that hangs holds up nobody else.
#pragma once

#include <QString>
#include <memory>

#include "log/journal_writer.h"
#include "state/log_view.h"

namespace deckpipe {

// Makes the file of a recording that begins now, named by local time ("2026-11-28_14-03-22.deckpipe"). The
// folder is made where it is missing.
JournalWriter::MakeFile recordingIn(const QString& folder);
// The head of a recording that begins now.
JournalHead recordingHead(bool isSimulated);

class Recorder {
 public:
  static constexpr std::chrono::milliseconds kPoll{250};
  static constexpr std::chrono::milliseconds kPatience{2'000};
  // A disk that takes longer is said not to answer.
  static constexpr Duration kHangs = 2s;

  Recorder(std::shared_ptr<const LogDocument> document, JournalWriter::MakeFile makeFile, bool isSimulated);
  // Ends it, and waits for the disk so long as kPatience. What hangs longer is left to itself, and what a
  // faulty disk does not take is lost.
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  JournalStatus status() const;
  bool isOf(const std::shared_ptr<const LogDocument>& document) const;
  // The log takes no more: what is left is written, and the file is closed. Does not wait. After a fault the
  // log is kept in memory, and that is tried again.
  void end();
  bool hasEnded() const;
  // The first so many frames and notes were saved elsewhere. A recording is marked as saved once it has ended without
  // another frame or note, but for those of leaving its link.
  void setSaved(std::uint64_t frames, std::size_t notes);

 private:
  struct Work;
  std::shared_ptr<Work> m_work;  // the thread's too
  std::weak_ptr<const LogDocument> m_document;
};

}  // namespace deckpipe
