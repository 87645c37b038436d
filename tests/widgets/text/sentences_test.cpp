// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences by example: a row of a table for each thing that a person is told.
#include <gtest/gtest.h>

#include <QLocale>

#include "protocol/akron.h"
#include "text/device_text.h"
#include "text/j1939_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct AxisRow {
  const char* name;
  std::optional<unsigned> type;
  int axis;
  const char* axisName;
  const char* plus;
  const char* minus;
};
class AxisNames : public testing::TestWithParam<AxisRow> {};

TEST_P(AxisNames, AreThoseOfTheManual) {
  const AxisRow& row = GetParam();
  const AxisText text = axisText(row.type, row.axis);
  EXPECT_EQ(text.name.toStdString(), row.axisName);
  EXPECT_EQ(text.plus.toStdString(), row.plus);
  EXPECT_EQ(text.minus.toStdString(), row.minus);
}
INSTANTIATE_TEST_SUITE_P(AppendixC, AxisNames,
                         testing::Values(AxisRow{"a6032Axis1", 1032, 1, "Rotation", "Right", "Left"},
                                         AxisRow{"a6032Axis2", 1032, 2, "Elevation", "Up", "Down"},
                                         AxisRow{"a6032Axis3", 1032, 3, "Pattern", "Stream", "Fog"},
                                         AxisRow{"a6032Axis4", 1032, 4, "Axis 4", "High | Deploy",
                                                 "Low | Stow"},
                                         AxisRow{"a6032Axis5", 1032, 5, "Discharge valve", "Open", "Close"},
                                         AxisRow{"a6040Axis3", 1040, 3, "Pattern", "Stream", "Fog"},
                                         AxisRow{"a6040Axis4", 1040, 4, "Discharge valve", "Open", "Close"},
                                         AxisRow{"a6040Axis5", 1040, 5, "Axis 5", "Plus", "Minus"},
                                         AxisRow{"a6042Axis3", 1042, 3, "Pattern", "Stream", "Fog"},
                                         AxisRow{"a6042Axis4", 1042, 4, "Axis 4", "Plus", "Minus"},
                                         AxisRow{"a6052Axis3", 1052, 3, "Pattern", "Stream", "Fog"},
                                         AxisRow{"a6052Axis5", 1052, 5, "Axis 5", "Plus", "Minus"},
                                         AxisRow{"NoTypeAxis1", std::nullopt, 1, "Rotation", "Right", "Left"},
                                         AxisRow{"NoTypeAxis3", std::nullopt, 3, "Axis 3", "Plus", "Minus"}),
                         [](const auto& row) { return std::string(row.param.name); });

struct AgeRow {
  const char* name;
  Duration age;
  const char* brief;
  const char* calm;
};
class Ages : public testing::TestWithParam<AgeRow> {};

