// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/joystick_text.h"

#include <QCoreApplication>

#include "text/device_text.h"

namespace deckpipe {
namespace {

constexpr const char* kSwitches[] = {
    QT_TRANSLATE_NOOP("Switch", "Stream"),
    QT_TRANSLATE_NOOP("Switch", "Fog"),
    QT_TRANSLATE_NOOP("Switch", "Discharge on"),
    QT_TRANSLATE_NOOP("Switch", "Oscillate on | set"),
    QT_TRANSLATE_NOOP("Switch", "Flow high"),
    QT_TRANSLATE_NOOP("Switch", "Flow low"),
    QT_TRANSLATE_NOOP("Switch", "Oscillate pause | resume"),
    QT_TRANSLATE_NOOP("Switch", "Deploy"),
    QT_TRANSLATE_NOOP("Switch", "Stow"),
    QT_TRANSLATE_NOOP("Switch", "Discharge off"),
    QT_TRANSLATE_NOOP("Switch", "CAFS dry"),
    QT_TRANSLATE_NOOP("Switch", "CAFS wet"),
};

struct Stick {
  Q_DECLARE_TR_FUNCTIONS(Stick)
};

}  // namespace

QString switchName(int number) {
  if (number >= 1 && number <= static_cast<int>(std::size(kSwitches)))
    return QCoreApplication::translate("Switch", kSwitches[number - 1]);
  return Stick::tr("Switch %1, reserved").arg(number);
}

QString joystickName(Address source) { return Stick::tr("Joystick %1").arg(hexText(source.value)); }

QString priorityText(int priority) {
  if (priority == 0) return Stick::tr("1 of 6, the highest on CAN");
  if (priority == 5) return Stick::tr("6 of 6, the lowest");
  return Stick::tr("%1 of 6").arg(priority + 1);
}

}  // namespace deckpipe
