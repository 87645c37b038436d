// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/send_hint.h"

#include <QPushButton>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "text/service_text.h"

namespace deckpipe {

SendHint::SendHint(const QString& prefix, QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_unlock(new QPushButton(tr("Unlock…"), this)) {
  m_text->setObjectName(prefix + QStringLiteral("Hint"));
  m_text->setAccessibleName(tr("Why nothing can be sent"));
  m_text->setWordWrap(true);
  setInk(*m_text, Ink::Warning);
  m_unlock->setObjectName(prefix + QStringLiteral("Unlock"));
  m_unlock->setAccessibleName(tr("Unlock sending"));
  inRow(this, {{m_text, 1}, m_unlock});
  connect(m_unlock, &QPushButton::clicked, this, &SendHint::unlockRequested);
  hide();
}

void SendHint::setStatus(const ServiceStatus& services, bool isLive, const QString& own,
                         const QString& trouble) {
  QString text = own;
  if (!trouble.isEmpty()) {
    text = trouble;
  } else if (!isLive) {
    text = services.linkUp ? tr("Paused: nothing new is sent while the view stands in the past.")
                           : tr("No live link: what is shown was said in the log.");
  } else if (services.locked) {
    text = tr("Sending is locked: nothing is asked, and nothing acknowledged.");
  } else if (!services.canRequest()) {
    text = tr("The console cannot send yet: %1.").arg(claimText(services.claim));
  }
  setText(*m_text, text);
  m_unlock->setVisible(isLive && services.locked);
  setVisible(!text.isEmpty());
}

}  // namespace deckpipe
