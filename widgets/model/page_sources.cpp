// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_sources.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

#include "protocol/catalogue.h"
#include "text/catalogue_text.h"

namespace deckpipe {
namespace {

struct Meaning {
  Q_DECLARE_TR_FUNCTIONS(PageMeaning)
};

// What it means and what to check, by the manuals. Null where the words themselves say it.
constexpr EnumTable<PageGroup, const char*> kMeanings{{
    {PageGroup::Health,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "Fine is said of what was heard, was asked for its faults, and can act. Each line tells what "
         "keeps it from that; its tip, what to check.")},
    {PageGroup::Dial,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "Where the monitor stands by its own position sensors, never by what is commanded. Right and up "
         "are positive; the band is the travel between the soft limits.")},
    {PageGroup::Stops,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "On: the axis stands at its end and goes no further that way, which is no fault. Error: the "
         "device reports the stop itself in error; check its sensing and cable.")},
    {PageGroup::Status,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "With an operational error the panel LED blinks a code: ask for its faults, and look the code up in "
         "the device's own manual.")},
    {PageGroup::Outputs,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "What the controller says of itself. With enable off, CAN goes on and nothing moves. In SOE mode "
         "it moves while a permissive comes.")},
    {PageGroup::Riser, nullptr},
    {PageGroup::Inputs, nullptr},
    {PageGroup::Permissive,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "The directions that a master controller allows. It comes every 100 ms and ends 300 ms after the "
         "last one; without it a monitor in SOE mode stays where it is.")},
    {PageGroup::Switches, nullptr},
    {PageGroup::Detents, nullptr},
    {PageGroup::Grip, nullptr},
    {PageGroup::Joystick,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "Of the sources 33 to 38 hex the lowest number goes before, axis by axis, while it deflects that "
         "axis. After 200 ms without a message its input is cleared.")},
    {PageGroup::Faults,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "What the device answered last when it was asked. Look up codes in its own manual; when the cause "
         "is mended, ask again.")},
    {PageGroup::Versions, nullptr},
    {PageGroup::Node, nullptr},
    {PageGroup::Address,
     QT_TRANSLATE_NOOP(
         "PageMeaning",
         "A device is known by its PIN; its address may go to another. Of two that claim one, the lower "
         "NAME keeps it.")},
}};

}  // namespace

QString pageGroupKey(PageGroup group) {
  const std::string_view key = kPageGroupKeys[group];
  return QString::fromLatin1(key.data(), static_cast<qsizetype>(key.size()));
}

QString pageSourceText(const QString& groupKey) {
  const auto group = std::ranges::find(kAllOf<PageGroup>, groupKey, pageGroupKey);
  if (group == kAllOf<PageGroup>.end()) return {};
  QStringList lines;
  if (const char* meaning = kMeanings[*group]; meaning != nullptr) lines << Meaning::tr(meaning);
  for (const Message& message : kCatalogue) {
    if (message.page.has(*group)) lines.append(sourceText(message.id));
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace deckpipe
