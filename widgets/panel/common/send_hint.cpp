// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/send_hint.h"

#include <QEvent>
#include <QLayout>
#include <QPushButton>
#include <algorithm>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "text/service_text.h"

namespace deckpipe {

QString SendHint::pausedText() {
  return tr("Paused: nothing new is sent while the view stands in the past.");
}
QString SendHint::noLinkText() { return tr("No live link: what is shown was said in the log."); }
QString SendHint::lockedText() {
  return tr("Sending is locked: nothing is asked, and nothing acknowledged.");
}

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

void SendHint::keepRoom() {
  m_keepsRoom = true;
  QSizePolicy policy = m_unlock->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  m_unlock->setSizePolicy(policy);
  m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  m_text->setVisible(true);
  setVisible(true);
}

// Its height follows from its width and its letters alone. What is longer stands in the tool tip.
bool SendHint::event(QEvent* event) {
  const bool isDone = QWidget::event(event);
  if (!m_keepsRoom) return isDone;
  switch (event->type()) {
    case QEvent::Resize:
    case QEvent::FontChange:
    case QEvent::StyleChange:
    case QEvent::Polish: {
      const int wide = std::max(1, width() - m_unlock->sizeHint().width() - layout()->spacing());
      int high = m_unlock->sizeHint().height();
      for (const QString& sentence : {pausedText(), noLinkText(), lockedText()}) {
        const QRect room(0, 0, wide, QWIDGETSIZE_MAX);
        high = std::max(high, m_text->fontMetrics().boundingRect(room, Qt::TextWordWrap, sentence).height());
      }
      if (high != minimumHeight() || high != maximumHeight()) setFixedHeight(high);
      break;
    }
    default: break;
  }
  return isDone;
}

void SendHint::setStatus(const ServiceStatus& services, bool isLive, const QString& own,
                         const QString& trouble) {
  QString text = own;
  if (!trouble.isEmpty()) {
    text = trouble;
  } else if (!isLive) {
    text = services.linkUp ? pausedText() : noLinkText();
  } else if (services.locked) {
    text = lockedText();
  } else if (!services.canRequest()) {
    text = tr("The console cannot send yet: %1.").arg(claimText(services.claim));
  }
  setText(*m_text, text);
  m_unlock->setVisible(isLive && services.locked);
  m_text->setToolTip(text);
  setVisible(m_keepsRoom || !text.isEmpty());
}

}  // namespace deckpipe
