// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/device_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "protocol/akron.h"
#include "protocol/catalogue.h"
#include "protocol/device_types.h"
#include "text/catalogue_text.h"

namespace deckpipe {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Device)
};

struct NumberName {
  std::uint32_t number;
  const char* name;
};

// kDeviceTypes once more, for lupdate.
constexpr NumberName kTypes[] = {
    {1032, QT_TRANSLATE_NOOP("DeviceType", "6032 Universal II")},
    {1033, QT_TRANSLATE_NOOP("DeviceType", "6033 Mini Universal")},
    {1034, QT_TRANSLATE_NOOP("DeviceType", "6034 Operator Station")},
    {1035, QT_TRANSLATE_NOOP("DeviceType", "6035 Joystick")},
    {1036, QT_TRANSLATE_NOOP("DeviceType", "6036 Direction Indicator")},
    {1037, QT_TRANSLATE_NOOP("DeviceType", "6037 Wireless Interface")},
    {1040, QT_TRANSLATE_NOOP("DeviceType", "6040 Forestry")},
    {1041, QT_TRANSLATE_NOOP("DeviceType", "6041 Switchbox")},
    {1042, QT_TRANSLATE_NOOP("DeviceType", "6042 Global Platform")},
    {1051, QT_TRANSLATE_NOOP("DeviceType", "6051 CAN Gateway")},
    {1052, QT_TRANSLATE_NOOP("DeviceType", "6052 StreamMaster II")},
};

static_assert(std::ranges::equal(kTypes, kDeviceTypes, [](const NumberName& ours, const auto& theirs) {
  return ours.number == theirs.number && ours.name == theirs.name;
}));

// SAE J1939-81, of the global industry group. Only the one that our sources name.
constexpr NumberName kFunctions[] = {{129, QT_TRANSLATE_NOOP("Function", "off-board service tool")}};
// "3356: Trident"
QString named(std::span<const ValueName> names, std::uint32_t number) {
  const QString name = numberName(names, number);
  return name.isEmpty() ? QString::number(number) : Words::tr("%1: %2").arg(number).arg(name);
}

QString functionName(std::uint32_t function) {
  const auto found = std::ranges::find(kFunctions, function, &NumberName::number);
  return found == std::end(kFunctions) ? QString() : QCoreApplication::translate("Function", found->name);
}

// "1, on-highway equipment"
QString withName(std::uint32_t number, const QString& name) {
  return name.isEmpty()
             ? QString::number(number)
             : Words::tr("%1, %2", "a number and what it means").arg(QString::number(number), name);
}

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

}  // namespace

QString hexText(std::uint8_t number) {
  return QStringLiteral("%1").arg(number, 2, 16, QLatin1Char('0')).toUpper();
}

QString addressText(Address address) { return Words::tr("%1 hex").arg(hexText(address.value)); }

QString reservedUse(Address address) {
  switch (address.value) {
    case 0xF9: return Words::tr("off-board service tool 1");
    case 0xFA: return Words::tr("off-board service tool 2");
    case 0xFB: return Words::tr("data logger");
    default: return {};
  }
}

QString pinText(const Pin& pin) {
  return QString::fromLatin1(pin.text().data(), static_cast<qsizetype>(pin.text().size()));
}

QString deviceTypeText(unsigned type) {
  const auto found = std::ranges::find(kTypes, type, &NumberName::number);
  return found == std::end(kTypes) ? Words::tr("type %1").arg(type, 4, 10, QLatin1Char('0'))
                                   : QCoreApplication::translate("DeviceType", found->name);
}

QString partText(std::uint32_t part) { return named(akron::kParts, part); }

QString styleText(unsigned style) { return named(akron::kStyles, style); }
QString subtypeText(unsigned subtype) { return named(akron::kSubtypes, subtype); }

QString versionText(std::uint16_t version) {
  return QStringLiteral("%1.%2").arg(version >> 8).arg(version & 0xFF);
}

QString makerText(unsigned manufacturerCode) {
  const QString name = numberName(j1939::kManufacturers, manufacturerCode);
  return name.isEmpty() ? Words::tr("other maker, code %1").arg(manufacturerCode) : name;
}

