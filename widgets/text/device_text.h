// SPDX-License-Identifier: GPL-3.0-or-later
// What devices are: types by PIN, part numbers, styles, makers, addresses, NAMEs. Only what the sources name
// is named; any other number stays a number.
#pragma once

#include <QString>
#include <QStringList>

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

}  // namespace deckpipe
