// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/dock_title.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QFontMetricsF>
#include <QPainter>

#include <cmath>

#include "paint/app_style.h"
#include "paint/figures.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "text/time_text.h"

namespace deckpipe {

class DockTitle::Button : public QAbstractButton {
 public:
  enum class Sign { Float, Close };

  Button(Sign sign, QWidget* parent) : QAbstractButton(parent), m_sign(sign) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    setFocusPolicy(Qt::NoFocus);  // by keyboard the View menu does it
    setAttribute(Qt::WA_Hover);
  }

  QSize sizeHint() const override { return {targetHeight(this), targetHeight(this)}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override {
    const Colours& c = coloursOf(this);
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    if (underMouse()) {
      p.setPen(QPen(c.outline, 1));
      p.setBrush(isDown() ? c.surfaceAlternate : c.surface);
      p.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), 4, 4);
    }
    p.translate(QRectF(rect()).center());
    p.setPen(QPen(c.textSecondary, 1.5 * c.stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.setBrush(Qt::NoBrush);
    if (m_sign == Sign::Close) {
      p.drawLine(QPointF(-4, -4), QPointF(4, 4));
      p.drawLine(QPointF(-4, 4), QPointF(4, -4));
    } else {  // a sheet lifted off another
      p.drawRect(QRectF(-2, -5, 7, 7));
      p.drawPolyline(QPolygonF{QPointF(-5, -1), QPointF(-5, 5), QPointF(1, 5)});
    }
  }

 private:
  Sign m_sign;
};

DockTitle::DockTitle(QDockWidget* dock)
    : QWidget(dock),
      m_float(new Button(Button::Sign::Float, this)),
      m_close(new Button(Button::Sign::Close, this)) {
  setObjectName(dock->objectName() + QStringLiteral("Title"));
  auto* name = new ElidedLabel(this);
  name->setText(dock->windowTitle());
  m_float->setObjectName(dock->objectName() + QStringLiteral("Float"));
  m_float->setToolTip(tr("Take out of the window, or put back"));
  m_float->setAccessibleName(tr("%1: take out of the window, or put back").arg(dock->windowTitle()));
  m_close->setObjectName(dock->objectName() + QStringLiteral("Close"));
  m_close->setToolTip(tr("Close; the View menu opens it again"));
  m_close->setAccessibleName(tr("%1: close").arg(dock->windowTitle()));
  connect(m_float, &QAbstractButton::clicked, dock, [dock] { dock->setFloating(!dock->isFloating()); });
  connect(m_close, &QAbstractButton::clicked, dock, &QWidget::close);

  inRow(this, {8, 0, 0, 0}, 0, {{name, 1}, m_float, m_close});
  dock->setTitleBarWidget(this);
}

void DockTitle::setCollapsed(bool isCollapsed) {
  if (isCollapsed == m_isCollapsed) return;
  m_isCollapsed = isCollapsed;
  for (QWidget* child : findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) child->setVisible(!isCollapsed);
  updateGeometry();
}

QSize DockTitle::sizeHint() const {
  return m_isCollapsed ? QSize(0, 0) : QSize(QWidget::sizeHint().width(), targetHeight(this));
}

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
