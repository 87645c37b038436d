// SPDX-License-Identifier: GPL-3.0-or-later
// One of everything that a dial can show, named; the tests compare the pictures, the gallery draws them.
#pragma once

#include <string>
#include <vector>

#include "paint/dial_values.h"

namespace deckpipe {

struct DialSample {
  std::string name;
  DialValues values;
};

// And none.
inline std::vector<std::optional<PositionState>> allReadings() {
  std::vector<std::optional<PositionState>> all{std::nullopt};
  for (const PositionState state : kAllOf<PositionState>) all.emplace_back(state);
  return all;
}

inline DialAxis readingOf(double degrees) {
  DialAxis axis;
  axis.reading = PositionState::Ok;
  axis.degrees = degrees;
  axis.age = Age::ago(100ms);
  axis.plusStop = axis.minusStop = Status2::Off;
  return axis;
}

inline DialValues usualValues() {
  DialValues v;
  v.rotation = readingOf(47.3);
  v.rotation.limitLow = -120;
  v.rotation.limitHigh = 90;
  v.elevation = readingOf(22.5);
  v.elevation.limitLow = -15;
  v.elevation.limitHigh = 75;
  v.enable = true;
  v.stowed = false;
  return v;
}

inline std::vector<DialSample> dialSamples() {
  std::vector<DialSample> samples;
  const auto add = [&](const char* name, auto change) {
    DialValues v = usualValues();
    change(v);
    samples.push_back({name, v});
  };
  const auto both = [](DialValues& v, PositionState reading) {
    v.rotation.reading = v.elevation.reading = reading;
    v.rotation.degrees = v.elevation.degrees = 0;
  };
  add("ok", [](DialValues&) {});
  add("ok_no_limits", [](DialValues& v) {
    v.rotation.limitLow = v.rotation.limitHigh = v.elevation.limitLow = v.elevation.limitHigh = {};
  });
  add("negative", [](DialValues& v) {
    v.rotation.degrees = -118.4;
    v.elevation.degrees = -12.6;
  });
  add("stale", [](DialValues& v) {
    v.rotation.isStale = v.elevation.isStale = true;
    v.rotation.age = v.elevation.age = Age::ago(2400ms);
  });
  add("limits_stale", [](DialValues& v) { v.rotation.areLimitsStale = v.elevation.areLimitsStale = true; });
  add("no_data", [](DialValues& v) { v = DialValues(); });
  add("not_fitted", [&](DialValues& v) { both(v, PositionState::NotFitted); });
  add("sensor_error", [&](DialValues& v) { both(v, PositionState::SensorError); });
  add("invalid", [&](DialValues& v) { both(v, PositionState::Invalid); });
  add("sensor_error_stale", [&](DialValues& v) {
    both(v, PositionState::SensorError);
    v.rotation.isStale = v.elevation.isStale = true;
    v.rotation.age = v.elevation.age = Age::ago(47s);
  });
  add("oscillating", [](DialValues& v) {
    v.rotation.isOscillating = true;
    v.rotation.limitLow = -35;
    v.rotation.limitHigh = 62.5;
  });
  add("commanded", [](DialValues& v) {
    v.rotation.command = DialAxis::Command{0.6, QStringLiteral("Joystick 33")};
    v.elevation.command = DialAxis::Command{-0.25, QStringLiteral("Joystick 33")};
  });
  add("command_full", [](DialValues& v) {
    v.rotation.command = DialAxis::Command{-1, QStringLiteral("Deckpipe 38")};
    v.elevation.command = DialAxis::Command{1, QStringLiteral("Point-aim")};
  });
  add("stops", [](DialValues& v) {
    v.rotation.degrees = 90;
    v.rotation.plusStop = Status2::On;
    v.rotation.command = DialAxis::Command{0.8, QStringLiteral("Joystick 33")};
    v.elevation.degrees = -15;
    v.elevation.minusStop = Status2::On;
  });
  add("stops_stale", [](DialValues& v) {
    v.rotation.plusStop = v.elevation.plusStop = Status2::On;
    v.rotation.isStale = v.elevation.isStale = true;
    v.rotation.age = v.elevation.age = Age::ago(12s);
  });
  add("stop_errors", [](DialValues& v) {
    v.rotation.minusStop = Status2::Error;
    v.elevation.plusStop = Status2::Error;
  });
  add("not_fitted_stop_command", [&](DialValues& v) {
    both(v, PositionState::NotFitted);
    v.rotation.minusStop = v.elevation.plusStop = Status2::On;
    v.rotation.command = DialAxis::Command{0.5, QStringLiteral("Joystick 34")};
    v.elevation.command = DialAxis::Command{-0.5, QStringLiteral("Joystick 34")};
  });
  add("whole_circle_extremes", [](DialValues& v) {
    v.rotation.degrees = -180;
    v.rotation.limitLow = -180;
    v.rotation.limitHigh = 180;
    v.elevation.degrees = 104.2;
    v.elevation.limitLow = -90;
    v.elevation.limitHigh = 90;
  });
  add("disabled", [](DialValues& v) { v.enable = false; });
  add("stowed", [](DialValues& v) {
    v.enable = false;
    v.stowed = true;
    v.rotation.degrees = 0;
    v.elevation.degrees = 0;
  });
  return samples;
}

}  // namespace deckpipe
