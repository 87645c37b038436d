// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/typed_place.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <optional>

#include "model/log_clock.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct TypedPlaceText {
  Q_DECLARE_TR_FUNCTIONS(TypedPlace)
};
using Place = Result<TypedPlace, QString>;

constexpr double kLongest = 9e9;  // seconds that 64 bits of nanoseconds hold

Failure<QString> failure(const QString& sentence) { return {sentence}; }

Duration secondsOf(double seconds) { return Duration{std::llround(std::min(seconds, kLongest) * 1e9)}; }

QString dateTimeText(const QDateTime& time) { return time.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")); }

QString clockRange(const LogClock& clock) {
  const QString time = QStringLiteral("HH:mm:ss");
  return clock.spansDays()
             ? TypedPlaceText::tr("%1 to %2").arg(dateTimeText(clock.first()), dateTimeText(clock.last()))
             : TypedPlaceText::tr("%1 to %2").arg(clock.first().toString(time), clock.last().toString(time));
}

// What was typed in the way of a number: one decimal sign, a plain minus.
QString plainNumbers(QString text) {
  return text.replace(u',', u'.').replace(QChar(0x2212), u'-').simplified();
}

// Groups of digits, as QRegularExpression found them.
struct Colons {
  bool hasHours = false;
  double hours = 0, minutes = 0, seconds = 0;
  double total() const { return (hours * 60 + minutes) * 60 + seconds; }
};

std::optional<Colons> colonsOf(const QString& text) {
  static const QRegularExpression form(QStringLiteral(R"(^(?:(\d{1,9}):)?(\d{1,9}):(\d{1,2}(?:\.\d*)?)$)"));
  const auto match = form.match(text);
  if (!match.hasMatch()) return {};
  return Colons{match.hasCaptured(1) && !match.captured(1).isEmpty(), match.captured(1).toDouble(),
                match.captured(2).toDouble(), match.captured(3).toDouble()};
}

// "83.5", "83.5 s", "1 h 2 min 3 s", "200 ms"
std::optional<Duration> unitsOf(const QString& text) {
  static const QRegularExpression number(QStringLiteral(R"(^(?:\d+\.?\d*|\.\d+)$)"));
  if (number.match(text).hasMatch()) return secondsOf(text.toDouble());
  static const QRegularExpression part(
      QStringLiteral(R"(\G\s*(\d+\.?\d*|\.\d+)\s*(ms|s|sec|min|m|h|d)(?![a-z])\s*)"),
      QRegularExpression::CaseInsensitiveOption);
  double seconds = 0;
  qsizetype at = 0;
  while (at < text.size()) {
    const auto match = part.match(text, at);
    if (!match.hasMatch()) return {};
    const QString unit = match.captured(2).toLower();
    const double factor = unit == QLatin1String("ms")  ? 0.001
                          : unit == QLatin1String("h") ? 3600
                          : unit == QLatin1String("d") ? 86400
                          : unit.startsWith(u'm')      ? 60
                                                       : 1;
    seconds += match.captured(1).toDouble() * factor;
    at = match.capturedEnd();
  }
  return at == 0 ? std::nullopt : std::optional(secondsOf(seconds));
}

std::optional<Duration> typedLength(const QString& text) {
  if (const auto colons = colonsOf(text)) return secondsOf(colons->total());
  return unitsOf(text);
}

QString notUnderstood(const QString& typed, const LogView& view) {
  return TypedPlaceText::tr("“%1” is no time. %2").arg(typed, placeHelp(view));
}

QString outside(const LogView& view, const LogClock& clock) {
  const QString end = elapsedText(view.end - view.begin);
  return clock.hasDates()
             ? TypedPlaceText::tr(
                   "The log does not have this time: it goes from 0:00:00 to %1, by the clock %2.")
                   .arg(end, clockRange(clock))
             : TypedPlaceText::tr("The log does not have this time: it goes from 0:00:00 to %1.").arg(end);
}

std::optional<Instant> instantSince(const LogView& view, Duration length) {
  if (length > view.end - view.begin) return {};
  return view.begin + length;
}

std::optional<QTime> timeOfDay(const Colons& colons) {
  // Minutes without hours are hours without seconds here: "14:03".
  const double hours = colons.hasHours ? colons.hours : colons.minutes;
  const double minutes = colons.hasHours ? colons.minutes : colons.seconds;
  const double seconds = colons.hasHours ? colons.seconds : 0;
  if (hours > 23 || minutes > 59 || minutes != std::floor(minutes)) return {};
  return QTime(static_cast<int>(hours), static_cast<int>(minutes))
      .addMSecs(static_cast<int>(std::lround(seconds * 1000)));
}

Place placeOfColons(const Colons& colons, const QString& typed, const LogView& view, const LogClock& clock) {
  if (colons.seconds >= 60 || (colons.hasHours && colons.minutes >= 60))
    return failure(TypedPlaceText::tr("“%1” is no time: minutes and seconds go from 0 to 59.").arg(typed));
  const auto elapsed = instantSince(view, secondsOf(colons.total()));
  if (elapsed && !colons.hasHours) return TypedPlace(*elapsed);
  const auto time = timeOfDay(colons);
  const std::vector<QDate> dates = time ? clock.datesOf(*time) : std::vector<QDate>();
  if (dates.empty()) return elapsed ? Place(TypedPlace(*elapsed)) : Place(failure(outside(view, clock)));
  const QString dated = dateTimeText(QDateTime(dates.front(), *time));
  if (elapsed)
    return failure(
        TypedPlaceText::tr("The log has %1 since its begin and by the clock: write “%2 s” or “%3”.")
            .arg(typed, QString::number(colons.total(), 'g', 15), dated));
  if (dates.size() > 1)
    return failure(
        TypedPlaceText::tr("The log has this time on several days: write the date too, as in “%1”.")
            .arg(dated));
  return TypedPlace(*clock.at(QDateTime(dates.front(), *time)));
}

Place placeOfDate(const QRegularExpressionMatch& match, const QString& typed, const LogView& view,
                  const LogClock& clock) {
  const QDate date(match.captured(1).toInt(), match.captured(2).toInt(), match.captured(3).toInt());
  const auto colons = colonsOf(match.captured(4));
  const auto time = colons ? timeOfDay(*colons) : std::nullopt;
  if (!date.isValid() || !time || colons->seconds >= 60) return failure(notUnderstood(typed, view));
  if (const auto at = clock.at(QDateTime(date, *time))) return TypedPlace(*at);
  return failure(outside(view, clock));
}

Place placeOfFrame(const QString& typed, const LogView& view) {
  const QString text =
      QString(typed).remove(QLocale().groupSeparator()).remove(u' ').replace(QChar(0x2212), u'-');
  static const QRegularExpression form(QStringLiteral(R"(^([+-]?)(\d{1,18})$)"));
  const auto match = form.match(text);
  if (!match.hasMatch())
    return failure(TypedPlaceText::tr("“%1” is no frame. %2").arg(typed, placeHelp(view)));
  const auto number = match.captured(2).toULongLong();
  const std::uint64_t here = view.cursor.frames;
  const bool isBack = match.captured(1) == QLatin1String("-");
  const std::uint64_t frame = match.captured(1).isEmpty() ? number
                              : !isBack                   ? here + number
                                                          : here - std::min<std::uint64_t>(here, number);
  if (frame == 0 || frame > view.frameCount)
    return failure(TypedPlaceText::tr("The log does not have this frame: its frames are 1 to %1.")
                       .arg(QLocale().toString(static_cast<qulonglong>(view.frameCount))));
  return TypedPlace(frame);
}

}  // namespace

