// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/plugins.h"

#include <QCanBus>
#include <QCanBusDevice>
#include <QUrl>
#include <memory>

namespace deckpipe {

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
