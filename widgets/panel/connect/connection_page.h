// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows while nothing is open: the adapters with their state, the bit rate
// to connect at, the simulated truck, and logs. The console fills in adapters and recent logs and carries out
// what the person chooses. MainWindow handles files that are dropped.
#pragma once

#include <QString>
#include <QWidget>

#include <span>
#include <vector>

#include "panel/connect/adapter_row.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace deckpipe {

// The bit rates that are offered, each once. Where to connect and where nothing is heard offer the same list:
// bit/s, rising; 0 first: as the interface is set.
std::span<const int> offeredBitRates();
// "250 kbit/s – J1939, the monitors' own bus".
QString bitRateText(int bitRate);

class AdapterRow;

struct RecentLog {
  QString path{};
  bool isGone = false;
  QString facts{};  // "~/logs · 30 Nov 2026 14:12 · 1.2 MB"; empty where it is gone
  friend bool operator==(const RecentLog&, const RecentLog&) = default;
};

// A bus that was connected to before.
struct RecentLink {
  QString plugin{};
  QString interfaceName{};
  int bitRate = 0;  // bit/s; 0: as the interface had it
  QString facts{};  // "SocketCAN · 250 kbit/s · 30 Nov 2026 14:12"
  bool canConnect = true;
  friend bool operator==(const RecentLink&, const RecentLink&) = default;
};

class ConnectionPage : public QWidget {
  Q_OBJECT

 public:
  explicit ConnectionPage(QWidget* parent = nullptr);

  void setOffers(const AdapterOffers& offers);
  void setRecentLogs(const std::vector<RecentLog>& logs);
  void setRecentLinks(const std::vector<RecentLink>& links);
  // bit/s; 0: as the interface has it.
  int bitRate() const;
  void setBitRate(int bitRate);

 Q_SIGNALS:
  void connectRequested(const QString& plugin, const QString& interfaceName, int bitRate);
  void demoRequested();
  void browseRequested();
  void logRequested(const QString& path);
  void forgetRequested();
  void bitRateChosen(int bitRate);

 private:
  QWidget* makeBusSide();
  QWidget* makeOtherSide();
  AdapterRow* makeRow();
  void orderTabs();
  // What Enter is most likely meant for has the focus until the person moves it.
  void offerFocus();
  QWidget* likeliest() const;

  AdapterOffers m_offers;
  std::vector<RecentLog> m_logs;
  std::vector<RecentLink> m_links;
  QLabel* m_linksTitle = nullptr;
  QVBoxLayout* m_recentLinks = nullptr;
  QComboBox* m_bitRate = nullptr;
  QVBoxLayout* m_rows = nullptr;
  std::vector<AdapterRow*> m_adapters;
  QLabel* m_virtualTitle = nullptr;  // above the first virtual one
  AdapterRow* m_none = nullptr;
  QLabel* m_missing = nullptr;
  QLabel* m_noLogs = nullptr;
  QPushButton* m_demo = nullptr;
  QPushButton* m_open = nullptr;
  QVBoxLayout* m_recent = nullptr;
  QPushButton* m_forget = nullptr;
};

}  // namespace deckpipe
