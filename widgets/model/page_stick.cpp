// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_parts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <cstdlib>

#include "state/current.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

struct Stick {
  Q_DECLARE_TR_FUNCTIONS(StickAxis)
};

std::optional<double> fraction(const StickAxis& axis) {
  if (!axis.tenths) return {};
  return *axis.tenths / 1000.0;
}

void place(PageStick& page, const StickAxis& x, const StickAxis& y) {
  page.x = fraction(x);
  page.y = fraction(y);
  page.xText = deflectionText(x, Stick::tr("right"), Stick::tr("left"));
  page.yText = deflectionText(y, Stick::tr("forward"), Stick::tr("back"));
}

}  // namespace

QString deflectionText(const StickAxis& axis, const QString& plus, const QString& minus) {
  if (axis.tenths) {
    const int tenths = *axis.tenths;
    if (tenths == 0) return Stick::tr("neutral");
    const QString percent = QLocale().toString(std::abs(tenths) / 10.0, 'f', 1);
    return Stick::tr("%1 % %2", "45.0 % right").arg(percent, tenths > 0 ? plus : minus);
  }
  const auto both = [&](Status2 s) { return axis.plus == s || axis.minus == s; };
  if (both(Status2::NotAvailable)) return Stick::tr("not fitted");
  if (both(Status2::Error)) return Stick::tr("error");
  return Stick::tr("not valid");
}

PageStick stickOf(const State& state, Channel channel, const Joystick& stick) {
  PageStick page;
  page.title = Stick::tr("Stick");
  page.isStale = isStale(state, channel, stick);
  if (!stick.basic.isKnown()) {
    page.xText = page.yText = Stick::tr("no data");
    return page;
  }
  const BasicJoystick message = stick.basic.value();
  place(page, message.x, message.y);
  page.age = ageOf(state, channel, stick.basic.at);
  return page;
}

PageStick gripOf(const State& state, Channel channel, const Joystick& stick) {
  PageStick page;
  page.title = Stick::tr("Grip");
  page.isStale = isExtendedStale(state, channel, stick);
  const ExtendedJoystick message = stick.extended.value();
  place(page, message.gripX, message.gripY);
  page.thetaText = deflectionText(message.gripTheta, Stick::tr("forward"), Stick::tr("back"));
  page.age = ageOf(state, channel, stick.extended.at);
  return page;
}

namespace {

struct Arbitration {
  Q_DECLARE_TR_FUNCTIONS(Arbitration)
};

PageFact ruleFact(const QString& label, const QString& value, Severity tone = Severity::Plain) {
  return {label, value, tone, {}};
}

PageFact axisFact(const QString& label, const std::optional<DialAxis::Command>& command, Address self,
                  bool isRotation, bool isDown, bool isFiltered) {
  if (isDown) return ruleFact(label, Arbitration::tr("not known, the link is down"), Severity::Unknown);
  if (!command && isFiltered)
    return ruleFact(label, Arbitration::tr("not known, the log was saved through a filter"),
                    Severity::Unknown);
  if (!command) return ruleFact(label, Arbitration::tr("nobody commands"));
  const QString what = commandText(*command, isRotation);
  if (command->from == self)
    return ruleFact(label, Arbitration::tr("this one: %1").arg(what), Severity::Fine);
  return ruleFact(label, Arbitration::tr("%1: %2", "who commands, and what").arg(command->source, what));
}

// "Joystick 34: at rest"
QStringList heard(const State& state, Channel channel, Address from, Address to) {
  const Joysticks& joysticks = state.channel(channel).joysticks;
  QStringList lines;
  for (unsigned a = from.value; a <= to.value; ++a) {
    const Joystick* stick = joysticks.find(Address{static_cast<std::uint8_t>(a)});
    if (stick == nullptr) continue;
    const QString name = joystickName(stick->source);
    if (stick->isFormer || isCutOff(state, channel, stick->basic.at)) {
      lines << Arbitration::tr("%1: not heard since the link went down").arg(name);
      continue;
    }
    if (!stick->isUnderstood()) {
      lines << Arbitration::tr("%1: messages of a wrong length only").arg(name);
      continue;
    }
    if (!stick->isActive()) {
      lines << (state.isFiltered() ? Arbitration::tr("%1: not known, the log was saved through a filter")
                                   : Arbitration::tr("%1: stopped sending"))
                   .arg(name);
      continue;
    }
    const BasicJoystick message = stick->basic.value();
    const bool isAtRest = message.x.tenths.value_or(0) == 0 && message.y.tenths.value_or(0) == 0;
    lines << (isAtRest ? Arbitration::tr("%1: at rest").arg(name)
                       : Arbitration::tr("%1: deflected").arg(name));
  }
  return lines;
}

PageFact listed(const QString& label, const QStringList& lines) {
  return lines.isEmpty() ? ruleFact(label, Arbitration::tr("none heard"))
                         : ruleFact(label, lines.join(QLatin1Char('\n')));
}

Address next(Address a, int step) { return {static_cast<std::uint8_t>(a.value + step)}; }

}  // namespace

PageFactGroup arbitrationOf(const State& state, Channel channelId, const Joystick& stick,
                            const DeviceLabels& labels) {
  PageFactGroup group{QStringLiteral("arbitration"), Arbitration::tr("Who moves what"), {}};
  auto& facts = group.facts;
  if (!stick.priority()) {
    facts.push_back(ruleFact(Arbitration::tr("Moves"),
                             Arbitration::tr("nothing: monitors do not listen to this source by default"),
                             Severity::Warning));
    return group;
  }
  const PageCommands commands = joystickCommands(state, channelId);
  const bool isDown = isLinkDown(state, channelId);
  facts.push_back(axisFact(Arbitration::tr("Rotation"), commands.rotation, stick.source, true, isDown,
                           state.isFiltered()));
  facts.push_back(axisFact(Arbitration::tr("Elevation"), commands.elevation, stick.source, false, isDown,
                           state.isFiltered()));
  facts.push_back(listed(Arbitration::tr("Before it"),
                         QStringList(Arbitration::tr("a 6032's own switches, which no message tells of")) +
                             heard(state, channelId, kFirstJoystick, next(stick.source, -1))));
  facts.push_back(
      listed(Arbitration::tr("After it"), heard(state, channelId, next(stick.source, +1), kLastJoystick)));
  QStringList moved;
  for (const Device& d : state.devices().all()) {
    if (d.kind == Device::Kind::Free || d.kind == Device::Kind::Node || d.channel != channelId) continue;
    if (isMonitor(d)) moved << nameText(keyOf(d), labels);
  }
  if (moved.isEmpty()) moved << Arbitration::tr("no monitor heard on this channel");
  moved << Arbitration::tr("and any that listens without being heard");
  facts.push_back(ruleFact(Arbitration::tr("Moves"), moved.join(QLatin1Char('\n'))));
  return group;
}

PageFactGroup sourcesOf(const State& state, Channel channel) {
  PageFactGroup group{QStringLiteral("sources"), Arbitration::tr("Joystick messages"), {}};
  group.facts.push_back(
      listed(Arbitration::tr("Heard here"), heard(state, channel, kFirstJoystick, kLastJoystick)));
  group.facts.push_back(ruleFact(
      Arbitration::tr("Its own"),
      Arbitration::tr("not known: it sends them from an address of 33 to 38 hex, and none of them says whose "
                      "it is")));
  return group;
}

}  // namespace deckpipe
