// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/glyph_label.h"

#include <QPainter>

#include "paint/app_style.h"

namespace deckpipe {

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

}  // namespace deckpipe
