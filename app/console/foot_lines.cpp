// SPDX-License-Identifier: GPL-3.0-or-later
#include "foot_lines.h"

#include <QEvent>
#include <QVBoxLayout>

#include "panel/common/build.h"

namespace deckpipe {

FootLines::FootLines(QWidget* stage) : QWidget(stage->parentWidget()), m_stage(stage) {
  setObjectName(QStringLiteral("footLines"));
  setAutoFillBackground(true);
  inColumn(this, {0, 0, 0, 0}, 0, {});
  stage->installEventFilter(this);
  hide();
}

void FootLines::add(QWidget* line) {
  layout()->addWidget(line);
  line->installEventFilter(this);
}

void FootLines::place() {
  bool isAny = false;
  for (int i = 0; i < layout()->count(); ++i) isAny = isAny || !layout()->itemAt(i)->widget()->isHidden();
  if (isAny) {
    const int height = sizeHint().height();
    setGeometry(m_stage->x(), m_stage->y() + m_stage->height() - height, m_stage->width(), height);
    raise();
  }
  setVisible(isAny);
}

bool FootLines::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) place();
  return QWidget::event(event);
}

bool FootLines::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Resize:
    case QEvent::Move:
      if (watched == m_stage) place();
      break;
    case QEvent::ShowToParent:
    case QEvent::HideToParent:
      if (watched != m_stage) place();
      break;
    default: break;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace deckpipe
