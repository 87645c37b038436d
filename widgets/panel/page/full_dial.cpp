// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/full_dial.h"

#include <QEvent>
#include <QKeyEvent>

#include "paint/dial.h"
#include "paint/spoken.h"
#include "panel/common/build.h"
#include "panel/page/page_header.h"

namespace deckpipe {

FullDial::FullDial(QWidget* window)
    : QWidget(window),
      m_header(new PageHeader(this)),
      m_dial(new Dial(this)),
      m_message(makeMessage(this, "fullMessage", {})) {
  speakAs(*this, QAccessible::Pane);
  named(this, "fullDial", tr("Dial over the whole window"));
  setAutoFillBackground(true);
  setFocusPolicy(Qt::StrongFocus);
  m_header->setFullOffered(true);
  m_header->setFull(true);
  m_message->setText(tr("Not heard up to this place of the log."));
  m_message->hide();
  inColumn(this, {0, 0, 0, 0}, 0, {m_header, {m_dial, 1}, {m_message, 1}});
  connect(m_header, &PageHeader::fullRequested, this, &FullDial::closed);
  setGeometry(window->rect());
  window->installEventFilter(this);
}

void FullDial::setPage(const DevicePageValues& page) {
  const bool hasDial = page.isFound && page.dial;
  if (hasDial) {
    m_header->setPage(page);
    m_dial->setValues(*page.dial);
  }
  m_dial->setVisible(hasDial);
  m_message->setVisible(!hasDial);
}

void FullDial::setAnimated(bool animated) { m_dial->setAnimated(animated); }

bool FullDial::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return QWidget::eventFilter(watched, event);
}

void FullDial::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    Q_EMIT closed();
    return;
  }
  QWidget::keyPressEvent(event);
}

void FullDial::mouseDoubleClickEvent(QMouseEvent*) { Q_EMIT closed(); }

}  // namespace deckpipe
