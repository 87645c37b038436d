// SPDX-License-Identifier: GPL-3.0-or-later
// Looks for adapters on a thread of its own, as makers' libraries and the kernel's network lock take their
// time, and keeps what Linux says of its interfaces up to date while it is asked to. The connection page's
// console side owns one and runs it while the page is seen.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "link/adapters.h"

class QThread;

namespace deckpipe {

class InterfaceWatch;

class AdapterScan : public QObject {
  Q_OBJECT
 public:
  static constexpr std::chrono::seconds kLookAgain{1};

  explicit AdapterScan(QObject* parent = nullptr);
  ~AdapterScan() override;

  // Running, it looks for everything once, then watches the interfaces.
  void setRunning(bool isRunning);
  // Searches for all adapters again.
  void search();

  const AdapterList& list() const { return m_list; }
  bool isSearching() const { return m_isSearching; }
  // Frames came to that interface of Linux between the last two looks.
  bool isHeard(const Adapter& adapter) const;

 Q_SIGNALS:
  void changed();

 private:
  void look();
  void found(AdapterList list);
  void looked(AdapterList list);
  // Puts the question on the worker's thread, and hands over its answer on this one. Answers come in the order
  // in which the questions were put.
  void request(std::function<AdapterList()> question, void (AdapterScan::*answered)(AdapterList));

  AdapterList m_list, m_before;
  bool m_isSearching = false;
  bool m_isLooking = false;
  QThread* m_thread = nullptr;
  QObject* m_worker = nullptr;  // lives on the thread
  std::unique_ptr<InterfaceWatch> m_watch;
  QTimer m_timer;
};

}  // namespace deckpipe
