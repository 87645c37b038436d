// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/adapter_offers.h"

#include <gtest/gtest.h>

namespace deckpipe {
namespace {

Adapter canInterface(bool isUp, std::uint32_t bitRate = 0) {
  Adapter adapter;
  adapter.plugin = QStringLiteral("socketcan");
  adapter.interfaceName = QStringLiteral("can0");
  adapter.isUp = isUp;
  adapter.bitRate = bitRate;
  return adapter;
}
AdapterList listOf(QList<Adapter> adapters) {
  return {std::move(adapters), {{QStringLiteral("socketcan"), QStringLiteral("SocketCAN"), {}}}};
}
AdapterOffers offers(const AdapterList& list, int bitRate = 250'000, bool isHeard = false) {
  return offersOf(list, bitRate, false, [isHeard](const Adapter&) { return isHeard; });
}

TEST(AdapterOffers, SayWhetherFramesAreHeard) {
  const auto heard = offers(listOf({canInterface(true, 250'000)}), 250'000, true).adapters.at(0);
  EXPECT_EQ(heard.state.toStdString(), "up at 250 kbit/s, frames are heard now");
  EXPECT_EQ(heard.tone, Severity::Fine);
  EXPECT_TRUE(heard.canConnect);
  EXPECT_EQ(offers(listOf({canInterface(true, 250'000)})).adapters.at(0).tone, Severity::Unknown);
}

TEST(AdapterOffers, GiveTheCommandThatSetsAnInterfaceUp) {
  const auto offer = offers(listOf({canInterface(false)}), 125'000).adapters.at(0);
  EXPECT_FALSE(offer.canConnect);
  EXPECT_EQ(offer.command.toStdString(), "sudo ip link set can0 up type can bitrate 125000 listen-only on");
}

TEST(AdapterOffers, DoNotConnectAtAnotherRateThanTheInterfaceRunsAt) {
  const auto offer = offers(listOf({canInterface(true, 500'000)})).adapters.at(0);
  EXPECT_FALSE(offer.canConnect);
  EXPECT_EQ(offer.command.toStdString(),
            "sudo ip link set can0 down; sudo ip link set can0 up type can bitrate 250000 listen-only on");
  EXPECT_TRUE(offers(listOf({canInterface(true, 500'000)}), 0).adapters.at(0).canConnect);
}

TEST(AdapterOffers, SayWhatIsMissing) {
  AdapterList list = listOf({});
  list.plugins.append(
      {QStringLiteral("peakcan"), QStringLiteral("PEAK-System"), QStringLiteral("no library")});
  const AdapterOffers none = offers(list);
  EXPECT_TRUE(none.adapters.empty());
  EXPECT_TRUE(none.missing.contains(QStringLiteral("PEAK-System: no library")));
  EXPECT_FALSE(none.nothing.isEmpty());
  EXPECT_TRUE(offers({}).missing.contains(QStringLiteral("not installed")));
}

TEST(AdapterOffers, PutVirtualBusesLast) {
  Adapter simulated = canInterface(true);
  simulated.plugin = QStringLiteral("virtualcan");
  simulated.isVirtual = true;
  const auto all = offers(listOf({simulated, canInterface(true, 250'000)})).adapters;
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].plugin, QStringLiteral("virtualcan"));
  EXPECT_TRUE(all[1].isVirtual);
}

TEST(AdapterOffers, PutWhatCanBeConnectedToFirst) {
  Adapter down = canInterface(false), up = canInterface(true, 250'000);
  up.interfaceName = QStringLiteral("can7");
  const auto all = offers(listOf({down, up})).adapters;
  EXPECT_EQ(all[0].interfaceName, QStringLiteral("can7"));
  EXPECT_FALSE(all[1].canConnect);
}

}  // namespace
}  // namespace deckpipe
