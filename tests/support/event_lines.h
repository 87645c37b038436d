// SPDX-License-Identifier: GPL-3.0-or-later
// Events as lines, so that a test compares lists and a failure shows what was told.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "state/event.h"

namespace deckpipe::test {

// "12.300 moved_address 1032AE100801035 128>129", without a PIN the address or node in hex; "+2" after the axis and
// side of what has them, "of 250?" after a load of an assumed rate, "(3)" after what was folded.
inline std::string lineOf(const Event& event) {
  char text[160];
  const auto ms = static_cast<long long>(event.time.ns / 1'000'000);
  std::snprintf(text, sizeof text, "%lld.%03lld ", ms / 1000, ms % 1000);
  std::string line = std::string(text) + std::string(kEvents[event.kind].key);
  if (!event.pin.isNull()) {
    line += " " + std::string(event.pin.text());
  } else if (event.node.value != 0 || event.address != kNullAddress) {
    std::snprintf(text, sizeof text, " %s%02X", event.node.value != 0 ? "node " : "",
                  event.node.value != 0 ? event.node.value : event.address.value);
    line += text;
  }
  if (event.axis != 0) line += (event.isPlus ? " +" : " -") + std::to_string(event.axis);
  const EventDetail detail = kEvents[event.kind].detail;
  if (detail == EventDetail::Name) {
    line += event.now != 0 ? " to another" : "";
  } else if (detail == EventDetail::Length) {
    line += " " + std::to_string(event.now / 1'000'000) + " ms";
  } else if (detail != EventDetail::None && detail != EventDetail::Flag) {
    line += " " + std::to_string(event.was) + ">" + std::to_string(event.now);
  }
  if (detail == EventDetail::Percent) {
    line += " of " + std::to_string(event.bitRate / 1000);
    if (event.isRateAssumed) line += "?";
  }
  if (event.since != kNotYet) {
    std::snprintf(text, sizeof text, " since %.3f", static_cast<double>(event.since.ns) / 1e9);
    line += text;
  }
  if (event.folded > 0) line += " (" + std::to_string(event.folded) + ")";
  return line;
}

inline std::vector<std::string> linesOf(const std::vector<Event>& events) {
  std::vector<std::string> lines;
  for (const Event& event : events) lines.push_back(lineOf(event));
  return lines;
}

}  // namespace deckpipe::test
