// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated truck: simulated devices on one bus. The demo and the tests of services use it as the other end of
// the wire; it has no clock, no IO and no thread of its own.
//
//   simulator.powerOn(now);
//   loop: wait until simulator.nextTime() or a frame of others
//         simulator.received(now, frame) | simulator.timeCame(now)
//         simulator.takeFrames(frames): put them on the bus
//
// 1. Frames come out in order, each with the instant at which it was due, never later than the time passed in.
// 2. What one device sends all others get at that instant. What comes from outside all get.
// 3. The same seed, and the same frames from outside at the same instants, give the same frames out, however
//    often timeCame is called.
// 4. A late call makes up for everything that was due meanwhile. After a suspend the caller
//    passes in a time that did not jump, or a burst of old frames comes out.
#pragma once

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "control/simulator_control.h"
#include "simulator/background.h"
#include "simulator/device.h"

namespace deckpipe::simulator {

class Simulator {
 public:
  // Devices in the order they are added; `boot` is the time from power to the first claim.
  std::size_t add(std::unique_ptr<Device> device, Duration boot);
  template <typename D, typename... Args>
  D& add(Duration boot, Args&&... args) {
    auto device = std::make_unique<D>(std::forward<Args>(args)...);
    D& kept = *device;
    add(std::move(device), boot);
    return kept;
  }
  void powerOn(Instant now);
  // Other traffic from then on, so much of the bus: 0 to Background::kMax.
  void fill(Instant from, double share, int bitRate = 250'000) { m_background.set(from, share, bitRate); }
  bool isFilled() const { return m_background.nextTime() != kNever; }

  void received(Instant now, const Frame& frame);
  void timeCame(Instant now);
  Instant nextTime() const;
  // Appends what was due since the last call.
  void takeFrames(std::vector<DueFrame>& out);

  std::size_t size() const { return m_members.size(); }
  Device& device(std::size_t index) { return *m_members[index].device; }
  const Device& device(std::size_t index) const { return *m_members[index].device; }
  // From `when` on a device behaves like this. For at once there is Device::misbehave.
  void misbehave(Instant when, std::size_t index, const Misbehaviour& how);
  // Its switch or its reset button. On is ready after the device's own boot time, and nothing where it is on.
  using Button = SimulatorButton;
  void press(Instant when, std::size_t index, Button button);

 private:
  struct Member {
    std::unique_ptr<Device> device;
    Duration boot{0};
    std::unique_ptr<Device> intruder;  // has taken its address
  };
  struct Planned {
    Instant when;
    std::size_t index;
    std::variant<Misbehaviour, Button> what;
  };

  void plan(Planned what);
  void apply(Instant now, const Planned& planned);
  void step(Instant now);
  void placeIntruder(Instant now, Member& member);
  void exchange(Instant now);
  template <typename F>
  void forEach(F&& f) const;

  std::vector<Member> m_members;
  std::vector<Planned> m_plan;  // by time
  Background m_background;
  std::vector<DueFrame> m_out;
  std::vector<std::pair<const Device*, DueFrame>> m_onBus;
  std::vector<DueFrame> m_fresh;
  std::uint32_t m_intruders = 0;
};

}  // namespace deckpipe::simulator
