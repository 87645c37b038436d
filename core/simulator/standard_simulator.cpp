// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/standard_simulator.h"

#include <algorithm>
#include <numeric>

namespace deckpipe::simulator {
namespace {

// When the n-th of so many more monitors is ready, so that their statuses share each 100 ms evenly: steps of
// about a fifth of the period, over a count that they have no divisor in common with.
Duration bootOf(unsigned n, unsigned count) {
  unsigned step = std::max(1u, count / 5);
  while (std::gcd(step, count) != 1) ++step;
  return 1600ms + Monitor6032::kStatusPeriod * (n * step) / count;
}

}  // namespace

StandardSimulator standardSimulator(std::uint64_t seed, const MonitorSettings& settings, unsigned monitors) {
  Random random(seed);
  const auto boot = [&] { return random.between(300, 1500) * Duration(1ms); };
  StandardSimulator s;
  s.monitor = &s.simulator.add<Monitor6032>(boot(), "1032AE100801035", settings, random.next());
  s.riser = &s.simulator.add<MiniUniversal6033>(boot(), "1033AE100802117", random.next());
  s.ioModule = &s.simulator.add<IoModule6039>(boot(), 0x0F3A21u, random.next());
  s.joystick = &s.simulator.add<Joystick6035>(boot(), "1035AE100804442", Address{0x33}, random.next());
  for (unsigned n = 1; n < std::min(monitors, kMaxMonitors); ++n) {
    const Pin pin = *Pin::make(1032, 'A', 'E', 100'801'100 + n);
    s.others.push_back(
        &s.simulator.add<Monitor6032>(bootOf(n, monitors), pin.text(), settings, random.next()));
  }
  return s;
}

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
