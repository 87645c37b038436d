// SPDX-License-Identifier: GPL-3.0-or-later
// A simulator whose time jumps from deadline to deadline, everything it sent, and what that means through the
// catalogue. The rig owns the time; nothing sleeps.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/decode.h"
#include "protocol/role_walk.h"
#include "simulator/standard_simulator.h"
#include "support/frames.h"

namespace deckpipe::simulator::test {
using deckpipe::test::frame;

// A frame on the bus and what it is, with what was known of the nodes before it.
struct Seen {
  Instant time;
  Frame frame;
  Classified what;

  Address source() const { return J1939Id::of(frame.identifier()).source; }
  Address destination() const { return J1939Id::of(frame.identifier()).destination; }
};

class Rig {
 public:
  Simulator simulator;
  std::vector<Seen> log;  // sent by the simulator and by us, in order

  Instant now() const { return m_now; }

  void run(Duration d) { runTo(m_now + d); }
  void runTo(Instant end) {
    while (simulator.nextTime() <= end) {
      m_now = simulator.nextTime();
      simulator.timeCame(m_now);
      collect();
    }
    m_now = end;
  }
  void send(const Frame& frame) {
    observe({m_now, frame});
    simulator.received(m_now, frame);
    collect();
  }
  void send(std::string_view id, std::string_view data) { send(frame(id, data)); }
  // Sends it every 20 ms for so long, as a joystick does; the last one 20 ms before the end.
  void hold(const Frame& f, Duration d) {
    for (const Instant end = m_now + d; m_now < end;) {
      send(f);
      run(20ms);
    }
  }

  std::vector<Seen> all(MessageId id, Instant from = kNotYet) const {
    std::vector<Seen> result;
    for (const Seen& seen : log) {
      if (seen.time >= from && seen.what.isDecoded() && seen.what.message == id) result.push_back(seen);
    }
    return result;
  }
  std::vector<Seen> all(MessageId id, Address source, Instant from = kNotYet) const {
    auto result = all(id, from);
    std::erase_if(result, [&](const Seen& seen) { return seen.source() != source; });
    return result;
  }
  // "key=value; key=value" of every field of the last message of its kind; "" where there was none.
  std::string last(MessageId id) const {
    const auto seen = all(id);
    return seen.empty() ? std::string() : textOf(seen.back());
  }
  static std::string textOf(const Seen& seen) {
    std::string text;
    for (const Field& field : messageOf(seen.what.message).fields) {
      if (!isPresent(field, seen.frame)) continue;
      if (!text.empty()) text += "; ";
      text += std::string(field.key) + "=" + toText(valueOf(field, seen.frame));
    }
    return text;
  }

 private:
  void collect() {
    std::vector<DueFrame> frames;
    simulator.takeFrames(frames);
    for (const DueFrame& f : frames) observe(f);
  }
  void observe(const DueFrame& f) {
    const Classified what = m_walk.next(f.frame, f.time);
    log.push_back({f.time, f.frame, what});
  }

  Instant m_now{};
  RoleWalk m_walk;
};

// One 6032 alone, dead ahead and level, with its address claimed.
class MonitorRig : public Rig {
 public:
  static constexpr std::string_view kPin = "1032AE100801035";

  explicit MonitorRig(MonitorSettings settings = ahead())
      : monitor(simulator.add<Monitor6032>(500ms, kPin, settings, 1u)) {
    simulator.powerOn(now());
    run(1s);
  }
  static MonitorSettings ahead() {
    MonitorSettings settings;
    settings.startsStowed = false;
    return settings;
  }
  double rotation() const { return monitor.control().axes()[0].position() / 1e6; }
  double elevation() const { return monitor.control().axes()[1].position() / 1e6; }
  PositionLimitStatus position() const {
    return PositionLimitStatus::of(all(MessageId::PositionLimitStatus).back().frame);
  }
  DigitalOutputs outputs() const { return DigitalOutputs::of(all(MessageId::DigitalOutputs).back().frame); }
  SoftLimits rotationLimits() const {
    return SoftLimits::ofRotation(all(MessageId::RotationSoftLimits).back().frame);
  }

  Monitor6032& monitor;
};

// A joystick message; x right and y back (up) positive, 0.1 %.
inline Frame stick(unsigned source, int x, int y, std::initializer_list<Function> pressed = {}) {
  BasicJoystick joystick;
  joystick.x = StickAxis::at(x);
  joystick.y = StickAxis::at(-y);
  for (const Function f : pressed) joystick.switches[static_cast<std::size_t>(f)] = Status2::On;
  return j1939Frame(messageOf(MessageId::BasicJoystick), joystick.encode(),
                    Address{static_cast<std::uint8_t>(source)});
}

}  // namespace deckpipe::simulator::test
