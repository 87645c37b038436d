// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/decode_lines.h"

#include <optional>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/decode.h"
#include "report/json.h"
#include "report/trace_text.h"

namespace deckpipe {
namespace {

struct Ends {
  std::optional<std::uint8_t> source, destination, node;
  std::optional<std::uint32_t> pgn;
};

// Who an identifier speaks of. An error frame's identifier is an error class and speaks of nobody.
Ends endsOf(const Frame& frame) {
  Ends ends;
  if (frame.isError()) return ends;
  if (frame.isExtended()) {
    const J1939Id id = J1939Id::of(frame.identifier());
    ends.source = id.source.value;
    if (id.hasDestination()) ends.destination = id.destination.value;
    ends.pgn = id.pgn;
  } else if (const CobId cob = CobId::of(frame.identifier()); cob.hasNode()) {
    ends.node = cob.node.value;
  }
  return ends;
}

void appendBytes(std::string& out, std::span<const std::uint8_t> bytes) {
  std::uint64_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8 | byte;
  appendHex(out, value, static_cast<unsigned>(2 * bytes.size()));
}

// Keys of the catalogue are plain: quoting is all they need, in one piece.
void appendQuotedKey(std::string& out, std::string_view key) {
  char text[40];
  text[0] = '"';
  const std::size_t length = key.copy(text + 1, sizeof text - 3);
  text[length + 1] = '"';
  text[length + 2] = ':';
  out.append(text, length + 3);
}

void appendFields(std::string& out, const Frame& frame, const Message& message) {
  out += '{';
  for (const Field& field : message.fields) {
    if (!isPresent(field, frame)) continue;
    if (out.back() != '{') out += ',';
    appendQuotedKey(out, field.key);
    appendJsonValue(out, valueOf(field, frame));
  }
  out += '}';
}

std::string_view messageKey(const Classified& what) {
  if (what.malformed) return "malformed";
  return what.isDecoded() ? messageOf(what.message).key : std::string_view();
}

template <typename T>
void appendKeyed(std::string& out, std::string_view key, const std::optional<T>& number) {
  if (!number) return;
  out += key;
  appendJsonNumber(out, *number);
}

// Null for none.
void appendWord(std::string& out, std::string_view word) {
  word.empty() ? void(out += "null") : appendJsonString(out, word);
}

void appendJsonLine(std::string& out, const Frame& frame, std::string_view channel, const Classified& what) {
  const Ends ends = endsOf(frame);
  out += "{\"t\":";
  appendJsonSeconds(out, frame.stamp);
  out += ",\"channel\":";
  appendJsonString(out, channel);
  out += ",\"id\":\"";
  appendIdentifier(out, frame);
  out += "\",\"data\":\"";
  appendBytes(out, frame.bytes());
  out += "\",\"family\":";
  appendWord(out, familyKey(what.family));
  out += ",\"message\":";
  const std::string_view key = messageKey(what);
  appendWord(out, key);
  appendKeyed(out, ",\"source\":", ends.source);
  appendKeyed(out, ",\"destination\":", ends.destination);
  appendKeyed(out, ",\"node\":", ends.node);
  if (key.empty()) {
    appendKeyed(out, ",\"pgn\":", ends.pgn);
    std::string name;
    appendGroupName(name, frame, what);
    if (!name.empty()) {
      out += ",\"pgn_name\":";
      appendJsonString(out, name);
    }
  }
  if (frame.isRemote()) out += ",\"remote\":true";
  if (frame.isError()) out += ",\"error\":true";
  if (what.malformed) {
    out += ",\"reason\":";
    appendJsonString(out, malformedReason(what, frame.length));
  }
  out += ",\"fields\":";
  if (what.isDecoded()) {
    appendFields(out, frame, messageOf(what.message));
  } else {
    out += "null";
  }
  out += "}\n";
}

void appendCsvCell(std::string& out, std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

void appendCsvLine(std::string& out, const Frame& frame, std::string_view channel, const Classified& what) {
  const Ends ends = endsOf(frame);
  const auto number = [&](const auto& value) {
    out += ',';
    if (value) appendJsonNumber(out, *value);
  };
  if (frame.hasStamp()) appendJsonSeconds(out, frame.stamp);
  out += ',';
  appendCsvCell(out, channel);
  out += ',';
  appendIdentifier(out, frame);
  out += ',';
  appendBytes(out, frame.bytes());
  out += ',';
  out += familyKey(what.family);
  out += ',';
  out += messageKey(what);
  number(ends.source);
  number(ends.destination);
  number(ends.node);
  out += ',';
  if (what.isDecoded()) {
    std::string fields;
    appendFields(fields, frame, messageOf(what.message));
    appendCsvCell(out, fields);
  }
  out += '\n';
}

}  // namespace

std::string_view familyKey(Family family) {
  constexpr EnumTable<Family, std::string_view> kKeys{{
      {Family::None, ""},
      {Family::J1939, "j1939"},
      {Family::Akron, "akron"},
      {Family::Copley, "copley"},
      {Family::Canopen, "canopen"},
      {Family::Presumed, "presumed"},
      {Family::Ambiguous, "ambiguous"},
      {Family::Other, "other"},
  }};
  return kKeys[family];
}

std::string malformedReason(const Classified& what, unsigned length) {
  std::string text;
  for (unsigned n = 0; n <= 8; ++n) {
    if (!allows(what.wanted, n)) continue;
    if (!text.empty()) text += " or ";
    appendJsonNumber(text, n);
  }
  text += what.wanted == lengths(1) ? " byte wanted, " : " bytes wanted, ";
  appendJsonNumber(text, length);
  return text + " came";
}

std::string_view decodeHeader(DecodeFormat format) {
  return format == DecodeFormat::Csv ? "t,channel,id,data,family,message,source,destination,node,fields\n"
                                     : "";
}

void appendDecoded(std::string& out, DecodeFormat format, const Frame& frame, std::string_view channel,
                   const Classified& what) {
  switch (format) {
    case DecodeFormat::JsonLines: appendJsonLine(out, frame, channel, what); break;
    case DecodeFormat::Csv: appendCsvLine(out, frame, channel, what); break;
    case DecodeFormat::Text: appendTraceLine(out, frame, channel, what); break;
  }
}

}  // namespace deckpipe