Place placeOf(const QString& typed, const LogView& view) {
  const QString text = plainNumbers(typed);
  if (!view.hasTimes()) return placeOfFrame(typed, view);
  const LogClock clock(view);
  if (text.startsWith(u'+') || text.startsWith(u'-')) {
    const auto length = typedLength(text.mid(1).trimmed());
    if (!length) return failure(notUnderstood(typed, view));
    const Instant here = std::clamp(view.cursor.time, view.begin, std::max(view.begin, view.end));
    const Instant to = text.startsWith(u'+') ? here + *length : here - *length;
    if (to < view.begin || to > view.end) return failure(outside(view, clock));
    return TypedPlace(to);
  }
  static const QRegularExpression dated(QStringLiteral(R"(^(\d{4})-(\d{1,2})-(\d{1,2})(?:\s+|T)(\S+)$)"));
  if (const auto match = dated.match(text); match.hasMatch()) return placeOfDate(match, typed, view, clock);
  if (const auto colons = colonsOf(text)) return placeOfColons(*colons, typed, view, clock);
  const auto length = unitsOf(text);
  if (!length) return failure(notUnderstood(typed, view));
  const auto at = instantSince(view, *length);
  return at ? Place(TypedPlace(*at)) : Place(failure(outside(view, clock)));
}

QString placeHelp(const LogView& view) {
  if (!view.hasTimes())
    return TypedPlaceText::tr("Write the number of a frame, 1 to %1, or a way from here, as in +5 or −2.")
        .arg(QLocale().toString(static_cast<qulonglong>(view.frameCount)));
  const LogClock clock(view);
  const QString plain = TypedPlaceText::tr("Write 1:23.5 or 83.5 s since the begin, or +5 or −0.2 from here");
  return clock.hasDates()
             ? TypedPlaceText::tr("%1, or a time of the clock, %2.").arg(plain, clockRange(clock))
             : TypedPlaceText::tr("%1.").arg(plain);
}

}  // namespace deckpipe
