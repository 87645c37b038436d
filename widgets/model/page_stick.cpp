// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_stick.h"

#include <QCoreApplication>
#include <QLocale>
#include <cstdlib>

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

PageStick stickOf(const Joystick& stick, Instant now) {
  PageStick page;
  page.title = Stick::tr("Stick");
  page.isStale = stick.timedOut;
  if (!stick.basic.isKnown()) {
    page.xText = page.yText = Stick::tr("no data");
    return page;
  }
  const BasicJoystick message = stick.basic.value();
  place(page, message.x, message.y);
  page.age = ageAt(stick.basic.at, now);
  return page;
}

PageStick gripOf(const Joystick& stick, Instant now) {
  PageStick page;
  page.title = Stick::tr("Grip");
  // No time-out of this message is given; with the source's own its grip is old too.
  page.isStale = stick.timedOut || now - stick.extended.at >= kInputTimeout;
  const ExtendedJoystick message = stick.extended.value();
  place(page, message.gripX, message.gripY);
  page.thetaText = deflectionText(message.gripTheta, Stick::tr("forward"), Stick::tr("back"));
  page.age = ageAt(stick.extended.at, now);
  return page;
}

}  // namespace deckpipe
