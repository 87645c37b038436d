// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernel says of its interfaces, over rtnetlink: set down, up again, unplugged, bus-off. Qt's
// socketcan plugin says nothing of all that, so CanLink holds one of these. Linux only; elsewhere it is
// silent.
#pragma once

#include "link/interface_source.h"

class QSocketNotifier;

namespace deckpipe {

class InterfaceWatch : public InterfaceSource {
  Q_OBJECT
 public:
  using InterfaceSource::InterfaceSource;
  ~InterfaceWatch() override;

  Result<CanInterface, std::string> read(const std::string& name) override;
  // Needs the event loop of its thread. Without rtnetlink nothing will be told.
  void start() override;
  void stop() override;

 private:
  void readEvents();

  int m_socket = -1;
  int m_stops = 0;
  QSocketNotifier* m_notifier = nullptr;
};

}  // namespace deckpipe
