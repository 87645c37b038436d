// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/glyph_label.h"

#include <QPainter>

namespace deckpipe {

GlyphLabel::GlyphLabel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("glyph"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void GlyphLabel::setGlyph(std::optional<Glyph> glyph, const QColor& ink, double weight) {
  if (glyph == m_glyph && ink == m_ink && weight == m_weight) return;
  m_glyph = glyph;
  m_ink = ink;
  m_weight = weight;
  update();
}

void GlyphLabel::paintEvent(QPaintEvent*) {
  if (!m_glyph) return;
  QPainter painter(this);
  drawGlyph(painter, QRectF(rect()).adjusted(1, 1, -1, -1), *m_glyph, m_ink, Qt::transparent, m_weight);
}

}  // namespace deckpipe
