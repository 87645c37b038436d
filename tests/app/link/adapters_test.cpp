// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/adapters.h"

#include <gtest/gtest.h>

#include <QCanBus>
#include <algorithm>

namespace deckpipe {
namespace {

TEST(Adapters, EveryInstalledPluginIsNamed) {
  const AdapterList list = listAdapters();
  ASSERT_EQ(list.plugins.size(), QCanBus::instance()->plugins().size());
  for (const AdapterPlugin& plugin : list.plugins) {
    EXPECT_TRUE(QCanBus::instance()->plugins().contains(plugin.plugin));
    EXPECT_FALSE(plugin.title.isEmpty());
  }
}

TEST(Adapters, VirtualChannelsAreListedWithoutHardware) {
  const AdapterList list = listAdapters();
  QStringList names;
  for (const Adapter& adapter : list.adapters) {
    if (adapter.plugin != QLatin1String("virtualcan")) continue;
    names += adapter.interfaceName;
    EXPECT_TRUE(adapter.isVirtual);
    EXPECT_TRUE(adapter.isUp);
    EXPECT_FALSE(adapter.description.isEmpty());
  }
  EXPECT_EQ(names, (QStringList{QStringLiteral("can0"), QStringLiteral("can1")}));
}

// PEAK's library is in no distribution: where it is missing, its plugin says so instead of listing nothing.
TEST(Adapters, APluginWithoutItsLibrarySaysWhy) {
  const AdapterList list = listAdapters();
  const auto peak = std::find_if(list.plugins.begin(), list.plugins.end(), [](const AdapterPlugin& plugin) {
    return plugin.plugin == QLatin1String("peakcan");
  });
  if (peak == list.plugins.end()) GTEST_SKIP() << "Qt's peakcan plugin is not installed";
  const bool lists = std::any_of(list.adapters.begin(), list.adapters.end(), [](const Adapter& adapter) {
    return adapter.plugin == QLatin1String("peakcan");
  });
  if (lists) GTEST_SKIP() << "a PEAK adapter is there";
  EXPECT_FALSE(peak->error.isEmpty());
}

TEST(Plugins, OnlyWhatReturnsFramesFromTheBusEchoes) {
  const auto echoes = [](const char* plugin, const char* name) {
    return pluginEchoes(QString::fromLatin1(plugin), QString::fromLatin1(name));
  };
  EXPECT_TRUE(echoes("socketcan", "can0"));
  EXPECT_TRUE(echoes("virtualcan", "tcp://127.0.0.1:41234/can0?echo"));
  EXPECT_FALSE(echoes("virtualcan", "tcp://127.0.0.1:41234/can0"));
  EXPECT_FALSE(echoes("virtualcan", "can0"));
  EXPECT_FALSE(echoes("peakcan", "usb0"));
  EXPECT_FALSE(echoes("something", "can0?echo"));
}

}  // namespace
}  // namespace deckpipe
