// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the state of a network interface on a thread of its own. A question to rtnetlink waits for the
// kernel's network lock, which others can hold for hundreds of milliseconds; the bus thread must not.
//
// 1. One reader per link. Calls and the signal are on the reader's own thread, which needs an event loop.
// 2. Only the newest question is answered. An answer to an older question is thrown away.
// 3. No call waits for the kernel, nor does the destructor. A read that hangs is left to its thread, which
//    keeps what it needs, and ends when the kernel has answered.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <string>

#include "link/can_interface.h"

namespace deckpipe {

class InterfaceReader : public QObject {
  Q_OBJECT
 public:
  using Answer = Result<CanInterface, std::string>;
  // Called on the worker thread; may take its time.
  using Read = std::function<Answer(const std::string& name)>;

  explicit InterfaceReader(Read read, QObject* parent = nullptr);
  ~InterfaceReader() override;

  void request(const std::string& name);
  // No answer comes any more until the next ask().
  void forget();

 Q_SIGNALS:
  // Comes from the event loop, never from inside ask().
  void answered(const deckpipe::InterfaceReader::Answer& answer);

 private:
  struct Desk;

  static void work(Desk& desk, const Read& read);
  void handOver();

  std::shared_ptr<Desk> m_desk;  // shared with the worker thread
  Read m_read;                   // until the worker has it, which starts with the first question
};

}  // namespace deckpipe
