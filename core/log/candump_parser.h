// SPDX-License-Identifier: GPL-3.0-or-later
// CandumpParser: turns a piece of a candump log into frames. The readers in candump.h hand it block after
// block; each of their threads has one of its own, because it remembers the names and the second it saw last.
//
// Invariants:
//  1. readCandumpLine() is what a line means. The fast path takes only what that function would read the same
//     way, and leaves every other line to it.
//  2. A block owns the lines that begin in it, however far they run on.
//  3. What a parser remembers changes how fast it is, never what it says.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bus/frame.h"
#include "log/candump_line.h"
#include "log/unkept.h"

namespace deckpipe {

// Channels are numbered by the parser; the number stands in a frame's channel (low byte) and spare (high
// byte) until CandumpAppender puts the store's index there.
using LocalChannel = std::uint16_t;
// Of frames whose line names no interface; what that means depends on the blocks before.
inline constexpr LocalChannel kUnnamedChannel = 0xFFFF;

struct CandumpBlock {
  std::vector<Frame> frames;  // only the first `count` are meant: the vector is never shrunk between blocks
  std::size_t count = 0;
  std::uint64_t lines = 0;
  UnkeptPlaces unkept;  // line numbers from 1 at the block's start
  // Channels new to the parser, and the unnamed one, in the order in which the block uses them.
  std::vector<std::pair<LocalChannel, std::string>> channels;
  std::string header;  // the interface that the last header line names; empty without one
};

class CandumpParser {
 public:
  explicit CandumpParser(bool fastPath = true) : m_fastPath(fastPath) {}

  // The lines that begin in [begin, end). `readable` is where the text or what is known of it ends; if it
  // does not end there, kMaxCandumpLine bytes beyond `end` have to be known.
  void parse(const char* begin, const char* end, const char* readable, CandumpBlock& block);

 private:
  const char* fastFrame(const char* p, Frame& frame);
  void slowLine(std::string_view line, CandumpBlock& block);
  LocalChannel channel(std::string_view name, CandumpBlock& block);
  void learnSecond(std::string_view line, const Frame& frame);
  void learnName(std::string_view name, LocalChannel channel);

  const bool m_fastPath;

  // "(1700000000." as two words, so that a stamp within the same second costs two comparisons.
  std::array<std::uint64_t, 2> m_prefix{1, 1};
  std::array<std::uint64_t, 2> m_prefixMask{~0ull, ~0ull};
  std::size_t m_prefixLength = 0;
  std::int64_t m_second = 0;  // in ns

  struct Name {
    std::uint64_t letters = 0;  // of a name of up to 7 letters; 0 where the place is free
    LocalChannel channel = 0;
  };
  std::array<Name, 16> m_shortNames;
  std::size_t m_nameLength = 4;  // of the line before

  std::unordered_map<std::string, LocalChannel> m_channels;
  bool m_unnamedUsed = false;  // in this block, before any header
  std::string m_scratch;
};

}  // namespace deckpipe
