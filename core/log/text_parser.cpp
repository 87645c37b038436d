// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/text_parser.h"

#include <algorithm>

#include "log/line_ends.h"

namespace deckpipe {
namespace {

// A log has a few interfaces; a parser that has seen more than this forgets them between blocks.
constexpr std::size_t kManyNames = 200;

}  // namespace

const char* TextParser::readUsual(const char* p, const char*, const char*, Frame*&, const Frame*) {
  return p;
}

void TextParser::learn(std::string_view, const TextLine&, LocalChannel) {}

void TextParser::parse(const char* begin, const char* end, const char* readable, TextBlock& block) {
  block.count = 0;
  block.lines = 0;
  block.skipped.clear();
  block.channels.clear();
  block.header.clear();
  block.endsOpen = block.isLastFrameOpen = false;
  m_unnamedUsed = false;
  if (m_channels.size() > kManyNames) {
    m_channels.clear();
    forget();
  }

  const char* p = begin;
  while (p < end) {
    if (block.count == block.frames.size()) block.frames.resize(std::max<std::size_t>(block.count * 2, 512));
    Frame* const first = block.frames.data() + block.count;
    const Frame* const full = block.frames.data() + block.frames.size();
    Frame* to = first;
    p = readUsual(p, end, readable, to, full);
    block.count += static_cast<std::size_t>(to - first);
    block.lines += static_cast<std::size_t>(to - first);
    if (p >= end || to == full) continue;

    ++block.lines;
    const auto known = static_cast<std::size_t>(readable - p);
    const char* const lineEnd = findLineEnd(p, p + std::min(known, kMaxTextLine + 1));
    if (lineEnd == nullptr && known > kMaxTextLine) {
      block.skipped.add(block.lines, Skipped::LineTooLong);
      const char* const skipped = findLineEnd(p, end);
      p = skipped != nullptr ? skipped + 1 : end;
      continue;
    }
    std::string_view line(p, static_cast<std::size_t>((lineEnd != nullptr ? lineEnd : readable) - p));
    const bool hasEnd = lineEnd != nullptr || line.ends_with('\r');
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::size_t before = block.count;
    readOther(line, block);
    block.endsOpen = !hasEnd;
    block.isLastFrameOpen = !hasEnd && block.count > before;
    p = lineEnd != nullptr ? lineEnd + 1 : readable;
  }
}

void TextParser::readOther(std::string_view text, TextBlock& block) {
  const TextLine line = readLine(text);
  switch (line.kind) {
    case TextLine::Kind::Nothing: return;
    case TextLine::Kind::Skipped: block.skipped.add(block.lines, line.reason); return;
    case TextLine::Kind::Header: block.header = line.interface; return;
    case TextLine::Kind::Frame: break;
  }
  LocalChannel number = kUnnamedChannel;
  if (!line.interface.empty()) {
    number = channel(line.interface, block);
    learn(text, line, number);
  } else if (!block.header.empty()) {
    number = channel(block.header, block);
  } else if (!m_unnamedUsed) {
    m_unnamedUsed = true;
    block.channels.emplace_back(kUnnamedChannel, std::string());
  }
  if (line.isFractionLost) block.skipped.add(block.lines, Skipped::Fraction);
  Frame& frame = block.frames[block.count++];
  frame = line.frame;
  frame.channel = static_cast<std::uint8_t>(number);
  frame.spare = static_cast<std::uint8_t>(number >> 8);
}

LocalChannel TextParser::channel(std::string_view name, TextBlock& block) {
  const auto [place, isNew] = m_channels.try_emplace(std::string(name), LocalChannel(m_channels.size()));
  if (isNew) block.channels.emplace_back(place->second, place->first);
  return place->second;
}

}  // namespace deckpipe
