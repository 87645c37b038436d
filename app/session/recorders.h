// SPDX-License-Identifier: GPL-3.0-or-later
// The recorder of the open source, and those of earlier sources, some of them still at work. The session owns
// this. None of the calls waits for a disk but the destructor (session/recorder.h).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "session/recorder.h"

namespace deckpipe {

class Recorders {
 public:
  // Writes down the log of the open source from now on.
  void begin(const std::shared_ptr<LogDocument>& document, JournalWriter::MakeFile makeFile,
             bool isSimulated);
  // The status of the recording of the open source; nothing if it is not recorded.
  std::optional<JournalStatus> status() const;
  // Detaches the recorder from the open source and returns its last status. Where a bus may still write into the
  // log, the recorder goes on until endOf().
  std::optional<JournalStatus> leave(bool isStillWritten);
  // Ends the recording of an earlier source: no bus writes into its log any more.
  void endOf(const std::shared_ptr<LogDocument>& document);

  // A faulty disk did not take all of a recording.
  bool holdUnwritten() const;
  // The first so many frames of a log were saved elsewhere. False where the log has no recorder.
  bool setSaved(const std::shared_ptr<const LogDocument>& document, std::uint64_t frames, std::size_t notes);

 private:
  std::unique_ptr<Recorder> m_open;
  std::vector<std::unique_ptr<Recorder>> m_earlier;
};

}  // namespace deckpipe
