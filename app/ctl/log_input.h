// SPDX-License-Identifier: GPL-3.0-or-later
// A log given on the command line: a file, or what comes on standard input or a pipe. Frames go to the
// store; whoever wants them is called as they come, on the calling thread.
#pragma once

#include <QString>
#include <functional>
#include <string>

#include "log/frame_store.h"
#include "log/note_store.h"
#include "log/reading.h"
#include "log/unkept.h"

namespace deckpipe::ctl {

// The sentence of --help that says which files and pipes can be read.
QString logArgumentHelp();

struct LogInput {
  explicit LogInput(std::string filePath) : path(std::move(filePath)) {}

  std::string path;  // "-" is standard input
  FrameStore frames;
  NoteStore notes;  // of a recording
  UnkeptList unkept;

  // What a person calls it in messages.
  std::string name() const { return path == "-" ? "standard input" : path; }
  // Reads all of it, calling `more` whenever the store has grown and once at the end; false from it stops the
  // reading. What could not be read is said on standard error. Returns the exit status.
  int read(const std::function<bool()>& more);

 private:
  int readFile(const std::function<bool()>& more);
  // Whatever is no regular file: standard input, a pipe.
  int readStream(int descriptor, const std::function<bool()>& more);
  int sayUnkept() const;
  // Of a recording.
  int sayMissing(const ReadSummary& summary) const;
};

}  // namespace deckpipe::ctl
