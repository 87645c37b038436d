// SPDX-License-Identifier: GPL-3.0-or-later
// The fault map and the pCode error code in words. Source: CAN Messaging manual, message type 02; the remark
// on unnamed bits is from older 6032 manuals.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>

namespace deckpipe {

// "Internal fuse"; "Reserved bit 12" for a bit without a name.
QString faultName(unsigned bit);
// What older manuals call an unnamed bit, as a sentence; empty where there is nothing to say.
QString faultRemark(unsigned bit);
// One line a set bit, lowest first, remarks in brackets.
QStringList faultLines(std::uint32_t map);
// "Error 11: rotation sensor error", "Error 7"; codes are the flash codes of each device's own manual, and 11
// is the only one that the sources name.
QString pcodeErrorText(unsigned code);

}  // namespace deckpipe
