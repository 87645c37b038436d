// SPDX-License-Identifier: GPL-3.0-or-later
#include "start_page.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace deckpipe {
namespace {

QPushButton* bigButton(const QString& text, const char* name, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QLatin1String(name));
  button->setMinimumSize(320, 48);
  return button;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("startPage"));
  auto* title = new QLabel(tr("Nothing is open"), this);
  title->setObjectName(QStringLiteral("startTitle"));
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 1.8);
  title->setFont(large);
  auto* log = bigButton(tr("Open a log…"), "openLog", this);
  auto* demo = bigButton(tr("Start the simulated truck"), "startDemo", this);
  auto* adapter = new QLabel(tr("For a bus, set its interface up and start Deckpipe with its name:\n\n"
                                "    sudo ip link set can0 up type can bitrate 250000 listen-only on\n"
                                "    deckpipe --interface can0"),
                             this);
  adapter->setObjectName(QStringLiteral("adapterHint"));
  adapter->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(16);
  layout->addStretch(1);
  for (QWidget* widget : {static_cast<QWidget*>(title), static_cast<QWidget*>(log),
                          static_cast<QWidget*>(demo), static_cast<QWidget*>(adapter)}) {
    layout->addWidget(widget, 0, Qt::AlignHCenter);
  }
  layout->addStretch(2);
  connect(log, &QPushButton::clicked, this, &StartPage::logRequested);
  connect(demo, &QPushButton::clicked, this, &StartPage::demoRequested);
}

}  // namespace deckpipe
