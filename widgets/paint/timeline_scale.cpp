// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/timeline_scale.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace deckpipe {
namespace {

constexpr double kBetweenTexts = 14;  // pixels at least
constexpr double kBetweenTicks = 7;
constexpr std::int64_t kSecond = 1'000'000'000, kMinute = 60 * kSecond, kHour = 60 * kMinute,
                       kDay = 24 * kHour;

// In ns, rising.
std::vector<std::int64_t> stepsOf(TimelineUnit unit) {
  std::vector<std::int64_t> steps;
  const auto addDecades = [&steps](std::int64_t first, std::int64_t last) {
    for (std::int64_t decade = first; decade <= last; decade *= 10) {
      for (const std::int64_t factor : {1, 2, 5}) {
        if (decade * factor <= last) steps.push_back(decade * factor);
      }
      if (decade > last / 10) break;
    }
  };
  if (unit == TimelineUnit::Frames) {
    addDecades(kFrameOnScale.count(), 5'000'000'000 * kSecond);
    return steps;
  }
  addDecades(10'000, 5 * kSecond);  // from 10 µs
  for (const std::int64_t step : {10 * kSecond, 30 * kSecond, kMinute, 2 * kMinute, 5 * kMinute, 10 * kMinute,
                                  30 * kMinute, kHour, 3 * kHour, 6 * kHour, 12 * kHour})
    steps.push_back(step);
  addDecades(kDay, 50'000 * kDay);
  return steps;
}

// "0:05", "1:23.50", "1:02:00": hours only where the span has some, as many decimals as the step.
QString timeText(std::int64_t ns, std::int64_t step, bool hasHours) {
  const std::int64_t seconds = ns / kSecond;
  const auto twoDigits = [](std::int64_t number) {
    return QString::number(number).rightJustified(2, QLatin1Char('0'));
  };
  QString text = hasHours ? QStringLiteral("%1:%2:%3")
                                .arg(seconds / 3600)
                                .arg(twoDigits(seconds / 60 % 60))
                                .arg(twoDigits(seconds % 60))
                          : QStringLiteral("%1:%2").arg(seconds / 60).arg(twoDigits(seconds % 60));
  if (step >= kSecond) return text;
  int decimals = 0;
  std::int64_t unit = kSecond;
  while (unit > step) {
    unit /= 10;
    ++decimals;
  }
  return text + QLocale().decimalPoint() +
         QString::number(ns % kSecond / unit).rightJustified(decimals, QLatin1Char('0'));
}

QString textOf(std::int64_t ns, std::int64_t step, TimelineUnit unit, bool hasHours) {
  if (unit == TimelineUnit::Time) return timeText(ns, step, hasHours);
  return QLocale().toString(static_cast<qlonglong>(ns / kFrameOnScale.count()));
}

}  // namespace

std::vector<TimelineTick> timelineTicks(const TimelineGeometry& geometry, Instant zero, TimelineUnit unit,
                                        const std::function<double(const QString&)>& widthOf) {
  const std::int64_t begin = std::max<std::int64_t>(0, (geometry.begin - zero).count());
  const std::int64_t end = std::max<std::int64_t>(begin, (geometry.end - zero).count());
  if (end == begin) return {};
  const double pixels = (geometry.right() - geometry.left()) / static_cast<double>(end - begin);
  const bool hasHours = end >= kHour;
  const std::vector<std::int64_t> steps = stepsOf(unit);
  // Digits are not all as wide in every font.
  const auto widest = [&](std::int64_t step) {
    QString text = textOf(end - end % step, step, unit, hasHours);
    for (QChar& c : text) {
      if (c.isDigit()) c = u'0';
    }
    return widthOf(text);
  };
  auto step = std::ranges::find_if(steps, [&](std::int64_t each) {
    // The first and the last text are moved inwards, into the strip.
    const double width = widest(each);
    return static_cast<double>(each) * pixels >=
           width + kBetweenTexts + std::max(0.0, width / 2 - TimelineGeometry::kInset);
  });
  if (step == steps.end()) --step;
  // The finest step below that all texts stand on, too.
  std::int64_t fine = *step;
  for (auto finer = step; finer != steps.begin();) {
    --finer;
    if (static_cast<double>(*finer) * pixels < kBetweenTicks) break;
    if (*step % *finer == 0) fine = *finer;
  }
  std::vector<TimelineTick> ticks;
  double free = 0;
  const std::int64_t rest = begin % fine;
  for (std::int64_t at = rest == 0 ? begin : saturatedPlus(begin, fine - rest); at <= end;
       at = saturatedPlus(at, fine)) {
    TimelineTick tick{geometry.left() + static_cast<double>(at - begin) * pixels};
    if (at % *step == 0) {
      const QString text = textOf(at, *step, unit, hasHours);
      const double width = widthOf(text);
      const double left = std::clamp(tick.x - width / 2, 0.0, std::max(0.0, geometry.width - width));
      if (ticks.empty() || left >= free) {
        tick.left = left;
        tick.text = text;
        free = left + width + kBetweenTexts - 2;
      }
    }
    ticks.push_back(tick);
    if (at > end - fine) break;
  }
  return ticks;
}

}  // namespace deckpipe
