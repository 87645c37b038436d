// SPDX-License-Identifier: GPL-3.0-or-later
// The bit rates that are offered, each once. Where to connect and where nothing is heard offer the same list.
#pragma once

#include <QString>
#include <span>

namespace deckpipe {

// bit/s, rising; 0 first: as the interface is set.
std::span<const int> offeredBitRates();
// "250 kbit/s – J1939, the monitors' own bus".
QString bitRateText(int bitRate);

}  // namespace deckpipe
