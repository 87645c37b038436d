// SPDX-License-Identifier: GPL-3.0-or-later
// A log given on the command line: a file, or what comes on standard input or a pipe. Frames go to the
// store; whoever wants them is called as they come, on the calling thread.
#pragma once

#include <functional>
#include <string>

#include "arguments.h"
#include "base/result.h"
#include "log/frame_store.h"
#include "log/note_store.h"
#include "log/reading.h"
#include "log/skipped.h"

namespace deckpipe::ctl {

// The sentence of --help that says which files and pipes can be read.
std::string logArgumentHelp();

// --deltas
Arguments::Option deltasOption();

struct LogInput {
  // Its FILE and --deltas.
  explicit LogInput(const Arguments& arguments)
      : path(arguments.argument().toStdString()), addsUpTimes(arguments.has("deltas")) {}

  std::string path;  // "-" is standard input
  bool addsUpTimes;  // --deltas was given
  FrameStore frames;
  NoteStore notes;  // of a recording or a sidecar
  SkippedList skipped;
  LastLine lastLine = LastLine::Whole;  // once it was read

  // Its times look like differences, and were not added up.
  bool hasDeltas() const;
  // What a person calls it in messages.
  std::string name() const { return path == "-" ? "standard input" : path; }
  // Reads all of it, calling `more` whenever the store has grown and once at the end; false from it stops the
  // reading. What could not be read is said on standard error. After kCannotRead and
  // kNothingRead the store holds no frame.
  ExitStatus read(const std::function<bool()>& more);

 private:
  ExitStatus readFile(const std::function<bool()>& more);
  // Whatever is no regular file: standard input, a pipe.
  ExitStatus readStream(int descriptor, const std::function<bool()>& more);
  // Says what came of it.
  ExitStatus ended(const Result<ReadSummary, ReadError>& outcome);
  void saySkipped(const SkippedPlaces& content) const;
  bool m_hasBytes = false;  // the file or pipe is not empty
  // Says which parts of a recording or its notes are missing; false if any is.
  bool sayMissing(const ReadSummary& summary) const;
  void sayFiltered() const;
  // Says how many frames came that are not in the log; true if it cannot hold some of them.
  bool sayMissed() const;
};

}  // namespace deckpipe::ctl
