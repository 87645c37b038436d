// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial_text.h"

#include <QStringList>
#include <cmath>

#include "paint/figures.h"

namespace deckpipe {

QString DialText::title(DialAxisKind kind) {
  return kind == DialAxisKind::Rotation ? tr("Rotation") : tr("Elevation");
}

QString DialText::reading(std::optional<PositionState> reading) {
  if (!reading) return tr("No data");
  switch (*reading) {
    case PositionState::Ok: return {};
    case PositionState::SensorError: return tr("Sensor error");
    case PositionState::NotFitted: return tr("No sensor");
    case PositionState::Invalid: return tr("Invalid");
  }
  return {};
}

QString DialText::readingShort(std::optional<PositionState> reading) {
  return reading == PositionState::SensorError ? tr("Error", "sensor error where there is little room")
                                               : DialText::reading(reading);
}

QString DialText::stops(DialAxisKind kind, const DialAxis& axis) {
  const bool plan = kind == DialAxisKind::Rotation;
  const auto side = [&](std::optional<Status2> stop, bool plus) {
    if (stop == Status2::On) {
      if (plan) return plus ? tr("Right stop") : tr("Left stop");
      return plus ? tr("Up stop") : tr("Down stop");
    }
    if (plan) return plus ? tr("Right stop error") : tr("Left stop error");
    return plus ? tr("Up stop error") : tr("Down stop error");
  };
  const auto shown = [](std::optional<Status2> stop) {
    return stop == Status2::On || stop == Status2::Error;
  };
  if (axis.plusStop == Status2::On && axis.minusStop == Status2::On) return tr("Both stops");
  if (axis.plusStop == Status2::Error && axis.minusStop == Status2::Error) return tr("Stop errors");
  // A stop that is on says more than one in error; both blocks are drawn anyway.
  if (axis.plusStop == Status2::On || (shown(axis.plusStop) && axis.minusStop != Status2::On))
    return side(axis.plusStop, true);
  if (shown(axis.minusStop)) return side(axis.minusStop, false);
  return {};
}

QString DialText::enable(std::optional<bool> flag) {
  if (!flag) return {};
  return *flag ? tr("Enabled") : tr("Disabled");
}

QString DialText::stowed(std::optional<bool> flag) { return flag == true ? tr("Stowed") : QString(); }

QString DialText::enableLong(std::optional<bool> flag) {
  if (!flag) return tr("Whether motion is allowed is not known.");
  return *flag ? tr("Motion is enabled.") : tr("Motion is disabled.");
}

QString DialText::stowedLong(std::optional<bool> flag) {
  if (!flag) return {};
  return *flag ? tr("Stowed.") : tr("Not stowed.");
}

QString DialText::angle(DialAxisKind kind, double degrees) {
  const QString number = degreesText(std::abs(degrees));
  const double tenths = std::round(degrees * 10);
  if (kind == DialAxisKind::Rotation) {
    if (tenths == 0) return tr("0 degrees, straight ahead");
    return tenths > 0 ? tr("%1 degrees right").arg(number) : tr("%1 degrees left").arg(number);
  }
  if (tenths == 0) return tr("0 degrees, level");
  return tenths > 0 ? tr("%1 degrees up").arg(number) : tr("%1 degrees down").arg(number);
}

QString DialText::direction(DialAxisKind kind, bool plus) {
  if (kind == DialAxisKind::Rotation) return plus ? tr("right") : tr("left");
  return plus ? tr("up") : tr("down");
}

QString DialText::describe(DialAxisKind kind, const DialAxis& axis) {
  QStringList parts;
  const QString name = title(kind);
  QString first = tr("%1: no data received").arg(name);
  if (axis.reading) {
    switch (*axis.reading) {
      case PositionState::Ok: first = tr("%1: %2").arg(name, angle(kind, axis.degrees)); break;
      case PositionState::SensorError: first = tr("%1: sensor error, no position").arg(name); break;
      case PositionState::NotFitted: first = tr("%1: no position sensor fitted").arg(name); break;
      case PositionState::Invalid: first = tr("%1: invalid position value").arg(name); break;
    }
  }
  if (axis.isStale)
    first = axis.age.isLinkDown() ? tr("%1, before the link went down").arg(first)
            : axis.age.isTimed()  ? tr("%1, stale, %2 old").arg(first, ageText(axis.age.length))
                                  : tr("%1, stale").arg(first);
  parts << first + QLatin1Char('.');

  const QString stop = stops(kind, axis);
  if (!stop.isEmpty()) parts << tr("%1.").arg(stop);
  if (axis.limitLow && axis.limitHigh) {
    const QString low = angle(kind, *axis.limitLow), high = angle(kind, *axis.limitHigh);
    QString limits = axis.isOscillating ? tr("Oscillating between %1 and %2").arg(low, high)
                                        : tr("Soft limits %1 and %2").arg(low, high);
    if (axis.areLimitsStale) limits = tr("%1, stale").arg(limits);
    parts << limits + QLatin1Char('.');
  } else if (axis.limitLow || axis.limitHigh) {
    parts << tr("Soft limit %1.").arg(angle(kind, axis.limitLow ? *axis.limitLow : *axis.limitHigh));
  }
  if (axis.command) {
    const int percent = static_cast<int>(std::lround(std::min(1.0, std::abs(axis.command->speed)) * 100));
    parts << (percent == 0 ? tr("%1 commands no motion.").arg(axis.command->source)
                           : tr("%1 commands %2, %3 percent.")
                                 .arg(axis.command->source, direction(kind, axis.command->speed > 0))
                                 .arg(percent));
  }
  return parts.join(QLatin1Char(' '));
}

QString DialText::description(const DialValues& v) {
  QStringList parts{describe(DialAxisKind::Rotation, v.rotation),
                    describe(DialAxisKind::Elevation, v.elevation), enableLong(v.enable),
                    stowedLong(v.stowed)};
  parts.removeAll(QString());
  return parts.join(QLatin1Char(' '));
}

}  // namespace deckpipe
