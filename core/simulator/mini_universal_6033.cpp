// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/mini_universal_6033.h"

namespace deckpipe::simulator {
namespace {

// The manual names no 6033's numbers; these are the simulator's own.
constexpr PcodeVersion kRiserPcode{6033, 1, 0x0102};
constexpr ConfigVersion kRiserConfig{60330001, 0x0100};

constexpr int kTravel = 1'000'000;
constexpr int kStep =
    static_cast<int>(kTravel * MiniUniversal6033::kStatusPeriod / MiniUniversal6033::kTravelTime) + 1;

}  // namespace

MiniUniversal6033::MiniUniversal6033(std::string_view pin, std::uint64_t seed)
    : Device(identityOf(pin, kRiserPcode, kRiserConfig), kStatusPeriod, seed),
      m_riser({0, kTravel, kStep, kStep}, 0) {}

void MiniUniversal6033::started(Instant) {
  m_inputs.clear();
  m_before = {};
  m_riser.drive(0);
}

void MiniUniversal6033::heard(Instant now, const J1939Id& id, const Frame& frame) {
  m_inputs.expire(now);
  m_inputs.received(now, id, frame);
  const Functions functions = m_inputs.demand().functions;
  const Functions pressed = functions - m_before;
  m_before = functions;
  if (misbehaviour().enableOff) return;
  if (pressed.has(Function::Deploy)) m_riser.drive(1000);
  if (pressed.has(Function::Stow)) m_riser.drive(-1000);
}

void MiniUniversal6033::tick(Instant now) {
  m_inputs.expire(now);
  m_before = m_before & m_inputs.demand().functions;
  if (misbehaviour().enableOff) m_riser.halt();
  m_riser.step();
  MiniOutputs outputs;
  outputs.riserRetracted = isRetracted();
  outputs.riserExtended = isExtended();
  outputs.deviceFaulted = misbehaviour().faultBits != 0;
  outputs.deviceActive = !misbehaviour().enableOff;
  broadcast(now, MessageId::MiniDigitalOutputs, outputs.encode());
}

}  // namespace deckpipe::simulator
