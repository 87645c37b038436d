// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/tick_box.h"

#include <QIconEngine>
#include <QPainter>
#include <QPointer>
#include <QStyle>

#include <algorithm>

#include "paint/app_style.h"
#include "paint/glyph.h"

namespace deckpipe {
namespace {

constexpr int kBox = 18, kBoxGap = 8, kBoxMargin = 2, kMinHeight = 32;

}  // namespace

TickBox::TickBox(const QString& text, QWidget* parent) : QCheckBox(text, parent) {}

QSize TickBox::sizeHint() const {
  const QFontMetrics metrics(font());
  return {kBoxMargin + kBox + kBoxGap + metrics.horizontalAdvance(text()) + 2 * kBoxMargin,
          std::max(kMinHeight, metrics.height() + 8)};
}

void TickBox::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto placed = [&](const QRect& r) { return QStyle::visualRect(layoutDirection(), rect(), r); };
  const QRectF box = QRectF(placed({kBoxMargin, (height() - kBox) / 2, kBox, kBox})).adjusted(1, 1, -1, -1);
  const QColor& line = isEnabled() ? c.accent.ink : c.stale.ink;
  painter.setPen(QPen(isChecked() || hasFocus() || underMouse() ? line : c.outline, 1.5 * c.stroke));
  painter.setBrush(isChecked() ? c.accent.fill : c.surface);
  painter.drawRoundedRect(box, 3, 3);
  if (isChecked())
    drawGlyph(painter, box.adjusted(2, 2, -2, -2), Glyph::Fine, c.accent.onFill, Qt::transparent, 1.5);
  const int left = kBoxMargin + kBox + kBoxGap;
  const QRect words = placed({left, 0, width() - left, height()});
  painter.setPen(isEnabled() ? c.text : c.textSecondary);
  painter.drawText(words, static_cast<int>(Qt::AlignVCenter | Qt::AlignLeading | Qt::TextShowMnemonic),
                   text());
  if (!hasFocus()) return;
  const int length = std::min(words.width(), QFontMetrics(font()).horizontalAdvance(text()) + 4);
  drawFocusRing(painter, c, placed({left - 6, 2, length + 8, height() - 4}));
}

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
  if (hasFocus() && window()->testAttribute(Qt::WA_KeyboardFocusChange))
    drawFocusRing(painter, colours, rect());
}

}  // namespace deckpipe
