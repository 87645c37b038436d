// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/connection_page.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFileInfo>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/connect/adapter_row.h"

namespace deckpipe {
namespace {

constexpr int kOtherWidth = 400;

// A name, and small below it where and when. Nothing of it is a key to press.
QPushButton* makeRecent(QWidget* parent, const char* name, const QString& what, const QString& facts,
                        const QString& spoken) {
  QString text = facts.isEmpty() ? what : what + QLatin1Char('\n') + facts;
  text.replace(u'&', QLatin1String("&&"));
  auto* made = named(new QPushButton(text, parent), name, spoken);
  made->setAccessibleDescription(facts);
  made->setAutoDefault(true);                                     // Enter presses it
  made->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // a long name widens nothing
  return made;
}

QPushButton* largeButton(QWidget* parent, const char* name, const QString& text) {
  QPushButton* button = makeButton(parent, name, text);
  button->setMinimumHeight(44);
  return button;
}

}  // namespace

ConnectionPage::ConnectionPage(QWidget* parent) : QWidget(parent) {
  named(this, "startPage", tr("Connect"));
  auto* inside = new QWidget;
  inRow(inside, {24, 16, 24, 16}, 32, {{makeBusSide(), 1}, makeOtherSide()});
  fillScrolled(this, inside, "startScroll");
  setOffers({});
  setRecentLogs({});
  setRecentLinks({});
}

// The bus of last time, once its adapter is there; without one, the log of last time.
QWidget* ConnectionPage::likeliest() const {
  const auto firstOf = [](const QLayout* list) -> QWidget* {
    for (int i = 0; i < list->count(); ++i) {
      if (list->itemAt(i)->widget()->isEnabled()) return list->itemAt(i)->widget();
    }
    return nullptr;
  };
  if (QWidget* link = firstOf(m_recentLinks)) return link;
  const bool mayComeYet = m_offers.isSearching && !m_links.empty();
  QWidget* log = mayComeYet ? nullptr : firstOf(m_recent);
  return log != nullptr ? log : m_bitRate;
}

void ConnectionPage::offerFocus() {
  QWidget* before = focusProxy();
  QWidget* now = likeliest();
  if (before == now) return;
  const bool isUntouched = before != nullptr && before == QApplication::focusWidget();
  setFocusProxy(now);
  if (isUntouched) now->setFocus(Qt::TabFocusReason);
}

QWidget* ConnectionPage::makeBusSide() {
  auto* side = new QWidget(this);
  auto* label = new QLabel(tr("&Bit rate:"), side);
  label->setObjectName(QStringLiteral("bitRateLabel"));
  m_bitRate = named(new QComboBox(side), "bitRate", tr("Bit rate of the bus"));
  for (const int bits : offeredBitRates()) m_bitRate->addItem(bitRateText(bits), bits);
  m_bitRate->setMaxVisibleItems(m_bitRate->count());
  label->setBuddy(m_bitRate);
  connect(m_bitRate, &QComboBox::activated, this, [this] { Q_EMIT bitRateChosen(bitRate()); });
  m_linksTitle = makeTitle(side, "recentLinksTitle", tr("Connected before"), 1);
  m_recentLinks = inColumn(4, {});
  m_virtualTitle = makeTitle(side, "virtualTitle", tr("Virtual buses: no truck is on them"), 1);
  m_rows = inColumn(8, {});
  m_none = new AdapterRow(side);
  m_none->setObjectName(QStringLiteral("noAdapters"));
  m_missing = makeWords(side, "missing", tr("What cannot be used here"), Ink::Secondary);
  inColumn(side, {}, 8,
           {makeTitle(side, "busTitle", tr("Connect to a bus")), m_linksTitle, m_recentLinks,
            inRow({label, m_bitRate, LayoutPart::rest()}), m_rows, m_none, m_missing, LayoutPart::rest()});
  return side;
}

QWidget* ConnectionPage::makeOtherSide() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kOtherWidth);
  m_demo = largeButton(side, "startDemo", tr("Start the simulated truck"));
  connect(m_demo, &QPushButton::clicked, this, &ConnectionPage::demoRequested);
  m_open = largeButton(side, "openLog", tr("Open a log…"));
  connect(m_open, &QPushButton::clicked, this, &ConnectionPage::browseRequested);
  m_noLogs = makeWords(side, "noRecentLogs", tr("Recent logs"), Ink::Secondary);
  m_noLogs->setText(tr("Or drop a file on this window. Logs that were opened are listed here."));
  m_recent = inColumn(4, {});
  m_forget = makeButton(side, "forgetLogs", tr("Forget these logs"));
  m_forget->setToolTip(tr("Empties this list; the files stay"));
  m_forget->setFlat(true);
  connect(m_forget, &QPushButton::clicked, this, &ConnectionPage::forgetRequested);
  inColumn(side, {}, 8,
           {makeTitle(side, "demoTitle", tr("Without a bus")),
            m_demo,
            LayoutPart::gap(16),
            makeTitle(side, "logTitle", tr("Logs")),
            m_open,
            m_noLogs,
            m_recent,
            {m_forget, 0, Qt::AlignLeft},
            LayoutPart::rest()});
  return side;
}

AdapterRow* ConnectionPage::makeRow() {
  auto* row = new AdapterRow(this);
  connect(row, &AdapterRow::connectRequested, this, [this, row] {
    Q_EMIT connectRequested(row->offer().plugin, row->offer().interfaceName, bitRate());
  });
  m_rows->addWidget(row);
  return row;
}