TEST_P(Ages, AreShort) {
  EXPECT_EQ(briefAge(GetParam().age).toStdString(), GetParam().brief);
  EXPECT_EQ(calmAge(GetParam().age).toStdString(), GetParam().calm);
}
INSTANTIATE_TEST_SUITE_P(InWords, Ages,
                         testing::Values(AgeRow{"Negative", -3s, "0.0 s", "< 1 s"},
                                         AgeRow{"Tenth", 100ms, "0.1 s", "< 1 s"},
                                         AgeRow{"BelowTen", 9940ms, "9.9 s", "9.9 s"},
                                         AgeRow{"Seconds", 42s, "42 s", "42 s"},
                                         AgeRow{"UpTo99Seconds", 99'999ms, "99 s", "99 s"},
                                         AgeRow{"Minutes", 105s, "1 min 45 s", "1 min 45 s"},
                                         AgeRow{"Hours", 65min, "1 h 05 min", "1 h 05 min"},
                                         AgeRow{"Days", 75h, "3 d 03 h", "3 d 03 h"}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(AgeText, TellsWhatWasNeverHeardFromALogWithoutTimes) {
  EXPECT_EQ(ageText(Age()), QStringLiteral("not heard"));
  EXPECT_EQ(ageText(Age{Age::Kind::NoTimes}), QString());
  EXPECT_EQ(ageText(Age{Age::Kind::NoTimes}, true), QString());
  EXPECT_EQ(ageText(Age::ago(400ms)), QStringLiteral("< 1 s"));
  EXPECT_EQ(ageText(Age::ago(4s), true), QStringLiteral("overdue, 4.0 s"));
  EXPECT_EQ(ageText(Age::linkDown(12s), true), QStringLiteral("link down for 12 s"));
}

TEST(AgeText, SaysPeriods) {
  EXPECT_EQ(periodText(20ms), QStringLiteral("20 ms"));
  EXPECT_EQ(periodText(1500ms), QStringLiteral("1.5 s"));
  EXPECT_EQ(agoText(42s), QStringLiteral("42 s ago"));
}

TEST(FaultText, NamesEveryKnownBitInWords) {
  for (const ValueName& fault : akron::kFaultBits) {
    const QString name = faultName(fault.value);
    EXPECT_FALSE(name.contains(QLatin1Char('_'))) << name.toStdString();
    EXPECT_FALSE(name.startsWith(QStringLiteral("Reserved"))) << name.toStdString();
    EXPECT_TRUE(faultRemark(fault.value).isEmpty());
  }
}

TEST(FaultText, CallsOtherBitsReservedWithWhatOlderManualsSay) {
  EXPECT_EQ(faultName(12), QStringLiteral("Reserved bit 12"));
  EXPECT_EQ(faultLines(1u << 12), QStringList{QStringLiteral("Reserved bit 12")});
  EXPECT_EQ(faultLines(1u << 17 | 1u << 20 | 1u << 21 | 1u << 22),
            (QStringList{QStringLiteral("Reserved bit 17 (older manuals: pCode fault 1)"),
                         QStringLiteral("Reserved bit 20 (older manuals: pCode fault 4)"),
                         QStringLiteral("Internal fuse"),
                         QStringLiteral("Reserved bit 22 (older manuals: real-time clock)")}));
  EXPECT_TRUE(faultLines(0).isEmpty());
}

TEST(FaultText, NamesPcodeError11AndNoOther) {
  EXPECT_EQ(pcodeErrorText(11), QStringLiteral("Error 11: rotation sensor error"));
  EXPECT_EQ(pcodeErrorText(12), QStringLiteral("Error 12"));
}

TEST(DeviceText, NamesOnlyTheNumbersThatTheManualsName) {
  EXPECT_EQ(styleText(3356), QStringLiteral("3356: Trident"));
  EXPECT_EQ(styleText(3463), QStringLiteral("3463"));
  EXPECT_EQ(subtypeText(14), QStringLiteral("14: analog sensors"));
  EXPECT_EQ(subtypeText(0), QStringLiteral("0"));
  EXPECT_EQ(partText(60320014), QStringLiteral("60320014: Trident with Novotechnik sensors"));
  EXPECT_EQ(partText(60320022), QStringLiteral("60320022: Firefox, style 3463, with Novotechnik sensors"));
  EXPECT_EQ(partText(60320023), QStringLiteral("60320023"));
  EXPECT_EQ(deviceTypeText(1099), QStringLiteral("type 1099"));
  EXPECT_EQ(makerText(326), QStringLiteral("Akron Brass"));
  EXPECT_EQ(makerText(123), QStringLiteral("other maker, code 123"));
  EXPECT_EQ(versionText(0x010C), QStringLiteral("1.12"));
}

TEST(DeviceText, SaysAddressesInHex) {
  EXPECT_EQ(addressText({0x0C}), QStringLiteral("0C hex"));
  EXPECT_EQ(reservedUse({0xFA}), QStringLiteral("off-board service tool 2"));
  EXPECT_TRUE(reservedUse({0x80}).isEmpty());
  EXPECT_EQ(pinText(*Pin::parse("1032AE100801035")), QStringLiteral("1032AE100801035"));
}

TEST(J1939Text, NamesGroupsAndSaysWhatAnAddressIsUsuallyFor) {
  const auto name = [](std::uint32_t pgn) {
    const j1939::StandardGroup* group = j1939::standardGroupOf(pgn);
    return group != nullptr ? groupText(*group) : QString();
  };
  EXPECT_EQ(name(61444), QStringLiteral("Electronic engine controller 1 (EEC1)"));
  EXPECT_EQ(name(65265), QStringLiteral("Cruise control / vehicle speed (CCVS)"));
  EXPECT_EQ(name(65280), QStringLiteral("Proprietary B"));
  EXPECT_EQ(name(65535), QStringLiteral("Proprietary B"));
  EXPECT_EQ(name(65279), QString());
  EXPECT_EQ(name(65536), QString()) << "of another data page";
  EXPECT_EQ(usualUse({0}), QStringLiteral("usually engine 1"));
  EXPECT_EQ(usualUse({33}), QStringLiteral("usually body controller"));
  EXPECT_TRUE(usualUse({0x33}).isEmpty()) << "a joystick here";
  EXPECT_TRUE(usualUse({0x80}).isEmpty());
}

TEST(DeviceText, TakesANameApart) {
  const QStringList lines = nameLines({0x9000420028C21A0B});
  EXPECT_EQ(lines.front(), QStringLiteral("Maker: Akron Brass"));
  EXPECT_TRUE(lines.contains(QStringLiteral("Function: 66"))) << lines.join(QLatin1Char('\n')).toStdString();
  EXPECT_TRUE(lines.contains(QStringLiteral("Industry group: 1, on-highway equipment")));
  const Name tool{std::uint64_t{129} << 40};
  EXPECT_TRUE(nameLines(tool).contains(QStringLiteral("Function: 129, off-board service tool")));
  EXPECT_TRUE(nameLines(tool).contains(QStringLiteral("Industry group: 0, global")));
}

TEST(JoystickText, NamesSwitchesAndSources) {
  EXPECT_EQ(switchName(1), QStringLiteral("Stream"));
  EXPECT_EQ(switchName(12), QStringLiteral("CAFS wet"));
  EXPECT_EQ(switchName(13), QStringLiteral("Switch 13, reserved"));
  EXPECT_EQ(joystickName({0x33}), QStringLiteral("Joystick 33"));
  EXPECT_EQ(priorityText(0), QStringLiteral("1 of 6, the highest on CAN"));
  EXPECT_EQ(priorityText(2), QStringLiteral("3 of 6"));
}

}  // namespace
}  // namespace deckpipe
