// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the network interface under a link while the link is open. CanLink owns one where its adapter is an
// interface of Linux.
//
// 1. The kernel's news are told at once. It sends no news of the controller's state and counters, so the
//    interface is also read every kPeriod, and soon after an error frame.
// 2. News that come while a question is out may be newer than its answer: the answer is then dropped and the
//    question asked again.
// 3. While a device is bound to an interface, that interface counts, by its index and under any name.
//    Otherwise the interface of the given name counts.
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "link/interface_watch.h"

namespace deckpipe {

class HardwareFacts : public QObject {
  Q_OBJECT
 public:
  static constexpr std::chrono::milliseconds kPeriod{1'000};
  static constexpr std::chrono::milliseconds kAfterError{100};

  HardwareFacts(std::string name, std::unique_ptr<InterfaceSource> source, QObject* parent);

  // From now on it tells, first of all how the interface is. stop() may come from inside a signal.
  void start();
  void stop();
  // A device was connected to the interface last learned of, or was dropped.
  void setBound(bool isBound);
  // An error frame came: the controller's state may have changed.
  void readSoon();

 Q_SIGNALS:
  void learned(const deckpipe::CanInterface& facts);
  // After start(): there is no interface of that name. A sentence of the system.
  void missing(const QString& reason);
  // The interface that a device is bound to was removed.
  void removed();
  // The driver of the bound interface lost so many frames more.
  void lost(std::uint32_t frames);

 private:
  void request();
  void answered(const InterfaceReader::Answer& answer);
  void changed(const CanInterface& facts);
  void learn(const CanInterface& facts);
  void countOverruns(const CanInterface& facts);
  void remove();

  std::string m_name;
  std::unique_ptr<InterfaceSource> m_source;
  QTimer m_timer;
  std::optional<CanInterface> m_known;
  bool m_isBound = false;
  bool m_isOvertaken = false;  // news came since the question
  bool m_hasMissedNews = false;
  bool m_isFirst = true;         // nothing was told yet since start()
  std::uint64_t m_overruns = 0;  // of the bound interface, as last told
  int m_stops = 0;
};

}  // namespace deckpipe
