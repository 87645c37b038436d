// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's word on its network interfaces, over rtnetlink: set down, up again, unplugged, bus-off. Qt's
// socketcan plugin tells none of that, so a link has one of these. Linux only; elsewhere it is silent.
//
// The news are read on the thread of the link: a bound multicast socket gives them out without the kernel's
// network lock, so that a loss is known at once whatever holds the lock. Questions need the lock, and go to
// the worker thread of an InterfaceReader.
#pragma once

#include <QObject>

#include <functional>
#include <memory>
#include <string>

#include "link/can_interface.h"

class QSocketNotifier;

namespace deckpipe {

// Reads the state of a network interface on a thread of its own. A question to rtnetlink waits for the
// kernel's network lock, which others can hold for hundreds of milliseconds; the bus thread must not.
//
// 1. One reader per link. Calls and the signal are on the reader's own thread, which needs an event loop.
// 2. Only the newest question is answered. An answer to an older question is thrown away.
// 3. No call waits for the kernel, nor does the destructor. A read that hangs is left to its thread, which
//    keeps what it needs, and ends when the kernel has answered.
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

// Where HardwareFacts learns how its network interface is: from the kernel (InterfaceWatch), or from the
// script of a test. Every call and every signal is on the thread of its link, and no call waits.
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
