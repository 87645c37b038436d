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

// kNamedParts once more, for lupdate.
constexpr NumberName kParts[] = {
    {60320014, QT_TRANSLATE_NOOP("Part", "Trident with Novotechnik sensors")},
    {60320022, QT_TRANSLATE_NOOP("Part", "Firefox, style 3463, with Novotechnik sensors")},
};
static_assert(std::ranges::equal(kParts, kNamedParts, [](const NumberName& ours, const ValueName& theirs) {
  return ours.number == theirs.value && ours.name == theirs.word;
}));
// The numbers that the manuals name by example; there are many more that they do not.
constexpr NumberName kStyles[] = {{3356, QT_TRANSLATE_NOOP("Style", "Trident")}};
constexpr NumberName kSubtypes[] = {{14, QT_TRANSLATE_NOOP("Subtype", "analog sensors")}};

// SAE J1939-81. Of the functions only the one that our sources name; the industry groups are all there are.
constexpr NumberName kFunctions[] = {{129, QT_TRANSLATE_NOOP("Function", "off-board service tool")}};
constexpr NumberName kIndustryGroups[] = {
    {0, QT_TRANSLATE_NOOP("IndustryGroup", "global")},
    {1, QT_TRANSLATE_NOOP("IndustryGroup", "on-highway equipment")},
    {2, QT_TRANSLATE_NOOP("IndustryGroup", "agricultural and forestry equipment")},
    {3, QT_TRANSLATE_NOOP("IndustryGroup", "construction equipment")},
    {4, QT_TRANSLATE_NOOP("IndustryGroup", "marine")},
    {5, QT_TRANSLATE_NOOP("IndustryGroup", "industrial process control")},
};

template <std::size_t N>
QString named(const char* context, const NumberName (&names)[N], std::uint32_t number) {
  const auto found = std::ranges::find(names, number, &NumberName::number);
  if (found == std::end(names)) return QString::number(number);
  return Words::tr("%1: %2").arg(number).arg(QCoreApplication::translate(context, found->name));
}

// "1, on-highway equipment"
template <std::size_t N>
QString numberedName(const char* context, const NumberName (&names)[N], std::uint32_t number) {
  const auto found = std::ranges::find(names, number, &NumberName::number);
  if (found == std::end(names)) return QString::number(number);
  return Words::tr("%1, %2", "a number and what it means")
      .arg(QString::number(number), QCoreApplication::translate(context, found->name));
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

QString partText(std::uint32_t part) { return named("Part", kParts, part); }

QString styleText(unsigned style) { return named("Style", kStyles, style); }
QString subtypeText(unsigned subtype) { return named("Subtype", kSubtypes, subtype); }

QString versionText(std::uint16_t version) {
  return QStringLiteral("%1.%2").arg(version >> 8).arg(version & 0xFF);
}

QString makerText(unsigned manufacturerCode) {
  return manufacturerCode == j1939::kAkronManufacturer
             ? Words::tr("Akron Brass")
             : Words::tr("other maker, code %1").arg(manufacturerCode);
}

QStringList nameLines(Name name) {
  QStringList lines;
  const bool isGlobal = name.part(fieldOf(j1939::kNameFields, "industry_group").bits) == 0;
  const auto add = [&](std::string_view key) {
    const auto field = std::ranges::find(j1939::kNameFields, key, &Field::key);
    const std::uint32_t number = name.part(field->bits);
    QString text = QString::number(number);
    if (key == "industry_group") text = numberedName("IndustryGroup", kIndustryGroups, number);
    if (key == "function" && isGlobal) text = numberedName("Function", kFunctions, number);
    lines << Words::tr("%1: %2").arg(fieldName(*field), text);
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
