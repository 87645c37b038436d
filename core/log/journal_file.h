// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a journal as its writer sees it: bytes are appended as a whole or not at all. Tests have disks
// of their own. The .cpp is POSIX, as in mapped_memory.h.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "base/result.h"

namespace deckpipe {

struct JournalFault {
  enum class Kind : std::uint8_t {
    None,
    CannotCreate,
    DiskFull,
    CannotWrite,
    NoAnswer,  // the disk has hung for a while
    Removed,   // the file was removed, or another took its name
    Changed,   // another program cut the file or wrote into it
  };
  Kind kind = Kind::None;
  std::string detail{};  // the system's words; of Removed and Changed the file's path

  explicit operator bool() const { return kind != Kind::None; }
  friend bool operator==(const JournalFault&, const JournalFault&) = default;
};

class JournalFile {
 public:
  virtual ~JournalFile() = default;
  // A file that is renamed while it is written has its new name.
  virtual std::string path() const = 0;
  // Writes at `offset`, which is at most the size, and makes that what is written the end of the file. After a
  // fault the file may be longer than `offset`; the next call with that offset makes up for it.
  virtual JournalFault append(std::uint64_t offset, std::span<const std::uint8_t> bytes) = 0;
  // Returns once all of it is on the disk.
  virtual JournalFault sync() = 0;
  // Whether the file still has a name and is as long as what was written: Removed or Changed if not. What was
  // written before is lost then, and nothing more may be appended. Not after a fault of the others.
  virtual JournalFault check() = 0;
};

using MadeJournalFile = Result<std::unique_ptr<JournalFile>, JournalFault>;

// A new file, locked as long as it is open (isBeingWritten()). `path` is its name without suffix; where there
// is such a file a number is added to it.
MadeJournalFile createJournalFile(const std::string& path);

// Puts the name of a file, which stands in its folder, on the disk. False: errno says why not.
bool syncName(const std::string& path);

// Whether a journal is open for writing, in this program or another.
bool isBeingWritten(const std::string& path);
// Writes down in a journal that nobody is writing that all of it was saved elsewhere.
JournalFault markJournalSaved(const std::string& path);

}  // namespace deckpipe
