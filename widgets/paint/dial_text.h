// SPDX-License-Identifier: GPL-3.0-or-later
// The dial's words: short ones for its texts, whole sentences for who does not see it.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "paint/dial_layout.h"
#include "paint/dial_values.h"

namespace deckpipe {

class DialText {
  Q_DECLARE_TR_FUNCTIONS(DialText)

 public:
  static QString title(DialAxisKind kind);
  // Why there is no value: "Sensor error"; empty for a reading that is Ok. readingShort() fits into 75
  // pixels.
  static QString reading(std::optional<PositionState> reading);
  static QString readingShort(std::optional<PositionState> reading);
  // "Right stop", "Down stop error"; empty where neither stop is on or in error.
  static QString stops(DialAxisKind kind, const DialAxis& axis);
  // nullopt: the device has not said it.
  static QString enable(std::optional<bool> flag);
  static QString stowed(std::optional<bool> flag);
  static QString enableLong(std::optional<bool> flag);
  static QString stowedLong(std::optional<bool> flag);
  // Everything that the dial draws, in sentences.
  static QString description(const DialValues& values);

 private:
  static QString angle(DialAxisKind kind, double degrees);
  static QString direction(DialAxisKind kind, bool plus);
  static QString describe(DialAxisKind kind, const DialAxis& axis);
};

}  // namespace deckpipe
