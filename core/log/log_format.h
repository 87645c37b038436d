// SPDX-License-Identifier: GPL-3.0-or-later
// The formats of logs that Deckpipe reads and writes: one table, and the one door to them. A new format is a
// file of its own and an entry in the table; the filters of file dialogs, help texts and sentences that name
// formats are made from it.
//
// Content decides what a file is, never its name.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "bus/frame.h"
#include "log/frame_store.h"
#include "log/log_bytes.h"
#include "log/log_writer.h"
#include "log/note_store.h"
#include "log/reading.h"
#include "log/skipped.h"

namespace deckpipe {

// Reads what comes through a pipe. feed() is called until it returns false or the pipe ends, then finish()
// once.
class StreamReader {
 public:
  virtual ~StreamReader() = default;
  // False once nothing more will be taken; finish() then says why.
  virtual bool feed(std::string_view bytes) = 0;
  virtual Result<ReadSummary, ReadError> finish() = 0;
};

// Where a log goes that is read; all empty.
struct LogTarget {
  FrameStore& frames;
  SkippedList& skipped;
  NoteStore* notes = nullptr;  // null: notes are left out
};

struct LogFormat {
  std::string_view name;      // a proper name, not translated: "candump"
  std::string_view patterns;  // of file names, the usual first, separated by blanks: "*.log *.txt"

  // By the first kSniffBytes of a log, or all of it if that is less: `isWhole`.
  Sniff (*sniff)(std::string_view head, bool isWhole);
  Result<ReadSummary, ReadError> (*read)(const LogBytes&, const LogTarget&, const ReadOptions&);
  // Null if it cannot be read from a pipe.
  std::unique_ptr<StreamReader> (*stream)(const LogTarget&, const ReadOptions&) = nullptr;
  // Null if it cannot be written.
  std::unique_ptr<LogWriter> (*makeWriter)() = nullptr;
  // Deckpipe's own: it holds notes and log times, and has no sidecar.
  bool isOwn = false;
};

// In the order in which they are asked whether a log is theirs.
std::span<const LogFormat> logFormats();

// Finds the format and reads the log; openLog() also the sidecar beside it (sidecar.h), once the log was read
// whole. An error names the format that its content seemed to be, if any.
Result<ReadSummary, ReadError> openLog(const std::string& path, const LogTarget& target,
                                       const ReadOptions& options = {},
                                       std::span<const LogFormat> formats = logFormats());
Result<ReadSummary, ReadError> readLog(const LogBytes& bytes, const LogTarget& target,
                                       const ReadOptions& options = {},
                                       std::span<const LogFormat> formats = logFormats());

// What a log of this file name is written as: the first that can be written and has a pattern of its suffix,
// otherwise the first that other programs read too.
const LogFormat& formatToWrite(std::string_view fileName, std::span<const LogFormat> formats = logFormats());

// "candump, BLF": of the formats with which that can be done.
enum class LogUse : std::uint8_t { Read, ReadFromPipe, Write };
std::string formatNames(LogUse use, std::span<const LogFormat> formats = logFormats());

}  // namespace deckpipe
