// SPDX-License-Identifier: GPL-3.0-or-later
// Arbitrary frames, one after another on one channel, through everything that takes a frame apart: no crash,
// no undefined behaviour, JSON that never breaks its line, and a state that agrees with its own copy.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "protocol/decode.h"
#include "protocol/encode.h"
#include "protocol/role_walk.h"
#include "report/decode_lines.h"
#include "state/state.h"

namespace {

using namespace deckpipe;

void demand(bool condition) {
  if (!condition) std::abort();
}

// What encodes at all must decode to the same values.
void demandRoundTrip(const Message& message, const Frame& frame) {
  std::vector<FieldValue> values;
  for (const Field& field : message.fields) {
    if (isPresent(field, frame)) values.push_back({field.key, valueOf(field, frame)});
  }
  const auto encoded = encode(message, values, frame.length, frame.data[0]);
  if (!encoded) return;
  Frame again = frame;
  again.data = encoded.value().data;
  for (const FieldValue& value : values) {
    for (const Field& field : message.fields) {
      if (field.key != value.key || !isPresent(field, again)) continue;
      // A deflection or an angle without a value has lost its raw bits; its state word may differ then.
      if (!value.value.isNull() && field.kind != Kind::PositionState)
        demand(valueOf(field, again) == value.value);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kStep = 4 + 1 + 1 + 8;
  static State state;  // large; made anew below
  state = State();
  RoleWalk roles;
  Instant now;
  std::string line;
  for (; size >= kStep; data += kStep, size -= kStep) {
    Frame frame;
    std::memcpy(&frame.id, data, 4);
    frame.length = data[4] % 9;
    now = now + Duration(std::int64_t{data[5]} * 2'000'000);
    std::memcpy(frame.data.data(), data + 6, frame.length);
    frame.stamp = now.ns;
    frame.channel = static_cast<std::uint8_t>(data[5] % 6);
    if (data[5] % 16 == 0) roles.sayDrive({frame.channel}, {data[6]}, data[7] % 2 == 0, now);
    const Classified what = roles.next(frame, now);
    for (const DecodeFormat format : {DecodeFormat::JsonLines, DecodeFormat::Csv, DecodeFormat::Text}) {
      line.clear();
      appendDecoded(line, format, frame, "can0", what);
      demand(line.find('\n') == line.size() - 1);
    }
    if (what.isDecoded()) demandRoundTrip(messageOf(what.message), frame);
    state.apply(frame, now);
  }
  state.timeCame(now + 10s);
  demand(State(state) == state);
  return 0;
}
