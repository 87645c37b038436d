// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/connection_page.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "paint/app_style.h"
#include "panel/common/label_text.h"
#include "panel/connect/adapter_row.h"

namespace deckpipe {
namespace {

constexpr int kBitRates[] = {10'000, 20'000, 50'000, 100'000, 125'000, 250'000, 500'000, 800'000, 1'000'000};
constexpr int kOtherWidth = 400;

QLabel* title(const QString& text, const char* name, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(QLatin1String(name));
  label->setAccessibleName(text);
  QFont large = label->font();
  large.setPointSizeF(large.pointSizeF() * 1.5);
  large.setWeight(QFont::DemiBold);
  label->setFont(large);
  return label;
}

QLabel* words(const char* name, const QString& accessibleName, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setAccessibleName(accessibleName);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  setInk(*label, Ink::Secondary);
  return label;
}

QPushButton* button(const QString& text, const char* name, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(text);
  made->setMinimumHeight(44);
  return made;
}

}  // namespace

ConnectionPage::ConnectionPage(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("startPage"));
  setAccessibleName(tr("Connect"));
  auto* inside = new QWidget;
  auto* row = new QHBoxLayout(inside);
  row->setContentsMargins(24, 16, 24, 16);
  row->setSpacing(32);
  row->addWidget(makeBusSide(), 1);
  row->addWidget(makeOtherSide());
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName(QStringLiteral("startScroll"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(inside);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  setOffers({});
  setRecentLogs({});
}

QWidget* ConnectionPage::makeBusSide() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(title(tr("Connect to a bus"), "busTitle", side));
  auto* rate = new QHBoxLayout;
  auto* label = new QLabel(tr("&Bit rate:"), side);
  label->setObjectName(QStringLiteral("bitRateLabel"));
  m_bitRate = new QComboBox(side);
  m_bitRate->setObjectName(QStringLiteral("bitRate"));
  m_bitRate->setAccessibleName(tr("Bit rate of the bus"));
  m_bitRate->addItem(tr("J1939, the monitors' own bus – 250 kbit/s"), 250'000);
  m_bitRate->addItem(tr("CANopen behind the 6051 gateway – 125 kbit/s"), 125'000);
  m_bitRate->addItem(tr("As the interface is set (SocketCAN)"), 0);
  m_bitRate->insertSeparator(m_bitRate->count());
  for (const int bits : kBitRates) m_bitRate->addItem(tr("%1 kbit/s").arg(bits / 1000), bits);
  label->setBuddy(m_bitRate);
  connect(m_bitRate, &QComboBox::activated, this, [this] { Q_EMIT bitRateChosen(bitRate()); });
  rate->addWidget(label);
  rate->addWidget(m_bitRate);
  rate->addStretch(1);
  column->addLayout(rate);
  m_rows = new QVBoxLayout;
  m_rows->setSpacing(8);
  column->addLayout(m_rows);
  m_none = new AdapterRow(side);
  m_none->setObjectName(QStringLiteral("noAdapters"));
  column->addWidget(m_none);
  m_missing = words("missing", tr("What cannot be used here"), side);
  column->addWidget(m_missing);
  column->addStretch(1);
  return side;
}

QWidget* ConnectionPage::makeOtherSide() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kOtherWidth);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(title(tr("Without a bus"), "demoTitle", side));
  auto* demo = button(tr("Start the simulated truck"), "startDemo", side);
  connect(demo, &QPushButton::clicked, this, &ConnectionPage::demoRequested);
  column->addWidget(demo);
  column->addSpacing(16);
  column->addWidget(title(tr("Logs"), "logTitle", side));
  auto* open = button(tr("Open a log…"), "openLog", side);
  connect(open, &QPushButton::clicked, this, &ConnectionPage::browseRequested);
  column->addWidget(open);
  m_noLogs = words("noRecentLogs", tr("Recent logs"), side);
  m_noLogs->setText(tr("Or drop a file on this window. Logs that were opened are listed here."));
  column->addWidget(m_noLogs);
  m_recent = new QVBoxLayout;
  m_recent->setSpacing(4);
  column->addLayout(m_recent);
  m_forget = new QPushButton(tr("Forget these logs"), side);
  m_forget->setObjectName(QStringLiteral("forgetLogs"));
  m_forget->setAccessibleName(m_forget->text());
  m_forget->setToolTip(tr("Empties this list; the files stay"));
  m_forget->setFlat(true);
  connect(m_forget, &QPushButton::clicked, this, &ConnectionPage::forgetRequested);
  column->addWidget(m_forget, 0, Qt::AlignLeft);
  column->addStretch(1);
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
}

// Rows are made late; the keys come to them where they are seen.
void ConnectionPage::orderTabs() {
  QWidget* before = m_bitRate;
  for (const AdapterRow* row : m_adapters) {
    for (auto* next : row->findChildren<QPushButton*>()) {
      setTabOrder(before, next);
      before = next;
    }
  }
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
    const QString shown = log.isGone ? tr("%1 – gone").arg(name) : name;
    auto* made = new QPushButton(fontMetrics().elidedText(shown, Qt::ElideMiddle, kOtherWidth - 40), this);
    made->setObjectName(QStringLiteral("recentLog"));
    made->setAccessibleName(tr("Open %1").arg(name));
    made->setToolTip(log.isGone ? tr("%1\nis no longer there").arg(log.path) : log.path);
    made->setEnabled(!log.isGone);
    connect(made, &QPushButton::clicked, this, [this, path = log.path] { Q_EMIT logRequested(path); });
    m_recent->addWidget(made);
  }
  m_noLogs->setVisible(logs.empty());
  m_forget->setVisible(!logs.empty());
}

int ConnectionPage::bitRate() const { return m_bitRate->currentData().toInt(); }

void ConnectionPage::setBitRate(int bitRate) {
  const int index = m_bitRate->findData(bitRate);
  if (index >= 0) m_bitRate->setCurrentIndex(index);
}

}  // namespace deckpipe
