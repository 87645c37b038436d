// SPDX-License-Identifier: GPL-3.0-or-later
// The adapters that a person can connect to. The connection page asks for them. A listing may take long, as
// plugins load their maker's library, and it holds serialBusMutex() meanwhile. So ask on a worker thread, and
// not on every tick.
#pragma once

#include <QList>
#include <QString>
#include <cstdint>

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

}  // namespace deckpipe
