// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/io_module_6039.h"

namespace deckpipe::simulator {
namespace {

// The manual names no 6039's numbers; these are the simulator's own.
Identity ioModule(std::uint32_t identityNumber) {
  Identity result;
  result.name = akronName(identityNumber);
  result.model = "6039 CAN I/O Module";
  result.pcode = {6039, 1, 0x0100};
  result.config = {60390001, 0x0100};
  return result;
}

}  // namespace

IoModule6039::IoModule6039(std::uint32_t identityNumber, std::uint64_t seed)
    : Device(ioModule(identityNumber), kStatusPeriod, seed), m_random(seed + 2) {}

void IoModule6039::setInputs(const DigitalInputs& inputs) {
  m_inputs = inputs;
  m_scripted = false;
}

void IoModule6039::started(Instant now) { m_changeAt = now + m_random.between(5, 20) * Duration(1s); }

void IoModule6039::tick(Instant now) {
  if (m_scripted && m_changeAt <= now) {
    m_inputs.allowedInCollisionZone = !m_inputs.allowedInCollisionZone;
    m_changeAt = now + m_random.between(10'000, 60'000) * Duration(1ms);
  }
  broadcast(now, MessageId::DigitalInputs, m_inputs.encode());
}

}  // namespace deckpipe::simulator
