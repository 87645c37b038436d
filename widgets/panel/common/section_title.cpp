// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/section_title.h"

#include <QFontMetricsF>
#include <QPainter>
#include <cmath>

#include "paint/app_style.h"
#include "paint/figures.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr double kTitleGap = 8;

}  // namespace

SectionTitle::SectionTitle(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("sectionTitle"));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void SectionTitle::setTitle(const QString& title, const QString& remark) {
  if (title == m_title && remark == m_remark) return;
  m_title = title;
  m_remark = remark;
  describe();
  update();
}

void SectionTitle::setAge(const Age& age, bool isStale) {
  const QString text = ageText(age, isStale);
  if (text == m_age && isStale == m_isStale) return;
  m_age = text;
  m_isStale = isStale;
  describe();
  update();
}

void SectionTitle::describe() {
  setAccessibleName(m_remark.isEmpty() ? m_title : tr("%1, %2").arg(m_title, m_remark));
  setAccessibleDescription(m_age);
}

QSize SectionTitle::sizeHint() const {
  const QFontMetricsF metrics(font());
  return {static_cast<int>(std::ceil(metrics.horizontalAdvance(m_title))) + 120,
          std::max(24, static_cast<int>(std::ceil(metrics.height())) + 8)};
}

QSize SectionTitle::minimumSizeHint() const { return {80, sizeHint().height()}; }

void SectionTitle::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  QFont strong = font();
  strong.setWeight(QFont::DemiBold);
  const QFont small = secondaryFont(font());
  const QFontMetricsF strongMetrics(strong), smallMetrics(small);
  const double baseline = height() / 2.0 + strongMetrics.capHeight() / 2 - 1;

  double right = width();
  if (!m_age.isEmpty()) {
    const QColor ink = m_isStale ? c.stale.ink : c.textSecondary;
    const double ageWidth = figuresWidth(small, m_age);
    drawFigures(p, QRectF(0, baseline - smallMetrics.capHeight(), width(), smallMetrics.capHeight()),
                {m_age, {}, small, small, ink, ink});
    right -= ageWidth + kTitleGap;
    if (m_isStale) {
      const double side = 12;
      drawGlyph(p, QRectF(right - side + 2, height() / 2.0 - side / 2 - 1, side, side), Glyph::Stale, ink,
                Qt::transparent, c.stroke);
      right -= side + kTitleGap;
    }
  }
  p.setFont(strong);
  p.setPen(c.text);
  const QString title = strongMetrics.elidedText(m_title, Qt::ElideRight, right);
  p.drawText(QPointF(0, baseline), title);
  const double left = strongMetrics.horizontalAdvance(title) + kTitleGap;
  if (!m_remark.isEmpty() && right - left > 40) {
    p.setFont(small);
    p.setPen(c.textSecondary);
    p.drawText(QPointF(left, baseline), smallMetrics.elidedText(m_remark, Qt::ElideRight, right - left));
  }
  p.setPen(QPen(c.stale.fill, 1));
  p.drawLine(QPointF(0, height() - 0.5), QPointF(width(), height() - 0.5));
}

}  // namespace deckpipe
