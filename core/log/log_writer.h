// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a log of one format, frame by frame: what a format of the table (log_format.h) brings along if it can
// be written. Whoever saves a log makes one for each file and calls begin(), then for each frame in order
// channel(), note() and frame(), then end().
#pragma once

#include <string>
#include <string_view>

#include "base/time.h"
#include "bus/frame.h"
#include "log/note.h"

namespace deckpipe {

// All but beside() append to `out`.
class LogWriter {
 public:
  virtual ~LogWriter() = default;
  virtual void begin(std::string& out) = 0;
  // The next channel: they are numbered from 0 on, and each is told before what comes of it.
  virtual void channel(std::string_view name, std::string& out) = 0;
  // Stands before the next frame, which note.frame counts.
  virtual void note(const Note& note, std::string& out) = 0;
  // `time` is its log time.
  virtual void frame(const Frame& frame, Instant time, std::string& out) = 0;
  virtual void end(std::string& out) = 0;
  // After end(): what belongs into a file beside the log, since the format has no place for it (sidecar.h).
  // Empty: no such file is wanted.
  virtual std::string beside() const { return {}; }
};

}  // namespace deckpipe
