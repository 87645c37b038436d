// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/dial_readout.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <cmath>

#include "paint/figures.h"

namespace deckpipe {
namespace {}  // namespace

DialReadout::DialReadout(QPainter& painter, const Colours& colours, const QFont& font,
                         const DialLayout& layout)
    : m_painter(painter), m_colours(colours), m_font(font), m_layout(layout) {}

QFont DialReadout::font(double pixels, bool strong) const {
  QFont f = m_font;
  f.setPixelSize(std::max(1, static_cast<int>(pixels)));
  f.setBold(strong);
  return f;
}

void DialReadout::draw(const DialView& view) {
  if (view.radius <= 1) return;
  m_painter.save();
  m_painter.setRenderHint(QPainter::Antialiasing);
  if (!view.title.isNull()) {
    Note note;
    note.bare = true;
    note.textInk = m_colours.textSecondary;
    note.text = DialText::title(view.kind);
    drawNote(view.title, note);
  }
  drawValue(view);
  drawAge(view);
  drawCondition(view);
  drawSource(view);
  m_painter.restore();
}

void DialReadout::drawValue(const DialView& view) {
  const DialAxis& axis = view.axis;
  if (axis.reading == PositionState::Ok) {
    Figures figures;
    figures.number = degreesText(axis.degrees);
    QString widest =
        view.kind == DialAxisKind::Rotation ? QStringLiteral("−888.8°") : QStringLiteral("−88.8°");
    // Beyond what the axis can have, the size may give way: such a number is news enough.
    if (figures.number.size() >= widest.size()) widest = figures.number + QStringLiteral("°");
    figures.unit = QStringLiteral("°");
    // A stale number is also thinner: weight is seen where grey is not.
    figures.numberFont =
        fittedFont(font(m_layout.valueSize, true), m_layout.valueSize, widest, view.value.width(), 9);
    figures.numberFont.setBold(!axis.isStale);
    figures.unitFont = font(figures.numberFont.pixelSize() * 0.8);
    figures.numberColour = axis.isStale ? m_colours.stale.ink : m_colours.text;
    figures.unitColour = axis.isStale ? m_colours.stale.ink : m_colours.textSecondary;
    drawFigures(m_painter, view.value, figures);
    return;
  }
  // In the number's place the reason why there is none, at most two thirds of its size.
  QColor ink = m_colours.textSecondary;
  if (axis.reading == PositionState::SensorError) ink = m_colours.fault.ink;
  if (axis.reading == PositionState::Invalid) ink = m_colours.warning.ink;
  if (!axis.reading || axis.isStale) ink = m_colours.stale.ink;
  const double size = std::max(m_layout.textSize, m_layout.valueSize * 0.66);
  QString text = DialText::reading(axis.reading);
  const QRectF& slot = view.value;
  // Both columns at the size that fits the narrower.
  const double width = std::min(m_layout.rotation.value.width(), m_layout.elevation.value.width());
  const QFont f = fittedFont(font(size, true), size, text, width, m_layout.textSize);
  if (QFontMetricsF(f).horizontalAdvance(text) > slot.width()) text = DialText::readingShort(axis.reading);
  m_painter.setFont(f);
  m_painter.setPen(ink);
  m_painter.drawText(slot, Qt::AlignVCenter | Qt::AlignRight, text);
}

DialReadout::Note DialReadout::ageNote(const DialAxis& axis) const {
  Note note;
  const bool compactSway = axis.isOscillating && (m_layout.compact || m_layout.beside);
  note.bare = !axis.isStale && !compactSway;
  note.glyph = axis.isStale ? Glyph::Stale : Glyph::Oscillating;
  note.ink = note.textInk = axis.isStale ? m_colours.stale.ink : m_colours.textSecondary;
  if (axis.age.isTimed()) note.text = ageText(axis.age.length);
  if (axis.age.isLinkDown()) note.text = DialText::tr("link down");
  if (axis.isStale && !axis.age.isTimed()) note.text = DialText::tr("stale");
  return note;
}

void DialReadout::drawAge(const DialView& view) {
  if (view.age.isNull() || !view.axis.reading) return;
  drawNote(view.age, ageNote(view.axis));
}

void DialReadout::drawCondition(const DialView& view) {
  if (view.condition.isNull()) return;
  const DialAxis& axis = view.axis;
  const QString stops = DialText::stops(view.kind, axis);
  const bool sharesWithAge = view.age.isNull();
  // Old news about a stop is no stop: where both share a place, the age goes first.
  if (sharesWithAge && (axis.isStale || stops.isEmpty())) {
    if (axis.reading) drawNote(view.condition, ageNote(axis));
    return;
  }
  Note note;
  if (stops.isEmpty()) {
    if (!axis.isOscillating) return;
    note.glyph = Glyph::Oscillating;
    note.ink = note.textInk = axis.areLimitsStale ? m_colours.stale.ink : m_colours.textSecondary;
    note.text = DialText::tr("Oscillating");
    drawNote(view.condition, note);
    return;
  }
  const bool on = axis.plusStop == Status2::On || axis.minusStop == Status2::On;
  note.glyph = on ? Glyph::Stop : Glyph::Warning;
  note.ink = note.textInk = axis.isStale ? m_colours.stale.ink : on ? m_colours.text : m_colours.warning.ink;
  note.text = stops;
  QRectF slot = view.condition;
  // Beside it stands who commands; with nobody there the place is free.
  if (!sharesWithAge && !axis.command) slot.setRight(view.source.right());
  drawNote(slot, note);
}

void DialReadout::drawSource(const DialView& view) {
  if (view.source.isNull() || !view.axis.command) return;
  const double speed = view.axis.command->speed;
  Note note;
  note.glyph = speed == 0 ? Glyph::Commanded : Glyph::CommandPlus;
  note.ink = note.textInk = m_colours.text;
  note.text = view.axis.command->source;
  if (speed != 0) {
    if (view.kind == DialAxisKind::Rotation)
      note.turned = speed > 0 ? 0 : 180;
    else
      note.turned = speed > 0 ? -90 : 90;
  }
  drawNote(view.source, note, !m_layout.compact && !m_layout.beside);
}

void DialReadout::drawNote(const QRectF& slot, const Note& note, bool right) {
  const double pixels = m_layout.textSize;
  QFont f = font(pixels);
  const double sign = note.bare ? 0 : std::ceil(QFontMetricsF(f).capHeight() * 1.25);
  const double gap = note.bare ? 0 : std::ceil(pixels * 0.35);
  const double room = slot.width() - sign - gap;
  QString text = note.text;
  // A pixel of size is worth less than half a word.
  if (QFontMetricsF(f).horizontalAdvance(text) > room) f = font(pixels - 1);
  const QFontMetricsF metrics(f);
  if (metrics.horizontalAdvance(text) > room) text = metrics.elidedText(text, Qt::ElideMiddle, room);
  // Two letters and three dots say nothing that the glyph does not.
  if (text.size() < 4 && text != note.text) text.clear();
  const double width = sign + (text.isEmpty() ? 0 : gap + metrics.horizontalAdvance(text));
  double x = right ? slot.right() - width : slot.left();
  const double middle = slot.center().y();
  if (!note.bare) {
    m_painter.save();
    m_painter.translate(x + sign / 2, middle);
    m_painter.rotate(note.turned);
    drawGlyph(m_painter, QRectF(-sign / 2, -sign / 2, sign, sign), note.glyph, note.ink, Qt::transparent,
              m_colours.stroke);
    m_painter.restore();
    x += sign + gap;
  }
  m_painter.setFont(f);
  m_painter.setPen(note.textInk);
  m_painter.drawText(QPointF(x, middle + metrics.capHeight() / 2), text);
}

void DialReadout::drawChips(const DialValues& values) {
  Note note;
  m_painter.save();
  m_painter.setRenderHint(QPainter::Antialiasing);
  note.text = DialText::enable(values.enable);
  if (values.enable == false) {
    note.glyph = Glyph::Locked;
    note.ink = note.textInk = m_colours.warning.onFill;
    drawChip(m_layout.enableChip, note, &m_colours.warning);
  } else if (values.enable == true) {
    note.glyph = Glyph::Fine;
    note.ink = note.textInk = m_colours.fine.ink;
    drawChip(m_layout.enableChip, note, nullptr);
  }
  note.text = DialText::stowed(values.stowed);
  note.glyph = Glyph::Stowed;
  note.ink = note.textInk = m_colours.textSecondary;
  if (!note.text.isEmpty()) drawChip(m_layout.stowedChip, note, nullptr);
  m_painter.restore();
}

void DialReadout::drawChip(const QRectF& slot, const Note& note, const Tone* plate) {
  const double inset = std::ceil(slot.height() * 0.14);
  if (plate) {
    m_painter.setPen(QPen(plate->ink, m_colours.stroke));
    m_painter.setBrush(plate->fill);
    m_painter.drawRoundedRect(slot.adjusted(0.5, 0.5, -0.5, -0.5), inset, inset);
  }
  const QRectF inner = slot.adjusted(inset, 0, -inset, 0);
  if (m_layout.compact)
    drawGlyph(m_painter, plate ? slot.adjusted(inset, inset, -inset, -inset) : slot, note.glyph, note.ink,
              Qt::transparent, m_colours.stroke);
  else
    drawNote(inner, note, &slot == &m_layout.stowedChip && !m_layout.beside);
}

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
