// SPDX-License-Identifier: GPL-3.0-or-later
#include "connection.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <algorithm>

#include "adapter_offers.h"
#include "kept_settings.h"
#include "link/adapters.h"
#include "panel/connect/connection_page.h"

namespace deckpipe {
namespace {

const QString kBitRateKey = QStringLiteral("link/bitRate");

QString whenText(const QDateTime& when) { return QLocale().toString(when, QLocale::ShortFormat); }

// "~/logs"
QString shortFolder(QString folder) {
  const QString home = QDir::homePath();
  if (folder == home || folder.startsWith(home + QLatin1Char('/')))
    folder.replace(0, home.size(), QLatin1Char('~'));
  return folder;
}

}  // namespace

Connection::Connection(QWidget* parent) : QObject(parent), m_page(new ConnectionPage(parent)) {
  m_page->setBitRate(QSettings().value(kBitRateKey, LinkSettings{}.bitRate).toInt());
  m_page->installEventFilter(this);
  connect(&m_scan, &AdapterScan::changed, this, &Connection::showOffers);
  connect(m_page, &ConnectionPage::bitRateChosen, this, &Connection::keepBitRate);
  connect(m_page, &ConnectionPage::forgetRequested, this, [this] {
    forgetLogs();
    showRecentLogs();
  });
  connect(m_page, &ConnectionPage::connectRequested, this,
          [this](const QString& plugin, const QString& interfaceName, int bitRate) {
            Q_EMIT linkRequested({plugin, interfaceName, bitRate, {}});
          });
}

void Connection::keepBitRate(int bitRate) {
  QSettings().setValue(kBitRateKey, bitRate);
  m_page->setBitRate(bitRate);
  showOffers();
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
  const auto isHeard = [this](const Adapter& adapter) { return m_scan.isHeard(adapter); };
  m_page->setOffers(offersOf(m_scan.list(), m_page->bitRate(), m_scan.isSearching(), isHeard));
  std::vector<RecentLink> links;
  for (const KeptLink& kept : recentLinks()) {
    const AdapterOffers then = offersOf(m_scan.list(), kept.bitRate, m_scan.isSearching(), isHeard);
    const bool canConnect = std::ranges::any_of(then.adapters, [&kept](const AdapterOffer& offer) {
      return offer.canConnect && offer.plugin == kept.plugin && offer.interfaceName == kept.interfaceName;
    });
    const QString facts = tr("%1 · %2 · %3", "maker, bit rate, when")
                              .arg(pluginTitle(kept.plugin), bitRateText(kept.bitRate), whenText(kept.when));
    links.push_back({kept.plugin, kept.interfaceName, kept.bitRate, facts, canConnect});
  }
  m_page->setRecentLinks(links);
}

void Connection::showRecentLogs() {
  std::vector<RecentLog> logs;
  for (const QString& path : recentLogs()) {
    const QFileInfo file(path);
    RecentLog log{path, !file.exists(), {}};
    if (!log.isGone)
      log.facts = tr("%1 · %2 · %3", "folder, time, size of a file")
                      .arg(shortFolder(file.absolutePath()), whenText(file.lastModified()),
                           QLocale().formattedDataSize(file.size()));
    logs.push_back(log);
  }
  m_page->setRecentLogs(logs);
}

}  // namespace deckpipe
