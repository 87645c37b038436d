// SPDX-License-Identifier: GPL-3.0-or-later
// What SAE J1939 calls groups and addresses that are not decoded here, in the person's language
// (protocol/j1939_names.h).
#pragma once

#include <QString>

#include "protocol/j1939_names.h"

namespace deckpipe {

// "Electronic engine controller 1 (EEC1)".
QString groupText(const j1939::StandardGroup& group);
// "usually engine 1"; empty for an address without a usual use. No proof of what is there.
QString usualUse(Address address);

}  // namespace deckpipe
