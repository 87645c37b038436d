// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated truck does, told as events.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "simulator/standard_simulator.h"
#include "state/advance.h"
#include "state/event_walk.h"
#include "support/event_lines.h"
#include "support/frames.h"

namespace deckpipe::simulator {
namespace {

using deckpipe::test::frame;

constexpr char kMonitor[] = "1032AE100801035";

// A minute of the truck, with nobody at its joystick. A tester asks every device for its faults each second. What
// goes wrong begins half a second after the twentieth poll.
std::vector<Event> eventsOfTruck(const std::function<void(StandardSimulator&, Instant)>& goWrong) {
  StandardSimulator truck = standardSimulator(1);
  truck.joystick->release();
  truck.simulator.powerOn({});
  goWrong(truck, Instant{20'500'000'000});
  FrameStore frames;
  std::vector<DueFrame> due;
  const auto keep = [&] {
    due.clear();
    truck.simulator.takeFrames(due);
    for (const DueFrame& f : due) {
      Frame copy = f.frame;
      copy.stamp = f.time.ns;
      if (!frames.append({&copy, 1})) std::abort();
    }
  };
  for (Instant second = Instant{} + Duration(1s); second <= Instant{} + Duration(60s);
       second = second + Duration(1s)) {
    while (truck.simulator.nextTime() < second) {
      truck.simulator.timeCame(truck.simulator.nextTime());
      keep();
    }
    for (const char* poll : {"18EF80F9", "18EF81F9", "18EF82F9", "18EF83F9"}) {
      Frame f = frame(poll, "02");
      f.stamp = second.ns;
      if (!frames.append({&f, 1})) std::abort();
      truck.simulator.received(second, f);
      keep();
    }
  }
  EventWalk walk;
  std::vector<Event> events;
  walk.advance(frames, NoteStore(), cursorAfter(frames, frames.count()), events);
  return events;
}

// The kinds of what concerns the monitor, in order.
std::vector<std::string> keysOfMonitor(const std::vector<Event>& events) {
  std::vector<std::string> keys;
  for (const Event& event : events) {
    if (event.pin.text() == kMonitor) keys.emplace_back(kEvents[event.kind].key);
  }
  return keys;
}

TEST(EventsOfATruck, AreNoneWhileItIsWell) {
  const auto events = eventsOfTruck([](StandardSimulator&, Instant) {});
  EXPECT_EQ(deckpipe::test::linesOf(events), std::vector<std::string>{});
}

struct WrongCase {
  const char* name;
  Misbehaviour how;
  std::vector<std::string> keys;
};
class EventsOfABrokenMonitor : public testing::TestWithParam<WrongCase> {};

TEST_P(EventsOfABrokenMonitor, SayWhatIsWrong) {
  const auto events = eventsOfTruck([](StandardSimulator& truck, Instant when) {
    truck.simulator.misbehave(when, 0, GetParam().how);
    truck.simulator.misbehave(when + Duration(20s), 0, {});
  });
  EXPECT_EQ(keysOfMonitor(events), GetParam().keys);
}
INSTANTIATE_TEST_SUITE_P(
    Of, EventsOfABrokenMonitor,
    testing::Values(WrongCase{"Silent", {.silent = true}, {"silent", "back"}},
                    WrongCase{"RotationSensor",
                              {.rotationSensorError = true},
                              {"sensor_error", "operational_error", "error_code", "sensor_error_over",
                               "operational_error_over"}},
                    WrongCase{"Disabled", {.enableOff = true}, {"disabled", "enabled"}},
                    WrongCase{"Fuse", {.faultBits = faultBit("internal_fuse")}, {"fault", "fault_cleared"}},
                    WrongCase{"PcodeError",
                              {.pcodeError = 7},
                              {"operational_error", "error_code", "operational_error_over"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(EventsOfATruck, SayThatADeviceWasReset) {
  const auto events = eventsOfTruck([](StandardSimulator& truck, Instant when) {
    truck.simulator.press(when, 0, Simulator::Button::Reset);
  });
  const auto keys = keysOfMonitor(events);
  EXPECT_NE(std::ranges::find(keys, "restarted"), keys.end())
      << testing::PrintToString(deckpipe::test::linesOf(events));
}

TEST(EventsOfATruck, SayThatAnAddressWasTaken) {
  const auto events = eventsOfTruck([](StandardSimulator& truck, Instant when) {
    truck.simulator.misbehave(when, 0, {.addressTaken = true});
  });
  const auto keys = keysOfMonitor(events);
  EXPECT_NE(std::ranges::find(keys, "address_lost"), keys.end())
      << testing::PrintToString(deckpipe::test::linesOf(events));
  EXPECT_NE(std::ranges::find(keys, "moved_address"), keys.end())
      << testing::PrintToString(deckpipe::test::linesOf(events));
}

}  // namespace
}  // namespace deckpipe::simulator
