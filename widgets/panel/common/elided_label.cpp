// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/elided_label.h"

#include <QPainter>

namespace deckpipe {

ElidedLabel::ElidedLabel(QWidget* parent, Qt::TextElideMode mode) : QLabel(parent), m_mode(mode) {
  setTextFormat(Qt::PlainText);
}

QSize ElidedLabel::minimumSizeHint() const {
  return {fontMetrics().horizontalAdvance(QStringLiteral("Mmm…")), QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, foregroundRole()));
  p.drawText(contentsRect(), static_cast<int>(alignment()) | Qt::TextSingleLine,
             fontMetrics().elidedText(text(), m_mode, contentsRect().width()));
}

}  // namespace deckpipe
