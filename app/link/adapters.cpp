// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/adapters.h"

#include <QCanBus>
#include <QCanBusDevice>
#include <QCanBusDeviceInfo>
#include <QUrl>

#include <algorithm>
#include <memory>

#include "link/can_interface.h"

namespace deckpipe {
namespace {

// The plugin leaves out interfaces that are down, which is just when a person needs to see them.
void addKernelFacts(QList<Adapter>& adapters) {
  const QString plugin = QStringLiteral("socketcan");
  for (const CanInterface& link : readCanInterfaces()) {
    const QString name = QString::fromStdString(link.name);
    auto found = std::find_if(adapters.begin(), adapters.end(), [&](const Adapter& adapter) {
      return adapter.plugin == plugin && adapter.interfaceName == name;
    });
    if (found == adapters.end()) {
      Adapter adapter;
      adapter.plugin = plugin;
      adapter.interfaceName = name;
      adapter.isVirtual = link.kind == "vcan" || link.kind == "vxcan";
      adapter.isFlexibleDataRate = link.hasFlexibleDataRate;
      found = adapters.insert(adapters.end(), adapter);
    }
    found->isUp = link.isUp;
    found->isListenOnly = link.isListenOnly;
    found->bitRate = link.bitRate;
    found->controller = link.controller;
    found->receivedFrames = link.receivedFrames;
  }
}

}  // namespace

AdapterList listAdapters() {
  AdapterList list;
  const std::lock_guard lock(serialBusMutex());
  const QCanBus* bus = QCanBus::instance();
  for (const QString& plugin : bus->plugins()) {
    QString error;
    for (const QCanBusDeviceInfo& info : bus->availableDevices(plugin, &error)) {
      Adapter adapter;
      adapter.plugin = plugin;
      adapter.interfaceName = info.name();
      adapter.description = info.description();
      adapter.serialNumber = info.serialNumber();
      adapter.alias = info.alias();
      adapter.channel = info.channel();
      adapter.isVirtual = info.isVirtual();
      adapter.isFlexibleDataRate = info.hasFlexibleDataRate();
      list.adapters.append(adapter);
    }
    list.plugins.append({plugin, pluginTitle(plugin), error});
    if (plugin == QLatin1String("socketcan")) addKernelFacts(list.adapters);
  }
  return list;
}

void refreshInterfaces(AdapterList& list) {
  const QString plugin = QStringLiteral("socketcan");
  const bool hasPlugin = std::any_of(list.plugins.begin(), list.plugins.end(),
                                     [&](const AdapterPlugin& p) { return p.plugin == plugin; });
  if (!hasPlugin) return;
  const std::vector<CanInterface> links = readCanInterfaces();
  list.adapters.removeIf([&](const Adapter& adapter) {
    return adapter.plugin == plugin &&
           std::none_of(links.begin(), links.end(), [&](const CanInterface& link) {
             return QString::fromStdString(link.name) == adapter.interfaceName;
           });
  });
  addKernelFacts(list.adapters);
}

std::mutex& serialBusMutex() {
  static std::mutex mutex;
  return mutex;
}

QStringList installedPlugins() {
  const std::lock_guard lock(serialBusMutex());
  return QCanBus::instance()->plugins();
}

void keepServerOnThisThread(const QString& plugin, const QString& interfaceName) {
  const std::unique_lock lock(serialBusMutex(), std::try_to_lock);
  if (!lock || plugin != QLatin1String("virtualcan")) return;
  const std::unique_ptr<QCanBusDevice> device(QCanBus::instance()->createDevice(plugin, interfaceName));
  if (device != nullptr && device->error() == QCanBusDevice::NoError) device->connectDevice();
}

bool isSocketCan(const QString& plugin) { return plugin == QLatin1String("socketcan"); }

bool pluginEchoes(const QString& plugin, const QString& interfaceName) {
  if (isSocketCan(plugin)) return true;
  return plugin == QLatin1String("virtualcan") && QUrl(interfaceName).query() == QLatin1String("echo");
}

bool echoProvesBus(const QString& plugin, const QString& interfaceName) {
  return !isSocketCan(plugin) && pluginEchoes(plugin, interfaceName);
}

bool pluginTakesBitRate(const QString& plugin) { return plugin != QLatin1String("virtualcan"); }

bool pluginStampsWallClock(const QString& plugin) {
  return plugin == QLatin1String("socketcan") || plugin == QLatin1String("virtualcan");
}

QString pluginTitle(const QString& plugin) {
  static constexpr struct {
    const char* key;
    const char* title;
  } kTitles[] = {
      {"passthrucan", "SAE J2534 Pass-Thru"},
      {"peakcan", "PEAK-System"},
      {"socketcan", "SocketCAN"},
      {"systeccan", "SYS TEC electronic"},
      {"tinycan", "MHS Elektronik Tiny-CAN"},
      {"vectorcan", "Vector Informatik"},
      {"virtualcan", "Qt virtual CAN"},
  };
  for (const auto& row : kTitles) {
    if (plugin == QLatin1String(row.key)) return QString::fromLatin1(row.title);
  }
  return plugin;
}

}  // namespace deckpipe
