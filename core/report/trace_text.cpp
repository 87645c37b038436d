// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/trace_text.h"

#include "bus/j1939.h"
#include "protocol/decode.h"
#include "protocol/j1939_names.h"
#include "report/decode_lines.h"
#include "report/json.h"

namespace deckpipe {

namespace {

void appendName(std::string& out, std::string_view name) {
  if (!name.empty()) out.append(" (").append(name).append(")");
}

}  // namespace

void appendIdentifier(std::string& out, const Frame& frame) {
  if (frame.isError()) {
    appendHex(out, frame.identifier() | kErrorBit, 8);
  } else {
    appendHex(out, frame.identifier(), frame.isExtended() ? 8 : 3);
  }
}

void appendGroupName(std::string& out, const Frame& frame, const Classified& what) {
  if (frame.isError() || frame.isRemote() || !frame.isExtended() || what.family != Family::None) return;
  if (const auto* group = j1939::standardGroupOf(J1939Id::of(frame.identifier()).pgn)) {
    out += group->name;
    appendName(out, group->acronym);
  }
}

void appendSummary(std::string& out, const Frame& frame, const Classified& what) {
  if (what.malformed) {
    out += malformedReason(what, frame.length);
    return;
  }
  if (!what.isDecoded()) {
    appendGroupName(out, frame, what);
    return;
  }
  bool first = true;
  for (const Field& field : messageOf(what.message).fields) {
    if (!isPresent(field, frame)) continue;
    if (!first) out += ", ";
    first = false;
    out += field.key;
    out += ' ';
    const Value value = valueOf(field, frame);
    if (value.isNull()) {
      out += '-';
    } else {
      const std::size_t before = out.size();
      appendText(out, value);
      if (out.size() == before) out += "none";
      if (value.type() == Value::Type::Integer) appendName(out, nameOf(field.names, value.number()));
    }
  }
}

void appendTraceLine(std::string& out, const Frame& frame, std::string_view channel, const Classified& what) {
  // The next column begins where this one has been so wide.
  auto padTo = [&out, start = out.size()](std::size_t width) mutable {
    while (out.size() < start + width) out += ' ';
    start = out.size();
  };
  if (frame.hasStamp()) {
    appendJsonSeconds(out, frame.stamp);
  } else {
    out += '-';
  }
  padTo(19);
  out.append(channel) += ' ';
  padTo(8);
  appendIdentifier(out, frame);
  padTo(10);
  out += '[';
  appendJsonNumber(out, frame.length);
  out += "] ";
  padTo(0);
  if (frame.isRemote()) out += "remote";
  for (const std::uint8_t byte : frame.bytes()) {
    appendHex(out, byte, 2);
    out += ' ';
  }
  padTo(25);
  out += frame.isError() ? "error" : familyKey(what.family);
  padTo(10);
  out += what.malformed ? "malformed" : what.isDecoded() ? messageOf(what.message).key : "";
  padTo(24);
  appendSummary(out, frame, what);
  out.erase(out.find_last_not_of(' ') + 1);
  out += '\n';
}

}  // namespace deckpipe
