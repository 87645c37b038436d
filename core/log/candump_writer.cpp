// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstring>

#include "log/candump.h"

namespace deckpipe {
namespace {

// A line of either form needs less, its name apart.
constexpr std::size_t kLineRoom = 128;
constexpr std::size_t kLongestName = 63;

struct Writer {
  char* p;

  void character(char c) { *p++ = c; }
  void text(std::string_view t) { p = std::copy(t.begin(), t.end(), p); }
  void hex(std::uint32_t number, unsigned digits) {
    for (unsigned i = digits; i-- > 0;) *p++ = "0123456789ABCDEF"[number >> 4 * i & 0xF];
  }
  void decimal(std::uint64_t number, unsigned digits) {
    for (unsigned i = digits; i-- > 0; number /= 10) p[i] = static_cast<char>('0' + number % 10);
    p += digits;
  }
  void name(std::string_view n) {
    char* const first = p;
    if (n.empty()) n = kUnnamedInterface;
    for (const char c : n.substr(0, kLongestName)) *p++ = c > ' ' && c <= '~' ? c : '_';
    if (n.front() == '(' || n.front() == '#' || n.front() == '<') *first = '_';
  }
  void identifier(const Frame& frame) {
    if (frame.isError()) {
      hex(frame.id & (kErrorBit | kIdMask), 8);
    } else if (frame.isExtended()) {
      hex(frame.identifier(), 8);
    } else {
      hex(frame.identifier() & 0x7FF, 3);
    }
  }
};

void logForm(const Frame& frame, std::string_view name, Writer& w) {
  // Unsigned, as the smallest stamp has no negative.
  const auto stamp = static_cast<std::uint64_t>(frame.stamp);
  const std::uint64_t ns = frame.stamp < 0 ? 0 - stamp : stamp;
  w.text(frame.stamp < 0 ? "(-" : "(");
  w.decimal(ns / 1'000'000'000, 10);
  w.character('.');
  w.decimal(ns / 1000 % 1'000'000, 6);
  w.text(") ");
  w.name(name);
  w.character(' ');
  w.identifier(frame);
  w.character('#');
  if (frame.isRemote()) {
    w.character('R');
    if (frame.length > 0) w.decimal(frame.length, 1);
  }
  for (const std::uint8_t byte : frame.bytes()) w.hex(byte, 2);
  if (frame.flags & Frame::kSent) w.text(" T");
}

void screenForm(const Frame& frame, std::string_view name, Writer& w) {
  w.text("  ");
  w.name(name);
  if (frame.flags & Frame::kSent) w.text("  TX - -");
  w.text("  ");
  w.identifier(frame);
  w.text("   [");
  w.decimal(frame.length, 1);
  w.text("] ");
  for (const std::uint8_t byte : frame.bytes()) {
    w.character(' ');
    w.hex(byte, 2);
  }
  if (frame.isRemote()) w.text(" remote request");
  if (frame.isError()) w.text("  ERRORFRAME");
}

}  // namespace

std::string candumpName(std::string_view channelName) {
  std::array<char, kLongestName + 1> name;
  Writer w{name.data()};
  w.name(channelName);
  return {name.data(), w.p};
}

void writeCandump(const Frame& frame, std::string_view channelName, std::string& out) {
  std::array<char, kLineRoom + kLongestName + 1> line;
  Writer w{line.data()};
  if (frame.hasStamp()) {
    logForm(frame, channelName, w);
  } else {
    screenForm(frame, channelName, w);
  }
  w.character('\n');
  out.append(line.data(), static_cast<std::size_t>(w.p - line.data()));
}

}  // namespace deckpipe
