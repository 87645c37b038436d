// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots of every state that the window can be in, for pictures and for tests of its layout: made by hand,
// as most of them need hardware to come about by themselves.
#pragma once

#include <string>
#include <vector>

#include "session/snapshot.h"
#include "support/enums.h"
#include "support/logs.h"

namespace deckpipe::test {

struct Scene {
  const char* name;
  Snapshot snapshot;
};

// A monitor that turns, a joystick and a 6033 that reports, for so many seconds.
inline std::string truckText(int seconds) {
  std::string text =
      "(1000.000000) can0 18EEFF80#3412C02800420090\n"
      "(1000.001000) can0 18EFFF80#FF83150206021A0B\n"
      "(1000.002000) can0 18EEFF90#3412A00000420090\n";
  for (int i = 1; i < seconds * 10; ++i) {
    char line[80];
    const int angle = 100 + i % 400;
    std::snprintf(line, sizeof line, "(%d.%d00000) can0 18EFFF80#01%02X%X40371000041\n", 1000 + i / 10,
                  i % 10, angle >> 4, angle & 0xF);
    text += line;
    std::snprintf(line, sizeof line, "(%d.%d01000) can0 18EFFF80#83C001\n", 1000 + i / 10, i % 10);
    text += line;
    std::snprintf(line, sizeof line, "(%d.%d02000) can0 0CFDD633#0100010000000000\n", 1000 + i / 10, i % 10);
    text += line;
  }
  return text;
}

// The same, and then much goes wrong.
inline std::string eventfulText() {
  return truckText(30) +
         "(1030.000000) can0 18EFFF80#83C001\n(1030.100000) can0 18EFFF80#834001\n"
         "(1030.200000) can0 18EF80F9#02\n(1030.210000) can0 18EFF980#0200200000000B\n"
         "(1031.000000) can0 18EFFF80#011D940371000045\n(1031.500000) can0 18EFFF80#011D940371400041\n"
         "(1032.000000) can0 18EFFF80#83C009\n(1032.500000) can0 18EFFF80#01FFF40371000041\n"
         "(1033.000000) can0 18EFFF80#81FC7C038400\n(1033.500000) can0 18EFFF80#81FC7C02BC00\n"
         "(1041.000000) can0 18EFFF80#011D940371000041\n(1042.000000) can0 18EEFF90#0100200000000000\n"
         "(1043.000000) can0 18EFFF80#FF83150206021A0B\n(1044.000000) can0 18EFFF84#FF83150206021A0B\n"
         "(1044.100000) can0 18EFFF84#011D940371000041\n(1044.500000) can0 0CFDD633#0100010000000000\n"
         "(1044.800000) can0 0CFDD633#0100010000000000\n(1045.000000) can0 18EFFF84#83C001\n";
}

inline Snapshot snapshotOf(const std::string& text, SourceStatus::Kind kind,
                           SourceStatus::Progress progress) {
  Snapshot snapshot;
  const auto log = logOfText(text);
  snapshot.view = viewOf(log);
  auto state = std::make_shared<State>();
  advance(*state, log->frames, log->notes, snapshot.view.cursor);
  snapshot.view.state = state;
  SourceStatus& source = snapshot.source;
  source.kind = kind;
  source.progress = progress;
  source.unreadable = log->skipped.content().unreadable();
  if (kind == SourceStatus::Kind::File) {
    source.name =
        QStringLiteral("/home/technician/logs/2026-11-22 ladder 4 monitor stops short of the left limit.log");
  } else {
    source.name = QStringLiteral("socketcan can0");
    source.plugin = QStringLiteral("socketcan");
    source.interfaceName = QStringLiteral("can0");
    source.bitRate = 250'000;
  }
  return snapshot;
}

// So much later, with nothing heard since.
inline Snapshot later(Snapshot snapshot, Duration time) {
  snapshot.view.cursor.time = snapshot.view.cursor.time + time;
  snapshot.view.end = snapshot.view.cursor.time;
  auto state = std::make_shared<State>(*snapshot.view.state);
  advance(*state, snapshot.view.document->frames, snapshot.view.document->notes, snapshot.view.cursor);
  snapshot.view.state = state;
  return snapshot;
}

// The link was lost four seconds ago, while a joystick moved the monitor, which stood at a stop.
inline Snapshot linkLost() {
  const std::string text =
      truckText(5) +
      "(1004.980000) can0 18EFFF80#81FED401C200\n(1004.981000) can0 18EFFF80#82FF38038400\n"
      "(1004.982000) can0 18EF80F9#02\n(1004.984000) can0 18EFF980#02000000000000\n"
      "(1004.990000) can0 18EFFF80#011D940371400041\n(1004.995000) can0 0CFDD633#107D046400100000\n";
  Snapshot lost = snapshotOf(text, SourceStatus::Kind::Link, SourceStatus::Progress::Lost);
  lost.source.error = LinkError{.fault = LinkFault::Gone, .detail = "Network is down"};
  const auto log = logOfText(text);
  log->notes.append({.frame = log->frames.count(),
                     .time = log->frames.lastTime() + 5ms,
                     .value = note::LinkDown{.channel = {}, .fault = LinkFault::Gone, .words = {}}});
  lost.view.document = log;
  return later(lost, 4s);
}

// As many monitors as nobody has on one truck. Three are in trouble, each in its own way: disabled, its sensor wrong, a
// fault of its own.
inline Snapshot fleetOfMonitors(int count = 30) {
  std::string text;
  char line[96];
  const auto add = [&](int at, int step, const char* data) {
    std::snprintf(line, sizeof line, "(1000.%d%05d) can0 18EFFF%02X#%s\n", step, 100 * at, 0x80 + at, data);
    text += line;
  };
  for (int step = 0; step < 10; ++step) {
    for (int at = 0; at < count; ++at) {
      char data[24];
      std::snprintf(data, sizeof data, "FF83150206021A%02X", 0x0B + at);
      if (step == 0) add(at, step, data);
      const int angle = 100 + 37 * at % 400;
      std::snprintf(data, sizeof data, "01%02X%X40371000041", angle >> 4, angle & 0xF);
      add(at, step, at == 11 ? "01FFF4FFF4000004" : data);
      add(at, step, at == 4 ? "834051" : "83C051");
    }
  }
  std::snprintf(line, sizeof line, "(1001.000000) can0 18EF%02XF9#02\n", 0x80 + count - 2);
  text += line;
  std::snprintf(line, sizeof line, "(1001.001000) can0 18EFF9%02X#0200200000000B\n", 0x80 + count - 2);
  text += line;
  return snapshotOf(text, SourceStatus::Kind::Link, SourceStatus::Progress::Running);
}

// Unlocked on the truck: polls asked and answered or not, and a file that stalled in the data pipe.
inline Snapshot askingSnapshot() {
  const std::string talk =
      "(1005.000000) can0 18EF80F9#02\n"
      "(1005.002000) can0 18EFF980#0200200000000B\n"
      "(1005.100000) can0 18EF80F9#03\n"
      "(1005.103000) can0 18EFF980#03010001020304\n"
      "(1005.200000) can0 18EF80F9#02\n"
      "(1005.202000) can0 18EFF980#02000000000000\n"
      "(1005.300000) can0 18EF80F9#FE413F0D0A\n"
      "(1005.303000) can0 18EFF980#FE\n"
      "(1005.310000) can0 18EFF980#FE363033320D0A\n"
      "(1005.311000) can0 18EF80F9#FE\n"
      "(1005.400000) can0 18EF80F9#FE1B4D454E55\n";
  Snapshot snapshot =
      snapshotOf(truckText(5) + talk, SourceStatus::Kind::Link, SourceStatus::Progress::Running);
  const Instant now = snapshot.view.cursor.time;
  ServiceStatus services;
  services.locked = false;
  services.linkUp = true;
  services.claim.progress = ClaimStatus::Progress::Claimed;
  services.claim.address = Address{0xF9};
  DeviceServices& device = services.devices.emplace_back();
  device.device = DeviceKey::of(*Pin::parse("1032AE100801035"));
  device.address = Address{0x80};
  for (const Request request : allOf<Request>()) device.takes.add(request);
  using Progress = RequestStatus::Progress;
  const auto ended = [&](Request request, Progress progress, RequestEnd end, int tries) {
    RequestStatus& status = device.requests[request];
    status.progress = progress;
    status.end = end;
    status.tries = static_cast<std::uint8_t>(tries);
    status.sent = status.ended = now - 200ms;
    status.latency = 2ms;
  };
  ended(Request::Fault, Progress::Ended, RequestEnd::Answered, 1);
  ended(Request::Firmware, Progress::Ended, RequestEnd::Answered, 1);
  ended(Request::Pcode, Progress::Ended, RequestEnd::NoAnswer, 3);
  ended(Request::Config, Progress::Waiting, RequestEnd::None, 2);
  ended(Request::Reset, Progress::Ended, RequestEnd::Answered, 1);
  PipeStatus& pipe = device.pipe.emplace();
  DeviceServices riser;
  riser.device = DeviceKey::of(*Pin::parse("1033AE100802117"));
  riser.requests[Request::Fault] = {.progress = Progress::Queued, .period = 5s};
  pipe.progress = PipeStatus::Progress::Stalled;
  pipe.stall = PipeStatus::Stall::NoAck;
  pipe.file = "a menu with a rather long name for a file.txt";
  pipe.fileSize = 100'000;
  pipe.fileSent = 42'000;
  pipe.fileBegan = now - 60s;
  pipe.acks = 6'000;
  pipe.ackSum = 24s;
  pipe.ackWorst = 72ms;
  services.devices.push_back(riser);
  snapshot.services = std::make_shared<const ServiceStatus>(services);
  return snapshot;
}

inline std::vector<Scene> windowScenes() {
  using Kind = SourceStatus::Kind;
  using Progress = SourceStatus::Progress;
  const std::string truck = truckText(5);
  Snapshot nothing;
  nothing.view.state = std::make_shared<const State>();
  std::vector<Scene> scenes{{"nothing_open", nothing}};
  const auto add = [&](const char* name, const Snapshot& snapshot) { scenes.push_back({name, snapshot}); };
  add("log_open", snapshotOf(truck, Kind::File, Progress::Done));
  add("log_damaged", snapshotOf(truck + "rubbish\n(1) can0 123#1\n((\n", Kind::File, Progress::Done));
  add("log_empty", snapshotOf("", Kind::File, Progress::Done));
  Snapshot unreadable = snapshotOf("", Kind::File, Progress::Failed);
  unreadable.source.error = ReadError{.kind = ReadError::Kind::UnknownFormat};
  add("log_unreadable", unreadable);
  Snapshot reading = snapshotOf(truck, Kind::File, Progress::Opening);
  reading.source.fraction = 0.42;
  add("log_reading", reading);
  add("connecting", snapshotOf("", Kind::Link, Progress::Opening));
  Snapshot live = snapshotOf(truck, Kind::Link, Progress::Running);
  ServiceStatus up;
  up.linkUp = true;
  live.services = std::make_shared<const ServiceStatus>(up);
  live.source.isListenOnly = true;
  add("live", live);
  Snapshot paused = live;
  paused.view.atEnd = false;
  paused.view.cursor = cursorAfter(paused.view.document->frames, 60);
  add("live_paused", paused);
  add("live_silent", later(live, 12s));
  add("live_canopen", snapshotOf("(1.0) can0 123#11\n(1.3) can0 1A4#0102\n", Kind::Link, Progress::Running));
  add("live_foreign",
      snapshotOf("(1.0) can0 18FEF100#11\n(1.3) can0 0CF00400#11\n", Kind::Link, Progress::Running));
  Snapshot lossy = live;
  const auto lossyLog = logOfText(truck);
  lossyLog->notes.append({.value = note::Dropped{{}, 1'200}});
  lossyLog->notes.append({.value = note::LeftOut{{}, note::LeftOut::Why::CanFd, 34}});
  lossy.view.document = lossyLog;
  lossy.source.controller = ControllerState::ErrorPassive;
  add("live_lossy", lossy);
  Snapshot off = later(live, 4s);
  off.source.controller = ControllerState::BusOff;
  add("live_bus_off", off);
  add("link_lost", linkLost());
  Snapshot down = snapshotOf("", Kind::Link, Progress::Failed);
  down.source.error = LinkError{.fault = LinkFault::InterfaceDown};
  add("link_down", down);
  Snapshot kept = askingSnapshot();
  ServiceStatus waiting = *kept.services;
  waiting.waitingCommands.push_back(
      {DeviceKey::of(*Pin::parse("1032AE100801035")), Request::SetupMode, kept.view.cursor.time});
  waiting.unconfirmed = 3;
  waiting.notTaken = 12;
  kept.services = std::make_shared<const ServiceStatus>(waiting);
  add("live_not_on_bus", kept);
  Snapshot unsent = paused;
  unsent.notSent = Refusal::NotLive;
  add("live_nothing_sent", unsent);
  return scenes;
}

}  // namespace deckpipe::test
