// SPDX-License-Identifier: GPL-3.0-or-later
#include "connection.h"

#include <QEvent>
#include <QFileInfo>
#include <QSettings>

#include "adapter_offers.h"
#include "kept_settings.h"
#include "panel/connect/connection_page.h"

namespace deckpipe {
namespace {

const QString kBitRateKey = QStringLiteral("link/bitRate");

}  // namespace

Connection::Connection(QWidget* parent) : QObject(parent), m_page(new ConnectionPage(parent)) {
  m_page->setBitRate(QSettings().value(kBitRateKey, LinkSettings{}.bitRate).toInt());
  m_page->installEventFilter(this);
  connect(&m_scan, &AdapterScan::changed, this, &Connection::showOffers);
  connect(m_page, &ConnectionPage::bitRateChosen, this, [this](int bitRate) {
    QSettings().setValue(kBitRateKey, bitRate);
    showOffers();
  });
  connect(m_page, &ConnectionPage::forgetRequested, this, [this] {
    forgetLogs();
    showRecentLogs();
  });
  connect(m_page, &ConnectionPage::connectRequested, this,
          [this](const QString& plugin, const QString& interfaceName, int bitRate) {
            Q_EMIT linkRequested({plugin, interfaceName, bitRate, {}});
          });
}

bool Connection::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_page && event->type() == QEvent::Show) {
    showRecentLogs();
    showOffers();
    m_scan.setRunning(true);
  }
  if (watched == m_page && event->type() == QEvent::Hide) m_scan.setRunning(false);
  return QObject::eventFilter(watched, event);
}

void Connection::showOffers() {
  m_page->setOffers(offersOf(m_scan.list(), m_page->bitRate(), m_scan.isSearching(),
                             [this](const Adapter& adapter) { return m_scan.isHeard(adapter); }));
}

void Connection::showRecentLogs() {
  std::vector<RecentLog> logs;
  for (const QString& path : recentLogs()) logs.push_back({path, !QFileInfo::exists(path)});
  m_page->setRecentLogs(logs);
}

}  // namespace deckpipe
