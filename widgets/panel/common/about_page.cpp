// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/about_page.h"

#include <QLibraryInfo>
#include <QPushButton>

#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kTextColumn = 720;

}  // namespace

AboutPage::AboutPage(const AboutFacts& facts, QWidget* parent) : ExtraPage(parent) {
  named(this, "aboutPage", tr("About Deckpipe"));
  auto* inside = new QWidget;
  inside->setMaximumWidth(kTextColumn);
  auto* column = inColumn(inside, {24, 16, 24, 16}, 8, {});
  column->addWidget(makeTitle(inside, "aboutTitle", tr("Deckpipe %1").arg(facts.version)));
  const auto paragraph = [&](const char* name, const QString& text) {
    QLabel* label = makeWords(inside, name, {});
    label->setText(text);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(label);
  };
  paragraph("aboutWhat",
            tr("A diagnostic console for CAN-controlled fire monitors: who is on the bus, where each monitor "
               "points and what stops it, live or from a log."));
  paragraph("aboutLicence",
            tr("Free software under the GNU General Public License, version 3 or later. It comes "
               "without any warranty; do not rely on it where people can be hurt."));
  paragraph("aboutQt", tr("Built on Qt %1 and running with Qt %2, used under the GNU Lesser General Public "
                          "License, version 3.")
                           .arg(QStringLiteral(QT_VERSION_STR), QLibraryInfo::version().toString()));
  paragraph(
      "aboutManuals",
      tr("What messages mean is taken from the makers' manuals: the CAN Messaging manual, the 6051 CAN "
         "Gateway manual, and Copley's note on J1939; beyond them from SAE J1939-81 and CiA 301. Akron and "
         "Copley are names of their owners, who have no part in this program."));
  paragraph("aboutPaths",
            tr("Settings: %1\nLogs larger than memory: %2").arg(facts.settingsPath, facts.spillFolder));
  QPushButton* done = makeDone("aboutDone", tr("Close this page"));
  column->addWidget(done, 0, Qt::AlignLeft);
  column->addStretch(1);
  fillScrolled(this, inside, "aboutScroll");
}

}  // namespace deckpipe
