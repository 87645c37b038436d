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
  page.isStale = stick.timedOut;
  if (!stick.basic.isKnown()) {
    page.xText = page.yText = Stick::tr("no data");
    return page;
  }
  const BasicJoystick message = stick.basic.value();
  page.x = fraction(message.x);
  page.y = fraction(message.y);
  page.xText = deflectionText(message.x, Stick::tr("right"), Stick::tr("left"));
  page.yText = deflectionText(message.y, Stick::tr("forward"), Stick::tr("back"));
  page.age = now - stick.basic.at;
  return page;
}

}  // namespace deckpipe
