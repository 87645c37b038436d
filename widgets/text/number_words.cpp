// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue's names of numbers once more, where lupdate finds them. The compiler compares the two.
#include <QCoreApplication>
#include <algorithm>

#include "protocol/catalogue.h"
#include "text/catalogue_text.h"

namespace deckpipe {
namespace {

constexpr const char* kNumberNames[] = {
    QT_TRANSLATE_NOOP("Numbers", "NAME"),
    QT_TRANSLATE_NOOP("Numbers", "Akron Brass"),
    QT_TRANSLATE_NOOP("Numbers", "global"),
    QT_TRANSLATE_NOOP("Numbers", "on-highway equipment"),
    QT_TRANSLATE_NOOP("Numbers", "agricultural and forestry equipment"),
    QT_TRANSLATE_NOOP("Numbers", "construction equipment"),
    QT_TRANSLATE_NOOP("Numbers", "marine"),
    QT_TRANSLATE_NOOP("Numbers", "industrial process control"),
    QT_TRANSLATE_NOOP("Numbers", "rotation sensor error"),
    QT_TRANSLATE_NOOP("Numbers", "Trident"),
    QT_TRANSLATE_NOOP("Numbers", "analog sensors"),
    QT_TRANSLATE_NOOP("Numbers", "Trident with Novotechnik sensors"),
    QT_TRANSLATE_NOOP("Numbers", "Firefox, style 3463, with Novotechnik sensors"),
    QT_TRANSLATE_NOOP("Numbers", "start"),
    QT_TRANSLATE_NOOP("Numbers", "stop"),
    QT_TRANSLATE_NOOP("Numbers", "enter pre-operational"),
    QT_TRANSLATE_NOOP("Numbers", "reset node"),
    QT_TRANSLATE_NOOP("Numbers", "reset communication"),
    QT_TRANSLATE_NOOP("Numbers", "all nodes"),
    QT_TRANSLATE_NOOP("Numbers", "programmed current"),
    QT_TRANSLATE_NOOP("Numbers", "desired state"),
    QT_TRANSLATE_NOOP("Numbers", "programmed velocity"),
    QT_TRANSLATE_NOOP("Numbers", "event status"),
    QT_TRANSLATE_NOOP("Numbers", "network id and bit rate"),
    QT_TRANSLATE_NOOP("Numbers", "trajectory configuration"),
    QT_TRANSLATE_NOOP("Numbers", "position"),
    QT_TRANSLATE_NOOP("Numbers", "velocity"),
    QT_TRANSLATE_NOOP("Numbers", "acceleration"),
    QT_TRANSLATE_NOOP("Numbers", "deceleration"),
    QT_TRANSLATE_NOOP("Numbers", "jerk"),
    QT_TRANSLATE_NOOP("Numbers", "heartbeat time"),
    QT_TRANSLATE_NOOP("Numbers", "network options"),
    QT_TRANSLATE_NOOP("Numbers", "watchdog action"),
    QT_TRANSLATE_NOOP("Numbers", "success"),
    QT_TRANSLATE_NOOP("Numbers", "too much data"),
    QT_TRANSLATE_NOOP("Numbers", "unknown command"),
    QT_TRANSLATE_NOOP("Numbers", "not enough data"),
    QT_TRANSLATE_NOOP("Numbers", "unknown parameter"),
    QT_TRANSLATE_NOOP("Numbers", "out of range"),
    QT_TRANSLATE_NOOP("Numbers", "read only"),
    QT_TRANSLATE_NOOP("Numbers", "unknown axis state"),
    QT_TRANSLATE_NOOP("Numbers", "not on that page"),
    QT_TRANSLATE_NOOP("Numbers", "already moving"),
    QT_TRANSLATE_NOOP("Numbers", "velocity limit"),
    QT_TRANSLATE_NOOP("Numbers", "acceleration limit"),
    QT_TRANSLATE_NOOP("Numbers", "deceleration limit"),
    QT_TRANSLATE_NOOP("Numbers", "jerk limit"),
    QT_TRANSLATE_NOOP("Numbers", "trajectory mode"),
    QT_TRANSLATE_NOOP("Numbers", "CVM program running"),
    QT_TRANSLATE_NOOP("Numbers", "CAN failure"),
    QT_TRANSLATE_NOOP("Numbers", "bad axis"),
    QT_TRANSLATE_NOOP("Numbers", "encoder"),
};

constexpr auto isCalled(std::string_view name) {
  return [name](std::string_view text) { return text == name; };
}
constexpr bool everyNumberOfTheCatalogueIsHere() {
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      for (const ValueName& name : field.names) {
        if (std::ranges::count_if(kNumberNames, isCalled(name.word)) != 1) return false;
      }
    }
  }
  return true;
}
constexpr bool isNumberOfTheCatalogue(std::string_view text) {
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (std::ranges::any_of(field.names, isCalled(text), &ValueName::word)) return true;
    }
  }
  return false;
}
static_assert(everyNumberOfTheCatalogueIsHere(),
              "the name of a number is missing here, or stands here twice");
static_assert(std::ranges::all_of(kNumberNames, isNumberOfTheCatalogue),
              "the catalogue has no number of that name");

}  // namespace

std::span<const char* const> numberNameTexts() { return kNumberNames; }

}  // namespace deckpipe
