// SPDX-License-Identifier: GPL-3.0-or-later
// What a text format of logs is made of: a TextParser that says what one line means. Everything else is the
// same for all of them: files in blocks on two threads (text_reader.h), pipes (text_stream.h), line numbers
// and channels (text_appender.h). A format derives from TextParser, is one file, and has one entry in the
// table of formats (log_format.h).
//
// Each thread of a reading has a parser of its own, since a parser remembers names and may remember more.
//  1. What a line means follows from the line alone. What a parser remembers changes how fast it is, never
//     what it says.
//  2. A block owns the lines that begin in it, however far they run on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bus/frame.h"
#include "log/skipped.h"

namespace deckpipe {

// A longer line is not a line of any log: the longest, CAN XL in candump's form with separators, has some
// 6,200 bytes.
inline constexpr std::size_t kMaxTextLine = 8192;

// Frames of logs that name no interface anywhere are on this channel.
inline constexpr std::string_view kUnnamedInterface = "can0";

struct TextLine {
  enum class Kind : std::uint8_t {
    Nothing,  // blank, a comment, words about the frame before
    Frame,    // frame (its channel is 0) and interface, empty where the line names none
    Header,   // interface: that of the lines after it which name none
    Skipped,  // reason
  };
  Kind kind = Kind::Nothing;
  Skipped reason = Skipped::Layout;
  Frame frame{};
  std::string_view interface {};
  bool isFractionLost = false;  // of a frame: its time is good to the second only
};

// Channels are numbered by the parser; the number stands in a frame's channel (low byte) and spare (high
// byte) until TextAppender puts the store's index there.
using LocalChannel = std::uint16_t;
// Of frames whose line names no interface; what that means depends on the blocks before.
inline constexpr LocalChannel kUnnamedChannel = 0xFFFF;

struct TextBlock {
  std::vector<Frame> frames;  // only the first `count` are meant: the vector is never shrunk between blocks
  std::size_t count = 0;
  std::uint64_t lines = 0;
  SkippedPlaces skipped;  // line numbers from 1 at the block's start
  // Channels new to the parser, and the unnamed one, in the order in which the block uses them.
  std::vector<std::pair<LocalChannel, std::string>> channels;
  std::string header;            // the interface that the last header line names; empty without one
  bool endsOpen = false;         // the text ends here, and its last line has no line end
  bool isLastFrameOpen = false;  // ... and made the last frame

  // Whether a line of it was understood, so that the text is a log of this format.
  bool isUnderstood() const { return count > 0 || skipped.understood() > 0; }
};

class TextParser {
 public:
  virtual ~TextParser() = default;

  // The lines that begin in [begin, end). `readable` is where the text or what is known of it ends; if it
  // does not end there, kMaxTextLine bytes beyond `end` have to be known.
  void parse(const char* begin, const char* end, const char* readable, TextBlock& block);

 protected:
  // `line` without its line end. What `interface` views must live until the next call.
  virtual TextLine readLine(std::string_view line) = 0;

  // For formats with a faster way through usual lines. Reads whole lines from `p` on into `to` and onwards,
  // as long as they are usual, `p` is before `end` and `to` before `full`; returns the place behind the last.
  // It may look at anything before `readable`, and must say what readLine() would.
  virtual const char* readUsual(const char* p, const char* end, const char* readable, Frame*& to,
                                const Frame* full);
  // readLine() took this line for a frame and named its interface, which has this number.
  virtual void learn(std::string_view line, const TextLine& read, LocalChannel channel);
  // The numbers of channels begin anew.
  virtual void forget() {}

 private:
  void readOther(std::string_view line, TextBlock& block);
  LocalChannel channel(std::string_view name, TextBlock& block);

  std::unordered_map<std::string, LocalChannel> m_channels;
  bool m_unnamedUsed = false;  // in this block, before any header
};

}  // namespace deckpipe
