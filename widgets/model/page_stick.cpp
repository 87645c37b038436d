// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_stick.h"

#include <QCoreApplication>
#include <QLocale>
#include <cstdlib>

#include "state/current.h"

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

}  // namespace deckpipe
