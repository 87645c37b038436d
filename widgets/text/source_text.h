// SPDX-License-Identifier: GPL-3.0-or-later
// Where a meaning comes from: the manual and its section, as the catalogue cites them. For tooltips and help.
#pragma once

#include <QString>

#include "protocol/message.h"

namespace deckpipe {

// "Source: CAN Messaging manual, message type 01; gateway manual, TPDO1". Titles are cited as they are
// printed. Empty for what is no message of the catalogue.
QString sourceText(MessageId id);

}  // namespace deckpipe
