// SPDX-License-Identifier: GPL-3.0-or-later
// What all readers of log files share: how they are asked and how they end. Whoever opens a log (session, the
// headless tool) calls a reader on a thread of its own and draws from the store meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/enum_table.h"

namespace deckpipe {

// So much of a log's beginning, or all of it, tells its format.
inline constexpr std::size_t kSniffBytes = 72 * 1024;
// Open: what was seen so far does not tell yet.
enum class Sniff : std::uint8_t { No, Open, Yes };

struct ReadProgress {
  std::uint64_t bytesDone = 0;
  std::uint64_t bytesTotal = 0;
  std::uint64_t frames = 0;
};

struct ReadOptions {
  // Of a text: its times are differences, each to the frame before, and are added up (delta_times.h).
  bool addsUpTimes = false;
  unsigned threads = 1;  // 1 or 2; the outcome is the same
  // Called after each block that was published, never twice at once but perhaps from a reader's own thread.
  // False ends the reading; what was published stays.
  std::function<bool(const ReadProgress&)> onProgress;
  // How much is read, published and reported at a time. The first block is never larger than 64 kB, so that
  // the first rows of any log are there at once. Tests make it small.
  std::size_t blockBytes = 256 * 1024;
};

// Why the file beside a log that holds its notes was not used (sidecar.h).
struct SidecarFault {
  enum class Kind : std::uint8_t {
    CannotRead,    // detail: the system's words
    NoSidecar,     // its first line is that of no such file
    NewerVersion,  // of Deckpipe wrote it
    BadLine,       // no version writes such a line
    Cut,           // its end is missing
    Changed,       // not as it was written
    OtherCount,    // the log has another number of frames
    OtherFrame,    // a frame of the log is another
  };
  Kind kind = Kind::CannotRead;
  std::uint64_t line = 0;  // from 1; 0: none
  std::string path{};
  std::string detail{};

  friend bool operator==(const SidecarFault&, const SidecarFault&) = default;
};

// English, for the headless tool; windows translate the kind.
constexpr std::string_view sidecarFaultText(SidecarFault::Kind kind) {
  switch (kind) {
    case SidecarFault::Kind::CannotRead:
      return "expected a file that begins with 'Deckpipe notes 1', which cannot be read";
    case SidecarFault::Kind::NoSidecar: return "expected 'Deckpipe notes 1'";
    case SidecarFault::Kind::NewerVersion: return "written by a newer version of Deckpipe";
    case SidecarFault::Kind::BadLine: return "not a line that Deckpipe writes";
    case SidecarFault::Kind::Cut: return "its end is missing";
    case SidecarFault::Kind::Changed: return "it was changed since it was written";
    case SidecarFault::Kind::OtherCount: return "the log has another number of frames";
    case SidecarFault::Kind::OtherFrame: return "the log has another frame there";
  }
  return {};
}

// Of a recording: what could not be read with something readable behind it.
struct Damage {
  std::uint64_t places = 0;
  std::uint64_t bytes = 0;
  std::uint64_t firstAt = 0;  // byte of the file, from 0
  std::uint64_t frames = 0;   // missing at least: what stands behind a damaged place tells how many
  bool isOpen = false;        // nothing behind the last damaged place tells how many are missing there

  friend bool operator==(const Damage&, const Damage&) = default;
};

// What the last line of a text is, whose end is a line end in every whole file.
enum class LastLine : std::uint8_t {
  Whole,
  Open,     // it has no line end, and others have one: it may be cut. What it says is in the log
  LeftOut,  // the same, and its frame has fewer bytes than the same message had before: it is not in the log
};

template <>
inline constexpr LastLine kLastOf<LastLine> = LastLine::LeftOut;
// In JSON: frozen contract.
inline constexpr EnumTable<LastLine, std::string_view> kLastLineKeys{{
    {LastLine::Whole, "whole"},
    {LastLine::Open, "no_end"},
    {LastLine::LeftOut, "left_out"},
}};

struct ReadSummary {
  std::uint64_t frames = 0;  // put into the store
  std::uint64_t lines = 0;   // of a text format
  bool cancelled = false;
  bool isOwn = false;                          // of Deckpipe's own format: a recording
  bool mayHaveSidecar = false;                 // its notes are kept in a file beside it
  bool hasSidecar = false;                     // its notes came from the file beside it, after its frames
  std::optional<SidecarFault> sidecarFault{};  // the log was read without its notes
  LastLine lastLine = LastLine::Whole;         // of a text format
  std::uint64_t newerParts = 0;  // that a newer version of Deckpipe wrote, and that were left out
  // Of a recording:
  std::uint64_t cutBytes = 0;  // at its end, that are not whole and were left out
  bool isOpenEnded = false;    // it has no end: it still goes on, or its end was lost
  bool goesOn = false;         // it was being written when it was opened
  Damage damage{};

  // Places at which something was left out or lost. The end of a recording that still goes on is none.
  std::uint64_t missing() const {
    std::uint64_t places = damage.places + newerParts;
    for (const bool is :
         {lastLine == LastLine::LeftOut, cutBytes > 0, sidecarFault.has_value(), isOpenEnded && !goesOn})
      places += is ? 1 : 0;
    return places;
  }
  bool isWhole() const { return missing() == 0; }

  friend bool operator==(const ReadSummary&, const ReadSummary&) = default;
};

struct ReadError {
  enum class Kind : std::uint8_t {
    CannotOpen,     // detail: the system's words
    CannotRead,     // detail: the system's words; what was read before is in the store
    UnknownFormat,  // its content is that of no log in the table of formats
    NewerVersion,   // a newer version of Deckpipe wrote it; detail: which
    NoPipe,         // a log of this format can be read from a file only
    Damaged,        // its beginning, and nothing behind that is whole
    StoreFull,      // neither memory nor disk for more; what was read before is in the store
  };
  Kind kind = Kind::CannotOpen;
  std::string detail{};
  std::string format{};  // name of the format that the content seems to be; empty if it seems none

  friend bool operator==(const ReadError&, const ReadError&) = default;
};

// English, for the headless tool; windows translate the kind.
constexpr std::string_view readErrorText(ReadError::Kind kind) {
  switch (kind) {
    case ReadError::Kind::CannotOpen: return "cannot be opened";
    case ReadError::Kind::CannotRead: return "cannot be read further";
    case ReadError::Kind::UnknownFormat: return "not a log of a known format";
    case ReadError::Kind::NewerVersion: return "written by a newer version of Deckpipe";
    case ReadError::Kind::NoPipe: return "a log of this format is read from a file only, not from a pipe";
    case ReadError::Kind::Damaged: return "its beginning is damaged, and no part behind it is whole";
    case ReadError::Kind::StoreFull: return "no room for more frames, neither in memory nor on disk";
  }
  return {};
}

}  // namespace deckpipe
