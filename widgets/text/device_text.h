// SPDX-License-Identifier: GPL-3.0-or-later
// What devices are and say: types by PIN, part numbers, styles, makers, addresses, NAMEs, axes, faults,
// switches. Only what the sources name is named; any other number stays a number.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>

#include "base/ids.h"
#include "protocol/typed.h"

namespace deckpipe {

// Two upper-case hex digits: "80".
QString hexText(std::uint8_t number);
// "80 hex"
QString addressText(Address address);
// What J1939 reserves an address for: "off-board service tool 1"; empty for any other.
QString reservedUse(Address address);
QString pinText(const Pin& pin);

// "6032 Universal II"; "type 1099" for one that the manual does not name.
QString deviceTypeText(unsigned type);
// "60320014: Trident with Novotechnik sensors"; the number alone where it has no name.
QString partText(std::uint32_t part);
QString styleText(unsigned style);      // "3356: Trident"
QString subtypeText(unsigned subtype);  // "14: analog sensors"
// "1.5" of major << 8 | minor.
QString versionText(std::uint16_t version);

// "Akron Brass"; "other maker, code 123".
QString makerText(unsigned manufacturerCode);
// One line a part: "Maker: Akron Brass (326)", …
QStringList nameLines(Name name);

// What the five axes of a position / limit status are on which device, and what their two sides are called.
// Source: CAN Messaging manual, Appendix C. Whoever shows stops by axis asks here.
inline constexpr int kAxes = 5;

struct AxisText {
  QString name;    // "Pattern"
  QString plus;    // "Stream"
  QString minus;   // "Fog"
  QString remark;  // what else is to be known of it; often empty
};

// `axis` 1..5; `deviceType` the first four digits of a PIN, nothing where they are not known. All devices of
// the manual use axes 1 and 2 alike, and the message itself calls them rotation and elevation, so these have
// their names without a type too. What the manual leaves open is 'Axis n' with plain signs.
AxisText axisText(std::optional<unsigned> deviceType, int axis);

// The fault map and the pCode error code in words. Source: CAN Messaging manual, message type 02; the remark
// on unnamed bits is from older 6032 manuals.
//
// "Internal fuse"; "Reserved bit 12" for a bit without a name.
QString faultName(unsigned bit);
// What older manuals call an unnamed bit, as a sentence; empty where there is nothing to say.
QString faultRemark(unsigned bit);
// One line a set bit, lowest first, remarks in brackets.
QStringList faultLines(std::uint32_t map);
// "Error 11: rotation sensor error", "Error 7"; codes are the flash codes of each device's own manual, and 11
// is the only one that the sources name.
QString pcodeErrorText(unsigned code);

// What the switches and sources of a joystick are called. Source: CAN Messaging manual, Appendix B.
//
// What a monitor does on switch 1..16: "Stream"; "Switch 13, reserved".
QString switchName(int number);
// "Joystick 33": how a source is called where it commands.
QString joystickName(Address source);
// "Priority 1 of 6, the highest CAN source"; `priority` 0 for 33 hex .. 5 for 38 hex.
QString priorityText(int priority);

}  // namespace deckpipe