QStringList nameLines(Name name) {
  QStringList lines;
  const bool isGlobal = name.part(fieldOf(j1939::kNameFields, "industry_group").bits) == 0;
  const auto add = [&](std::string_view key) {
    const auto field = std::ranges::find(j1939::kNameFields, key, &Field::key);
    const std::uint32_t number = name.part(field->bits);
    const QString words =
        key == "function" && isGlobal ? functionName(number) : numberName(field->names, number);
    lines << Words::tr("%1: %2").arg(fieldName(*field), withName(number, words));
  };
  lines << Words::tr("Maker: %1").arg(makerText(name.manufacturerCode()));
  for (const std::string_view key : {"identity_number", "function", "function_instance", "ecu_instance",
                                     "industry_group", "vehicle_system", "system_instance"})
    add(key);
  const bool isCapable = name.part(fieldOf(j1939::kNameFields, "arbitrary_address_capable").bits) != 0;
  lines << (isCapable ? Words::tr("Claims another address when it loses its own")
                      : Words::tr("Has one address only"));
  return lines;
}

AxisText axisText(std::optional<unsigned> deviceType, int axis) {
  const DeviceTypeFacts* known = deviceTypeOf(deviceType.value_or(0));
  switch ((known != nullptr ? *known : DeviceTypeFacts{}).axes.at(static_cast<std::size_t>(axis - 1))) {
    case AxisUse::Rotation: return {Words::tr("Rotation"), Words::tr("Right"), Words::tr("Left"), {}};
    case AxisUse::Elevation: return {Words::tr("Elevation"), Words::tr("Up"), Words::tr("Down"), {}};
    case AxisUse::Pattern: return {Words::tr("Pattern"), Words::tr("Stream"), Words::tr("Fog"), {}};
    case AxisUse::DependsOnMonitor:
      return {Words::tr("Axis %1").arg(axis), Words::tr("High | Deploy"), Words::tr("Low | Stow"),
              Words::tr("Axis 4 is monitor specific. Trident Dual Gallonage: flow control, + is high flow. "
                        "DeckMaster: swing arm, + is deploy. Other monitors have none.")};
    case AxisUse::DischargeValve:
      return {Words::tr("Discharge valve"), Words::tr("Open"), Words::tr("Close"), {}};
    case AxisUse::Unnamed: break;
  }
  return {Words::tr("Axis %1").arg(axis), Words::tr("Plus"), Words::tr("Minus"),
          Words::tr("The manual names no use of this axis on this device.")};
}

QString faultName(unsigned bit) {
  const auto found = std::ranges::find(akron::kFaultBits, bit, &ValueName::value);
  return found == akron::kFaultBits.end() ? Words::tr("Reserved bit %1").arg(bit) : wordText(found->word);
}

QString faultRemark(unsigned bit) {
  if (bit >= 17 && bit <= 20) return Words::tr("older manuals: pCode fault %1").arg(bit - 16);
  if (bit == 22) return Words::tr("older manuals: real-time clock");
  return {};
}

QStringList faultLines(std::uint32_t map) {
  QStringList lines;
  for (unsigned bit = 0; bit < 32; ++bit) {
    if ((map >> bit & 1u) == 0) continue;
    const QString remark = faultRemark(bit);
    lines << (remark.isEmpty() ? faultName(bit) : Words::tr("%1 (%2)").arg(faultName(bit), remark));
  }
  return lines;
}

QString pcodeErrorText(unsigned code) {
  const QString name = numberName(akron::kPcodeErrors, code);
  return name.isEmpty() ? Words::tr("Error %1").arg(code) : Words::tr("Error %1: %2").arg(code).arg(name);
}

QString switchName(int number) {
  if (number >= 1 && number <= static_cast<int>(std::size(kSwitches)))
    return QCoreApplication::translate("Switch", kSwitches[number - 1]);
  return Words::tr("Switch %1, reserved").arg(number);
}

QString joystickName(Address source) { return Words::tr("Joystick %1").arg(hexText(source.value)); }

QString priorityText(int priority) {
  if (priority == 0) return Words::tr("1 of 6, the highest on CAN");
  if (priority == 5) return Words::tr("6 of 6, the lowest");
  return Words::tr("%1 of 6").arg(priority + 1);
}

}  // namespace deckpipe
