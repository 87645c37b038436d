// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/bit_rates.h"

#include <QCoreApplication>

namespace deckpipe {
namespace {

struct BitRates {
  Q_DECLARE_TR_FUNCTIONS(BitRates)
};

constexpr int kOffered[] = {0,       10'000,  20'000,  50'000,  100'000,
                            125'000, 250'000, 500'000, 800'000, 1'000'000};

}  // namespace

std::span<const int> offeredBitRates() { return kOffered; }

QString bitRateText(int bitRate) {
  switch (bitRate) {
    case 0: return BitRates::tr("As the interface is set (SocketCAN)");
    case 125'000: return BitRates::tr("125 kbit/s – CANopen behind the 6051 gateway");
    case 250'000: return BitRates::tr("250 kbit/s – J1939, the monitors' own bus");
    default: return BitRates::tr("%1 kbit/s").arg(bitRate / 1000);
  }
}

}  // namespace deckpipe
