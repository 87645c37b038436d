// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's word on its network interfaces, over rtnetlink: set down, up again, unplugged, bus-off. Qt's
// socketcan plugin tells none of that, so a link has one of these. Linux only; elsewhere it is silent.
//
// The news are read on the thread of the link: a bound multicast socket gives them out without the kernel's
// network lock, so that a loss is known at once whatever holds the lock. Questions need the lock, and go to
// the worker thread of an InterfaceReader.
#pragma once

#include "link/interface_source.h"

class QSocketNotifier;

namespace deckpipe {

class InterfaceWatch : public InterfaceSource {
  Q_OBJECT
 public:
  explicit InterfaceWatch(QObject* parent = nullptr);
  ~InterfaceWatch() override;

  void request(const std::string& name) override;
  // Needs the event loop of its thread. Without rtnetlink nothing will be told.
  void start() override;
  void stop() override;

 private:
  void readEvents();

  InterfaceReader m_reader;
  int m_socket = -1;
  int m_stops = 0;
  QSocketNotifier* m_notifier = nullptr;
};

}  // namespace deckpipe
