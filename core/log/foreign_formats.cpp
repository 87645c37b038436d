// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/foreign_formats.h"

#include <algorithm>
#include <string>

namespace deckpipe {
namespace {

using namespace std::string_view_literals;

struct Known {
  std::string_view sign;
  std::string_view name;
};

// What a file begins with.
constexpr Known kBeginnings[] = {
    {"\x1F\x8B"sv, "gzip"},
    {"LOGG"sv, "Vector BLF"},
    {"MDF     "sv, "MDF"},
    {"UnFinMF "sv, "MDF"},
    {"\xD4\xC3\xB2\xA1"sv, "pcap"},
    {"\xA1\xB2\xC3\xD4"sv, "pcap"},
    {"\x4D\x3C\xB2\xA1"sv, "pcap"},
    {"\xA1\xB2\x3C\x4D"sv, "pcap"},
    {"\x0A\x0D\x0D\x0A"sv, "pcapng"},
    {"Generic File"sv, "CSS MFC, MFE or MFM"},
};

// What stands near the beginning of a text, in lower case.
constexpr Known kWords[] = {
    {";$fileversion="sv, "PEAK TRC"},
    {"pcan-net:"sv, "PEAK TRC"},  // 1.0 has no version
    {"base hex"sv, "Vector ASC"},
    {"base dec"sv, "Vector ASC"},
    {"internal events logged"sv, "Vector ASC"},
    {"begin triggerblock"sv, "Vector ASC"},
    {"time stamp,id,extended"sv, "SavvyCAN CSV"},
};

}  // namespace

std::string_view foreignFormat(std::string_view head) {
  head = head.substr(0, kForeignBytes);
  for (const Known& known : kBeginnings) {
    if (head.starts_with(known.sign)) return known.name;
  }
  std::string text(head);
  std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  for (const Known& known : kWords) {
    if (text.find(known.sign) != std::string::npos) return known.name;
  }
  return {};
}

}  // namespace deckpipe
