// SPDX-License-Identifier: GPL-3.0-or-later
// What screen readers are told of widgets that are painted, beside their accessible name and description: what kind
// of thing each is, and its value. Qt knows that of its own widgets alone. Painted buttons need nothing but
// speakPaintedWidgets(): they are buttons, can be pressed, and tell whether they are checked.
#pragma once

#include <QAccessible>
#include <QString>

class QWidget;

namespace deckpipe {

// A place on a scale, for a slider.
struct SpokenValue {
  double least = 0, most = 0, now = 0;
  QString words{};
  friend bool operator==(const SpokenValue&, const SpokenValue&) = default;
};

// Once for the whole program, before a screen reader asks; speakAs() does it too.
void speakPaintedWidgets();
// Before the widget is named: Qt keeps what it is asked first.
void speakAs(QWidget& widget, QAccessible::Role role);
// The words become its description. Readers are told if the value has changed and `isNews`.
void sayValue(QWidget& widget, const SpokenValue& value, bool isNews);

}  // namespace deckpipe
