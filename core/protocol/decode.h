// SPDX-License-Identifier: GPL-3.0-or-later
// From a classified frame to values, through the catalogue and nothing else.
//
//   const Classified what = classify(frame, time, book);
//   if (what.isDecoded())
//     for (const Field& field : messageOf(what.message).fields)
//       if (isPresent(field, frame)) use(field.key, valueOf(field, frame));
#pragma once

#include "base/part_state.h"
#include "bus/frame.h"
#include "protocol/catalogue.h"
#include "protocol/classify.h"
#include "protocol/value.h"

namespace deckpipe {

// Whether this frame has the field at all: reserved bits are no field, some belong to one length or one SDO
// object only, and some are left out where their bytes are missing.
bool isPresent(const Field& field, const Frame& frame);

// What a present field says. Null for 'not available', for what the rules call invalid, and for bytes that a
// shorter variant of the message does not have.
Value valueOf(const Field& field, const Frame& frame);

// The rules of protocol.md 1.2 and 1.4 for signed values, shared with the typed structs.
// `raw` 12 bits and the two status2: the state, and the angle in 0.1 degree where the state is Ok.
struct PositionReading {
  PositionState state = PositionState::Invalid;
  std::int16_t tenths = 0;
  friend constexpr bool operator==(const PositionReading&, const PositionReading&) = default;
};
constexpr PositionReading readPosition(unsigned raw, unsigned plus, unsigned minus) {
  constexpr unsigned kOff = 0, kOn = 1, kNotAvailable = 3, kNoAngle = 0xFFF;
  if (raw == kNoAngle) {
    if (plus == kOn && minus == kOff) return {PositionState::SensorError, 0};
    if (plus == kNotAvailable && minus == kNotAvailable) return {PositionState::NotFitted, 0};
    return {};
  }
  if (plus == kOn && minus == kOff) return {PositionState::Ok, static_cast<std::int16_t>(raw)};
  if (plus == kOff && minus == kOn)
    return {PositionState::Ok, static_cast<std::int16_t>(-static_cast<int>(raw))};
  if (plus == kOff && minus == kOff && raw == 0) return {PositionState::Ok, 0};
  return {};
}
// `raw` 10 bits: signed deflection in 0.1 %, or nothing where it is none.
constexpr std::optional<int> readAxis(unsigned raw, unsigned plus, unsigned minus) {
  constexpr unsigned kFullDeflection = 1000;
  if (raw > kFullDeflection || plus > 1 || minus > 1 || (plus == 1 && minus == 1)) return {};
  if (plus == 1) return static_cast<int>(raw);
  if (minus == 1) return -static_cast<int>(raw);
  return raw == 0 ? std::optional<int>(0) : std::nullopt;
}

}  // namespace deckpipe
