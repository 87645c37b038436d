// SPDX-License-Identifier: GPL-3.0-or-later
// The adapters that a person can connect to. The connection page asks for them. A listing may take long, as
// plugins load their maker's library, and it holds serialBusMutex() meanwhile. So ask on a worker thread, and
// not on every tick.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <mutex>

#include "link/can_interface.h"

namespace deckpipe {

struct Adapter {
  QString plugin;  // copy plugin and interfaceName into LinkSettings
  QString interfaceName;
  QString description;  // in the plugin's words; may be empty, as may be the next two
  QString serialNumber;
  QString alias;
  int channel = 0;
  bool isVirtual = false;
  bool isFlexibleDataRate = false;
  bool isUp = true;           // an interface of Linux that is down must be set up first; others are up
  bool isListenOnly = false;  // as set on an interface of Linux
  std::uint32_t bitRate = 0;  // bit/s it runs at now; 0: not known
  ControllerState controller = ControllerState::Unknown;
  std::uint64_t receivedFrames = 0;  // of an interface of Linux, since it was made
};

struct AdapterPlugin {
  QString plugin;
  QString title;  // the maker
  QString error;  // why it lists nothing, e.g. that a library is missing; empty if all is well
};

struct AdapterList {
  QList<Adapter> adapters;
  QList<AdapterPlugin> plugins;  // all that are installed
};

// Virtualcan's two channels are of its default port; a private bus (VirtualBus) is in no list.
AdapterList listAdapters();

// Brings the facts of Linux's interfaces up to date, and adds and removes interfaces that came and went. Asks
// rtnetlink, which may wait for the kernel's network lock: not on the bus thread.
void refreshInterfaces(AdapterList& list);

// The differences between Qt's CAN plugins, as of Qt 6.4.2. Used by the links and the adapter list.

// QtSerialBus shares things between threads without a lock: QCanBus::instance() makes its singleton and loads
// plugins on first use, and virtualcan's open() touches one server of the whole program. Hold this while
// listing, creating or opening; no callback may come with it held. A listing may hold it for long, so the bus
// thread only tries to lock it.
std::mutex& serialBusMutex();

// The keys of all plugins that are installed, whether their maker's library is there or not. The call waits for
// serialBusMutex().
QStringList installedPlugins();

// The plugin for network interfaces of Linux.
bool isSocketCan(const QString& plugin);

// The first virtualcan device that is opened on a port of this computer makes the program's server of that port. The
// server answers only while the thread that opened the device runs. Opens a device and drops it, so that the server
// lives on the calling thread: call it on one that outlives all links, before each link is opened. Does nothing for
// other plugins, and while somebody else holds serialBusMutex().
void keepServerOnThisThread(const QString& plugin, const QString& interfaceName);

// Whether frames we wrote come back marked once they were on the bus.
// socketcan: yes, by MSG_CONFIRM on our own socket; drivers without IFF_ECHO (slcan, vcan) confirm on queueing. virtualcan: its own 'receive
// own' hands a copy back inside writeFrame() and so proves nothing; but a host that returns frames with the
// local-echo flag is honest, and VirtualBus does: it says so by "?echo" in the interface name. All others: no
// such mark in 6.4.2.
bool pluginEchoes(const QString& plugin, const QString& interfaceName);

// Whether such an echo proves that the frame was on the bus, so surely that a monitor may be moved on it. The bus of the
// simulated truck has no wire. Of Linux's drivers many return a frame before it is sent, and none is known here that
// does not.
bool echoProvesBus(const QString& plugin, const QString& interfaceName);

// Whether the plugin takes BitRateKey. All do but virtualcan, which has no bits; unknown plugins are asked.
bool pluginTakesBitRate(const QString& plugin);

// Whether the plugin stamps frames by the wall clock (CLOCK_REALTIME). socketcan: the kernel does.
// virtualcan: the plugin does, in ms. The others count from a base of their own.
bool pluginStampsWallClock(const QString& plugin);

// The maker's name for a plugin, a proper name: not translated. The key itself for an unknown one.
QString pluginTitle(const QString& plugin);

}  // namespace deckpipe
