// SPDX-License-Identifier: GPL-3.0-or-later
// candump logs, read and written (the forms: candump_line.h). The session and the headless tool open files
// with readCandump(), read pipes with CandumpStream, and save with writeCandump().
//
// Blank lines and comments are skipped, everything else that is no frame is reported with its line and
// reason, and reading goes on. A text without a readable line among those that begin in its first 64 kB, and
// with an unreadable one, is no log: one error, no list. An empty text is an empty log. Frames, channel
// order, reports and summary do not depend on threads, block size or how a stream is cut.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "bus/frame.h"
#include "log/frame_store.h"
#include "log/reading.h"
#include "log/unkept.h"

namespace deckpipe {

// Frames of logs that name no interface anywhere are on this channel.
inline constexpr std::string_view kUnnamedInterface = "can0";

// How much of a text decides whether it is a candump log at all: the lines that begin in so many bytes.
// Whoever hands a head to looksLikeCandump() has kCandumpHead bytes of it, or all.
inline constexpr std::size_t kCandumpSniff = 64 * 1024;
inline constexpr std::size_t kCandumpHead = kCandumpSniff + 8192;
bool looksLikeCandump(std::string_view head);

Result<ReadSummary, ReadError> readCandump(const std::string& path, FrameStore& store, UnkeptList& unkept,
                                           const ReadOptions& options = {});
Result<ReadSummary, ReadError> readCandumpText(std::string_view text, FrameStore& store, UnkeptList& unkept,
                                               const ReadOptions& options = {});

// For a pipe: bytes as they come. Whole lines are in the store when feed() returns.
class CandumpStream {
 public:
  CandumpStream(FrameStore& store, UnkeptList& unkept);
  ~CandumpStream();
  CandumpStream(const CandumpStream&) = delete;
  CandumpStream& operator=(const CandumpStream&) = delete;

  // False once it is clear that nothing more will be taken; finish() then says why.
  bool feed(std::span<const char> bytes);
  // The end of the text: a last line without line feed is read now. Once.
  Result<ReadSummary, ReadError> finish();

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

// One line of log form with its line feed, appended to `out`: what readCandump() makes the same frame of, but
// for kConfirmed (the form knows sent or not) and kTimeJump (which the store works out). The stamp has six
// decimals, as can-utils reads nine as if they were microseconds; what is finer is cut off. A frame without a
// stamp becomes a line of the screen form, the only one that programs read without. Of a name, what would not
// be read back becomes '_'.
void writeCandump(const Frame& frame, std::string_view channelName, std::string& out);

}  // namespace deckpipe
