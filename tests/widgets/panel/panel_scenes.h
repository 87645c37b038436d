// SPDX-License-Identifier: GPL-3.0-or-later
// One bus of every kind that a person comes upon, named: the gallery draws them, the tests walk through them.
#pragma once

#include <vector>

#include "model/device_labels.h"
#include "widgets/model/heard.h"

namespace deckpipe::test {

struct PanelScene {
  std::string name;
  LogView view;
  DeviceKey device;  // looked at
  DeviceLabels labels{};
};

inline constexpr char kPinRiser[] = "1033AB000000001";
inline constexpr char kPinJoystick[] = "1035AB000000002";
inline constexpr char kPinForestry[] = "1040DM004711007";

// Others on the bus, so that the table has something to show.
inline Heard& neighbours(Heard& bus) {
  return bus.hear("18EFFF81", announcementOf(kPinForestry))
      .hear("18EFFF81", "01FFFFFFFF000001")
      .hear("18EFFF81", "830040")
      .hear("18EFFF91", announcementOf(kPinRiser))
      .hear("18EFFF91", "848002")
      .hear("18EEFF33", kNameOfSerial2)
      .hear("18EFFF33", announcementOf(kPinJoystick))
      .hear("0CFDD633", kRestingStick)
      .hear("0CFDD638", kRestingStick)
      .hear("724", "05")
      .hear("18EEFFF9", kHigherForeignName)
      .hear("18FF0005", "00");
}

inline DeviceLabels sceneLabels() {
  DeviceLabels labels;
  labels.set(*Pin::parse(kPinA), QStringLiteral("Roof monitor"));
  labels.set(*Pin::parse(kPinForestry), QStringLiteral("Front bumper turret, the one from the old truck"));
  return labels;
}

// A truck with so many monitors, in every state that one can be in.
inline LogView manyMonitors(int count) {
  Heard bus;
  static constexpr const char* kPositions[] = {kPosition,          kNotFitted,         kSensorError,
                                               "0112350000000000", "011DA403714B0041", "013844016F004041",
                                               "010000000F00A041"};
  if (count > 0) bus.hear("18EFFF87", kPosition).pass(2s);  // it is overdue by now
  for (int i = 0; i < count; ++i) {
    char id[16], pin[32];
    std::snprintf(id, sizeof id, "18EFFF%02X", 0x80u + static_cast<unsigned>(i));
    std::snprintf(pin, sizeof pin, "10%sAE%09d", i % 3 == 2 ? "42" : "32", 100801035 + i);
    bus.hear(id, announcementOf(i == 1 ? kPinForestry : pin));
    if (i == 7) continue;
    bus.hear(id, kPositions[static_cast<std::size_t>(i) % std::size(kPositions)]);
    if (i % 4 != 3) bus.hear(id, i % 4 == 2 ? kOscillating : kRotationLimits).hear(id, kElevationLimits);
    bus.hear(id, i % 5 == 3 ? "832000" : kOutputs);
  }
  if (count > 0) bus.hear("0CFDD634", kStickRightBack);
  return bus.view();
}

inline std::vector<PanelScene> panelScenes() {
  std::vector<PanelScene> scenes;
  const auto add = [&](const char* name, const Heard& bus, const DeviceKey& key) {
    scenes.push_back({name, bus.view(), key, {}});
  };
  const auto node = [](int n) { return DeviceKey::at(Channel{0}, NodeId{static_cast<std::uint8_t>(n)}); };
  const auto address = [](int n) { return DeviceKey::at(Channel{0}, Address{static_cast<std::uint8_t>(n)}); };
  const auto pin = [](const char* text) { return DeviceKey::of(*Pin::parse(text)); };
  const auto answers = [](Heard& bus, const char* faults) {
    bus.hear("18EF0580", faults)
        .hear("18EF0580", "03010001020105")
        .hear("18EF0580", "040D1C000E0200")
        .hear("18EF0580", "050398690E0103");
  };

  {
    PanelScene nothing{"nothing_open", {}, {}, {}};
    nothing.view.state = std::make_shared<State>();
    scenes.push_back(nothing);
  }
  add("no_frames", Heard(), {});
  {
    Heard bus;
    for (int i = 0; i < 1234; ++i) bus.hear("7DF", "0201");
    for (int i = 0; i < 7; ++i) {
      Frame error;
      error.id = kErrorBit;
      bus.hear(error);
    }
    add("unknown_frames", bus, {});
  }
  {
    Heard bus;
    add("nothing_chosen", neighbours(bus.monitor()), {});
    add("not_heard_yet", bus, pin("1042XY123456789"));
    bus.hear("0CFDD634", kStickRightBack).pass(30ms);
    answers(bus, "02000000000000");
    bus.pass(20ms);
    add("fresh", bus, keyOfA());
    bus.pass(2400ms).hear("0CFDD633", kRestingStick).hear("18EFFF91", "848002");
    add("stale", bus, keyOfA());
  }
  {
    Heard bus;
    neighbours(bus.monitor(kSensorError));
    answers(bus, "0200302802000B");
    bus.pass(200ms).monitor(kSensorError).hear("18EFFF80", "0100");
    add("sensor_error_faults", bus, keyOfA());
  }
  {
    Heard bus;
    neighbours(bus.monitor(kNotFitted));
    bus.hear("18EF0580", "0200000000");
    add("not_fitted_old_firmware", bus, keyOfA());
  }
  {
    Heard bus;
    neighbours(bus.monitor("011DA403714B0041", kOscillating)).hear("0CFDD633", kStickLeft);
    bus.hear("18EF8005", "A10009").hear("18EFFF80", "83CA5B");
    add("oscillating_permissive_stop", bus, keyOfA());
  }
  {
    Heard bus;
    neighbours(bus.monitor()).hear("18EFFF80", "832800");
    add("stowed_permissive_missing", bus, keyOfA());
  }
  {
    Heard bus;
    neighbours(bus).hear("18EFFF80", kPosition);
    add("no_pin", bus, address(0x80));
    add("forestry", bus, pin(kPinForestry));
    add("riser", bus, pin(kPinRiser));
    bus.hear("18EFFFF0", "8505");
    add("io_module", bus, address(0xF0));
    add("heartbeat_only", bus, node(0x24));
    add("foreign", bus, address(0xF9));
    add("without_name", bus, address(0x05));
  }
  {
    Heard bus;
    neighbours(bus.monitor());
    for (int i = 0; i < 12; ++i) bus.hear("0CFDD633", kRestingStick).pass(20ms);
    bus.pass(130ms).hear("0CFDD633", "107D046400044000").hear("0CFDD733", "44320100FFFFFFFF");
    add("joystick", bus, pin(kPinJoystick));
    bus.pass(1s);
    add("joystick_stopped", bus, pin(kPinJoystick));
  }
  {
    Heard bus;
    neighbours(bus.monitor()).hear("18EFFF82", announcementOf("1035AE100804442")).pass(4s);
    neighbours(bus.monitor());
    add("control_without_source", bus, pin("1035AE100804442"));
    bus.note({.frame = 1, .time = bus.now(), .value = note::DriveSaid{{}, {0x21}}});
    bus.hear("18EF0521", "8200");
    add("drive", bus, address(0x21));
    add("labelled", bus, keyOfA());
    scenes.back().labels = sceneLabels();
    for (const char* id : {"18EFFF85", "18EFFF86", "18EFFF87", "18EFFF88", "18EFFF89"})
      bus.pass(20s).hear(id, kAnnouncesA);
    neighbours(bus);
    add("address_history", bus, keyOfA());
    add("invalid", neighbours(bus.hear("18EFFF89", "0112350000000000")), keyOfA());
  }
  {
    Heard bus;
    neighbours(bus).hear("1A4", kPosition).hear("2A4", kOutputs).hear("224", kStickRightBack);
    bus.hear("5A4", "4300500116699803").hear("5A4", "4301500100200000").hear("5A4", "4B0150020B00");
    add("gateway_monitor", bus, node(0x24));
  }
  {
    Heard bus;
    neighbours(bus.monitor()).hear("18EEFF80", kLowerForeignName).pass(90s);
    add("address_lost_silent", bus, keyOfA());
  }
  {
    Heard bus;
    neighbours(bus.monitor(kSensorError)).faults("0200200200000B").pass(90s);
    neighbours(bus.statuses("01FFF4FFF4020004")).hear("18EFFF80", "834051").hear("18EF80F9", "02").pass(2s);
    bus.statuses("01FFF4FFF4020004").hear("18EFFF80", "834051");
    add("everything_at_once", neighbours(bus), keyOfA());
  }
  {
    Heard bus;
    neighbours(bus.monitor()).faults().hear("18EEFF80", kNameOfSerial2).hear("18EFFF80", kAnnouncesB);
    for (int i = 0; i < 9; ++i) bus.pass(50ms).hear("18EFFF80", i % 2 == 0 ? "0112C10644000041" : kPosition);
    bus.hear("18EFFF80", kOutputs);
    add("two_at_one_address", neighbours(bus), pin("1032AE100801036"));
  }
  return scenes;
}

}  // namespace deckpipe::test