void ConnectionPage::setOffers(const AdapterOffers& offers) {
  m_offers = offers;
  // Rows are used again, so that the focus stays where it is while counters run.
  const bool isNew = m_adapters.size() < offers.adapters.size();
  while (m_adapters.size() < offers.adapters.size()) m_adapters.push_back(makeRow());
  if (isNew) orderTabs();
  while (m_adapters.size() > offers.adapters.size()) {
    m_adapters.back()->deleteLater();
    m_adapters.back()->hide();
    m_adapters.pop_back();
  }
  for (std::size_t i = 0; i < offers.adapters.size(); ++i) {
    if (m_adapters[i]->offer() != offers.adapters[i]) m_adapters[i]->setOffer(offers.adapters[i]);
    m_adapters[i]->show();
  }
  const auto firstVirtual = std::ranges::find(offers.adapters, true, &AdapterOffer::isVirtual);
  m_rows->removeWidget(m_virtualTitle);
  m_virtualTitle->setVisible(firstVirtual != offers.adapters.end());
  if (firstVirtual != offers.adapters.end())
    m_rows->insertWidget(static_cast<int>(firstVirtual - offers.adapters.begin()), m_virtualTitle);
  const bool hasNone = offers.adapters.empty();
  m_none->setVisible(hasNone);
  if (hasNone) {
    AdapterOffer none;
    none.title = offers.isSearching ? tr("Looking for adapters …") : tr("No CAN adapter found");
    none.tone = offers.isSearching ? Severity::Busy : Severity::Warning;
    none.state = offers.nothing;
    none.command = offers.command;
    none.canConnect = false;
    m_none->setOffer(none);
  }
  setText(*m_missing, offers.missing);
  m_missing->setVisible(!offers.missing.isEmpty());
  offerFocus();
}

// Rows are made late; the keys come to them where they are seen.
void ConnectionPage::orderTabs() {
  std::vector<QWidget*> order;
  const auto addAll = [&order](const QLayout* list) {
    for (int i = 0; i < list->count(); ++i) order.push_back(list->itemAt(i)->widget());
  };
  addAll(m_recentLinks);
  order.push_back(m_bitRate);
  for (const AdapterRow* row : m_adapters) {
    for (auto* next : row->findChildren<QPushButton*>()) order.push_back(next);
  }
  order.insert(order.end(), {m_demo, m_open});
  addAll(m_recent);
  order.push_back(m_forget);
  for (std::size_t i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
}

void ConnectionPage::setRecentLogs(const std::vector<RecentLog>& logs) {
  if (logs == m_logs && !logs.empty()) return;
  m_logs = logs;
  while (QLayoutItem* item = m_recent->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  for (const RecentLog& log : logs) {
    const QString name = QFileInfo(log.path).fileName();
    const QString shown = fontMetrics().elidedText(log.isGone ? tr("%1 – gone").arg(name) : name,
                                                   Qt::ElideMiddle, kOtherWidth - 40);
    auto* made = makeRecent(this, "recentLog", shown,
                            fontMetrics().elidedText(log.facts, Qt::ElideMiddle, kOtherWidth - 40),
                            tr("Open %1").arg(name));
    made->setToolTip(log.isGone ? tr("%1\nis no longer there").arg(log.path) : log.path);
    made->setEnabled(!log.isGone);
    connect(made, &QPushButton::clicked, this, [this, path = log.path] { Q_EMIT logRequested(path); });
    m_recent->addWidget(made);
    made->show();
  }
  m_noLogs->setVisible(logs.empty());
  m_forget->setVisible(!logs.empty());
  orderTabs();
  offerFocus();
}

void ConnectionPage::setRecentLinks(const std::vector<RecentLink>& links) {
  m_linksTitle->setVisible(!links.empty());
  if (links == m_links) return;
  m_links = links;
  while (QLayoutItem* item = m_recentLinks->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  for (const RecentLink& link : links) {
    auto* made = makeRecent(this, "recentLink", link.interfaceName, link.facts,
                            tr("Connect to %1 as before").arg(link.interfaceName));
    made->setEnabled(link.canConnect);
    if (!link.canConnect) made->setToolTip(tr("It is not there, or not ready, at this moment."));
    connect(made, &QPushButton::clicked, this,
            [this, link] { Q_EMIT connectRequested(link.plugin, link.interfaceName, link.bitRate); });
    m_recentLinks->addWidget(made);
    made->show();
  }
  orderTabs();
  offerFocus();
}

int ConnectionPage::bitRate() const { return m_bitRate->currentData().toInt(); }

void ConnectionPage::setBitRate(int bitRate) {
  const int index = m_bitRate->findData(bitRate);
  if (index >= 0) m_bitRate->setCurrentIndex(index);
}

namespace {

struct BitRates {
  Q_DECLARE_TR_FUNCTIONS(BitRates)
};

constexpr int kOffered[] = {0,       10'000,  20'000,  50'000,  100'000,
                            125'000, 250'000, 500'000, 800'000, 1'000'000};

}  // namespace

std::span<const int> offeredBitRates() { return kOffered; }

QString bitRateText(int bitRate) {
  switch (bitRate) {
    case 0: return BitRates::tr("As the interface is set (SocketCAN)");
    case 125'000: return BitRates::tr("125 kbit/s – CANopen behind the 6051 gateway");
    case 250'000: return BitRates::tr("250 kbit/s – J1939, the monitors' own bus");
    default: return BitRates::tr("%1 kbit/s").arg(bitRate / 1000);
  }
}

}  // namespace deckpipe
