// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/device_text.h"

#include <QCoreApplication>
#include <algorithm>

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

}  // namespace deckpipe
