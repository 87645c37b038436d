// SPDX-License-Identifier: GPL-3.0-or-later
// CandumpParser: candump logs as a text format. readCandumpLine() is what a line means. The fast path takes
// only what that function would read the same way, and leaves every other line to it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "log/text_parser.h"

namespace deckpipe {

class CandumpParser final : public TextParser {
 public:
  explicit CandumpParser(bool fastPath = true) : m_fastPath(fastPath) {}

 private:
  TextLine readLine(std::string_view line) override;
  const char* readUsual(const char* p, const char* end, const char* readable, Frame*& to,
                        const Frame* full) override;
  void learn(std::string_view line, const TextLine& read, LocalChannel channel) override;
  void forget() override { m_shortNames = {}; }

  const char* fastFrame(const char* p, Frame& frame);
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

  std::string m_scratch;
};

}  // namespace deckpipe
