// SPDX-License-Identifier: GPL-3.0-or-later
// The threads that buses live on: the one of the open source, and those of earlier sources that have still to
// end. Nothing waits for them but waitForEnd(): an adapter's library may hang. A thread that takes longer than
// kThreadPatience to end is given up and left to itself. The session owns this and uses it on its own thread.
#pragma once

#include <QObject>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

class QThread;

namespace deckpipe {

class LiveBus;
struct LogDocument;

class BusThreads : public QObject {
  Q_OBJECT
 public:
  explicit BusThreads(QObject* parent);

  // Puts a worker on the thread of the open source, and calls `start` there. When the thread ends, `stop` is
  // called there and the worker is deleted.
  void start(QObject* worker, std::function<void()> start, std::function<void()> stop);
  // Ends the thread of the open source, and with it `live`, if there is one, which writes into `document`
  // until then. The next start() makes another thread.
  void end(LiveBus* live, const std::shared_ptr<LogDocument>& document);
  // Whether a bus that has not ended, or was given up, may still write there.
  bool isWriting(const std::shared_ptr<LogDocument>& document) const;

  // Calls `then` once each thread has ended, so that the adapter is free, or was given up; at once where that
  // is so. Replaces an earlier `then` that was not called yet.
  void whenEnded(std::function<void()> then);
  void forgetWhenEnded() { m_whenEnded = nullptr; }
  bool isAwaited() const { return m_whenEnded != nullptr; }
  // Waits until each has ended, kThreadPatience at most. For a program that is about to end. Returns, in place of
  // ended(), the documents that no bus writes into any more.
  std::vector<std::shared_ptr<LogDocument>> waitForEnd();

 Q_SIGNALS:
  // No bus writes into that document any more.
  void ended(const std::shared_ptr<LogDocument>& document);

 private:
  struct Ending {
    std::uint64_t number;  // never that of an earlier one
    QThread* thread;
    std::shared_ptr<LogDocument> document;
    bool hangs = false;  // and was given up
  };
  // The document that no bus writes into any more, if that is so.
  std::shared_ptr<LogDocument> forget(std::uint64_t number);
  void hasEnded(std::uint64_t number);
  void hangs(std::uint64_t number);

  QThread* m_open = nullptr;  // deletes what lives on it when it ends
  std::vector<Ending> m_ending;
  std::uint64_t m_number = 0;
  std::function<void()> m_whenEnded;
};

}  // namespace deckpipe
