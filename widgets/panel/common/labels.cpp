// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/labels.h"

#include <QPainter>

#include "model/device_rows.h"
#include "paint/app_style.h"
#include "panel/common/build.h"

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

GlyphLabel::GlyphLabel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("glyph"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void GlyphLabel::setGlyph(std::optional<Glyph> glyph, Ink ink) {
  if (glyph == m_glyph && ink == m_ink) return;
  m_glyph = glyph;
  m_ink = ink;
  update();
}

void GlyphLabel::paintEvent(QPaintEvent*) {
  if (!m_glyph) return;
  QPainter painter(this);
  const Colours& c = coloursOf(this);
  drawGlyph(painter, QRectF(rect()).adjusted(1, 1, -1, -1), *m_glyph, inkOf(c, m_ink), Qt::transparent,
            c.stroke);
}

UntrackedLabel::UntrackedLabel(const QString& objectName, QWidget* parent) : QLabel(parent) {
  setObjectName(objectName);
  setAccessibleName(tr("What is not listed"));
  setWordWrap(true);
  setMargin(8);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  setInk(*this, Ink::Warning);
  hide();
}

void UntrackedLabel::setView(const LogView& view) {
  const QString said = view.state == nullptr ? QString() : untrackedText(*view.state);
  deckpipe::setText(*this, said);
  setVisible(!said.isEmpty());
}

}  // namespace deckpipe
