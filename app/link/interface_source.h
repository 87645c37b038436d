// SPDX-License-Identifier: GPL-3.0-or-later
// Where HardwareFacts learns how its network interface is: from the kernel (InterfaceWatch), or from the
// script of a test. Every call and every signal is on the thread of its link, and no call waits.
#pragma once

#include <QObject>

#include "link/interface_reader.h"

namespace deckpipe {

class InterfaceSource : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  // Asks how the interface of that name is. Only the newest question is answered.
  virtual void request(const std::string& name) = 0;
  // Between start() and stop() the news are told. After stop(), which may come from inside a signal, nothing
  // is told or answered any more.
  virtual void start() = 0;
  virtual void stop() = 0;

 Q_SIGNALS:
  // The answer to ask(). It comes from the event loop, when the kernel has answered, and it may be older than
  // news that came before it.
  void answered(const deckpipe::InterfaceReader::Answer& answer);
  // Something happened to an interface, which may be any of the system. It says everything that was known of
  // the interface at that moment. News come in the order in which things happened; the kernel repeats itself.
  void changed(const deckpipe::CanInterface& facts);
  // More happened than could be told: ask again.
  void overrun();
};

}  // namespace deckpipe
