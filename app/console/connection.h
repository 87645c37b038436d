// SPDX-License-Identifier: GPL-3.0-or-later
// The connection page's other half: looks for adapters while the page is seen, fills in adapters and recent
// logs, and remembers what a person chose last. The main window shows its page and opens what it asks for.
#pragma once

#include <QObject>

#include "link/can_link.h"
#include "session/adapter_scan.h"

namespace deckpipe {

class ConnectionPage;

class Connection : public QObject {
  Q_OBJECT
 public:
  explicit Connection(QWidget* parent);

  ConnectionPage* page() const { return m_page; }
  // A person chose it, on the page or elsewhere.
  void keepBitRate(int bitRate);

 Q_SIGNALS:
  void linkRequested(const deckpipe::LinkSettings& settings);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showOffers();
  void showRecentLogs();

  ConnectionPage* m_page;
  AdapterScan m_scan;
};

}  // namespace deckpipe
