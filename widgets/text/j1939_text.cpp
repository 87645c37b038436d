// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/j1939_text.h"

#include <QCoreApplication>
#include <algorithm>

namespace deckpipe {
namespace {

struct J1939Text {
  Q_DECLARE_TR_FUNCTIONS(J1939Text)
};

// The names once more, where lupdate finds them. The compiler compares the two.
constexpr const char* kGroupNames[] = {
    QT_TRANSLATE_NOOP("J1939Group", "Torque / speed control 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Acknowledgement"),
    QT_TRANSLATE_NOOP("J1939Group", "Transport, data"),
    QT_TRANSLATE_NOOP("J1939Group", "Transport, connection management"),
    QT_TRANSLATE_NOOP("J1939Group", "Proprietary A"),
    QT_TRANSLATE_NOOP("J1939Group", "Electronic retarder controller 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Electronic brake controller 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Electronic transmission controller 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Electronic engine controller 2"),
    QT_TRANSLATE_NOOP("J1939Group", "Electronic engine controller 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Electronic transmission controller 2"),
    QT_TRANSLATE_NOOP("J1939Group", "Active diagnostic trouble codes"),
    QT_TRANSLATE_NOOP("J1939Group", "Previously active diagnostic trouble codes"),
    QT_TRANSLATE_NOOP("J1939Group", "Clear previously active trouble codes"),
    QT_TRANSLATE_NOOP("J1939Group", "Diagnostic readiness 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Clear active trouble codes"),
    QT_TRANSLATE_NOOP("J1939Group", "Commanded address"),
    QT_TRANSLATE_NOOP("J1939Group", "Software identification"),
    QT_TRANSLATE_NOOP("J1939Group", "Electronic engine controller 3"),
    QT_TRANSLATE_NOOP("J1939Group", "Vehicle distance"),
    QT_TRANSLATE_NOOP("J1939Group", "Engine hours, revolutions"),
    QT_TRANSLATE_NOOP("J1939Group", "Time / date"),
    QT_TRANSLATE_NOOP("J1939Group", "Fuel consumption (liquid)"),
    QT_TRANSLATE_NOOP("J1939Group", "Component identification"),
    QT_TRANSLATE_NOOP("J1939Group", "Vehicle identification"),
    QT_TRANSLATE_NOOP("J1939Group", "Cruise control / vehicle speed setup"),
    QT_TRANSLATE_NOOP("J1939Group", "Engine temperature 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Engine fluid level / pressure 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Power take-off information"),
    QT_TRANSLATE_NOOP("J1939Group", "Cruise control / vehicle speed"),
    QT_TRANSLATE_NOOP("J1939Group", "Fuel economy (liquid)"),
    QT_TRANSLATE_NOOP("J1939Group", "Vehicle position"),
    QT_TRANSLATE_NOOP("J1939Group", "Ambient conditions"),
    QT_TRANSLATE_NOOP("J1939Group", "Intake / exhaust conditions 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Vehicle electrical power 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Transmission fluids 1"),
    QT_TRANSLATE_NOOP("J1939Group", "Dash display"),
    QT_TRANSLATE_NOOP("J1939Group", "Proprietary B"),
};
constexpr const char* kAddressNames[] = {
    QT_TRANSLATE_NOOP("J1939Address", "engine 1"),
    QT_TRANSLATE_NOOP("J1939Address", "engine 2"),
    QT_TRANSLATE_NOOP("J1939Address", "transmission 1"),
    QT_TRANSLATE_NOOP("J1939Address", "transmission 2"),
    QT_TRANSLATE_NOOP("J1939Address", "power take-off, main or rear"),
    QT_TRANSLATE_NOOP("J1939Address", "brake system controller"),
    QT_TRANSLATE_NOOP("J1939Address", "engine retarder"),
    QT_TRANSLATE_NOOP("J1939Address", "driveline retarder"),
    QT_TRANSLATE_NOOP("J1939Address", "cruise control"),
    QT_TRANSLATE_NOOP("J1939Address", "steering controller"),
    QT_TRANSLATE_NOOP("J1939Address", "instrument cluster 1"),
    QT_TRANSLATE_NOOP("J1939Address", "electrical charging system"),
    QT_TRANSLATE_NOOP("J1939Address", "electrical system"),
    QT_TRANSLATE_NOOP("J1939Address", "body controller"),
    QT_TRANSLATE_NOOP("J1939Address", "power take-off, front or secondary"),
    QT_TRANSLATE_NOOP("J1939Address", "off-vehicle gateway"),
    QT_TRANSLATE_NOOP("J1939Address", "management computer 1"),
    QT_TRANSLATE_NOOP("J1939Address", "cab display 1"),
    QT_TRANSLATE_NOOP("J1939Address", "suspension controller 1"),
    QT_TRANSLATE_NOOP("J1939Address", "cab controller, primary"),
    QT_TRANSLATE_NOOP("J1939Address", "cab controller, secondary"),
    QT_TRANSLATE_NOOP("J1939Address", "exhaust emission controller"),
    QT_TRANSLATE_NOOP("J1939Address", "chassis controller 1"),
    QT_TRANSLATE_NOOP("J1939Address", "chassis controller 2"),
};
static_assert(std::ranges::equal(
    kGroupNames, j1939::kStandardGroups, {}, [](const char* name) { return std::string_view(name); },
    &j1939::StandardGroup::name));
static_assert(std::ranges::equal(
    kAddressNames, j1939::kPreferredAddresses, {}, [](const char* name) { return std::string_view(name); },
    &j1939::PreferredAddress::name));

}  // namespace

QString groupText(const j1939::StandardGroup& group) {
  const QString name =
      QCoreApplication::translate("J1939Group", kGroupNames[&group - j1939::kStandardGroups.data()]);
  if (group.acronym.empty()) return name;
  const QString acronym =
      QString::fromLatin1(group.acronym.data(), static_cast<qsizetype>(group.acronym.size()));
  return J1939Text::tr("%1 (%2)", "name and acronym of a J1939 group").arg(name, acronym);
}

QString usualUse(Address address) {
  const auto found =
      std::ranges::find(j1939::kPreferredAddresses, address.value, &j1939::PreferredAddress::address);
  if (found == j1939::kPreferredAddresses.end()) return {};
  const char* name = kAddressNames[found - j1939::kPreferredAddresses.begin()];
  return J1939Text::tr("usually %1", "what is at a J1939 address")
      .arg(QCoreApplication::translate("J1939Address", name));
}

}  // namespace deckpipe
