// SPDX-License-Identifier: GPL-3.0-or-later
// Tells when a network interface changes, goes down, comes up or goes away. Qt's socketcan plugin swallows
// what its socket says of that, so CanLink holds one of these while it is open. Linux only; elsewhere it is
// silent.
#pragma once

#include <QObject>

#include "link/can_interface.h"

class QSocketNotifier;

namespace deckpipe {

class InterfaceWatch : public QObject {
  Q_OBJECT
 public:
  static constexpr int kEvery = 0;

  // Watches the interface of that index, or every one, until destroyed. Needs the event loop of its thread.
  explicit InterfaceWatch(int index, QObject* parent = nullptr);
  ~InterfaceWatch() override;

  // False where the system cannot tell (no rtnetlink).
  bool isWatching() const { return m_socket >= 0; }

 Q_SIGNALS:
  // Everything that is known of it now. The kernel repeats itself; compare before reacting. Where every
  // interface is watched and events were lost, the facts name none: look at all again.
  void changed(const deckpipe::CanInterface& facts);

 private:
  void readEvents();

  int m_index;
  int m_socket = -1;
  QSocketNotifier* m_notifier = nullptr;
};

}  // namespace deckpipe
