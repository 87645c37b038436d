// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/dial_adapter.h"

namespace deckpipe {
namespace {

DialAxis::Reading readingOf(PositionState state) {
  switch (state) {
    case PositionState::Ok: return DialAxis::Reading::Ok;
    case PositionState::SensorError: return DialAxis::Reading::SensorError;
    case PositionState::NotFitted: return DialAxis::Reading::NotFitted;
    case PositionState::Invalid: break;
  }
  return DialAxis::Reading::Invalid;
}

DialAxis::Stop stopOf(const std::optional<Status2>& status) {
  if (!status) return DialAxis::Stop::Unknown;
  switch (*status) {
    case Status2::Off: return DialAxis::Stop::Off;
    case Status2::On: return DialAxis::Stop::On;
    case Status2::Error: return DialAxis::Stop::Error;
    case Status2::NotAvailable: break;
  }
  return DialAxis::Stop::NotAvailable;
}

DialValues::Flag flagOf(const std::optional<bool>& flag) {
  if (!flag) return DialValues::Flag::Unknown;
  return *flag ? DialValues::Flag::On : DialValues::Flag::Off;
}

DialAxis axisOf(const PageAxis& page) {
  DialAxis axis;
  if (page.reading) {
    axis.reading = readingOf(page.reading->state);
    axis.degrees = page.reading->tenths / 10.0;
  }
  axis.stale = page.isStale;
  axis.age = page.age;
  axis.plusStop = stopOf(page.plusStop);
  axis.minusStop = stopOf(page.minusStop);
  if (page.limits) {
    axis.limitLow = page.limits->low / 10.0;
    axis.limitHigh = page.limits->high / 10.0;
    axis.oscillating = page.limits->oscillating;
  }
  axis.limitsStale = page.areLimitsStale;
  if (page.command) axis.command = DialAxis::Command{page.command->speed, page.command->source};
  return axis;
}

}  // namespace

DialValues dialValuesOf(const PageDial& page) {
  DialValues values;
  values.rotation = axisOf(page.rotation);
  values.elevation = axisOf(page.elevation);
  values.enable = flagOf(page.enable);
  values.stowed = flagOf(page.stowed);
  return values;
}

}  // namespace deckpipe
