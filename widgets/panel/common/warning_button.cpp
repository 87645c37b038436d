// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/warning_button.h"

#include <QIconEngine>
#include <QPainter>
#include <QPointer>

#include "paint/app_style.h"
#include "paint/glyph.h"

namespace deckpipe {
namespace {

constexpr double kLine = 1.5, kCorner = 2.5, kInset = 1;

class WarningSign : public QIconEngine {
 public:
  explicit WarningSign(const QWidget* on) : m_on(on) {}

  void paint(QPainter* painter, const QRect& box, QIcon::Mode mode, QIcon::State) override {
    const Colours& colours = coloursOf(m_on);
    drawGlyph(*painter, QRectF(box).adjusted(1, 1, -1, -1), Glyph::Warning,
              mode == QIcon::Disabled ? colours.stale.ink : colours.warning.ink);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap drawn(size);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return drawn;
  }
  QIconEngine* clone() const override { return new WarningSign(m_on); }

 private:
  QPointer<const QWidget> m_on;
};

}  // namespace

QIcon warningIcon(const QWidget* on) { return QIcon(new WarningSign(on)); }

WarningButton::WarningButton(const QString& text, QWidget* parent) : QPushButton(text, parent) {
  setIcon(warningIcon(this));
}

void WarningButton::paintEvent(QPaintEvent* event) {
  QPushButton::paintEvent(event);
  const Colours& colours = coloursOf(this);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(isEnabled() ? colours.warning.ink : colours.outline, kLine * colours.stroke));
  painter.drawRoundedRect(QRectF(rect()).adjusted(kInset, kInset, -kInset, -kInset), kCorner, kCorner);
}

}  // namespace deckpipe
