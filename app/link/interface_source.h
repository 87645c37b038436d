// SPDX-License-Identifier: GPL-3.0-or-later
// Where CanLink learns how its network interface is: from the kernel (InterfaceWatch), or from a test's
// script.
#pragma once

#include <QObject>

#include "link/can_interface.h"

namespace deckpipe {

class InterfaceSource : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  // How it is now.
  virtual Result<CanInterface, std::string> read(const std::string& name) = 0;
  // From start() on, until stop(), what happens is told; stop() may come from inside a signal.
  virtual void start() = 0;
  virtual void stop() = 0;

 Q_SIGNALS:
  // Something happened to that interface, which may be any of the system. Everything that was known of it at
  // that moment, in the order in which it happened; the kernel repeats itself.
  void changed(const deckpipe::CanInterface& facts);
  // More happened than could be told: read anew.
  void overrun();
};

}  // namespace deckpipe
