// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/payload_bits.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <bit>
#include <cmath>

#include "paint/app_style.h"
#include "paint/spoken.h"

namespace deckpipe {
namespace {

QString hexText(std::uint8_t byte) {
  return QString::number(byte, 16).toUpper().rightJustified(2, QLatin1Char('0'));
}

// The highest bit of the first byte that has any.
int firstAsRead(std::uint64_t bits) {
  const int byte = std::countr_zero(bits) / 8;
  const auto within = static_cast<std::uint8_t>(bits >> 8 * byte);
  return 8 * byte + 7 - std::countl_zero(within);
}

}  // namespace

PayloadBits::PayloadBits(QWidget* parent) : QWidget(parent) {
  speakAs(*this, QAccessible::Graphic);
  setObjectName(QStringLiteral("payloadBits"));
  setAccessibleName(tr("Data bytes"));
  setWhatsThis(tr(
      "The data of the frame bit by bit, bit 8 at the left, as in the manuals' tables; lines part the "
      "fields. Click a bit, or go there by the arrow keys, to choose its field; the bits of the chosen field "
      "are filled. Dashed are further bits that its value is read from."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  describe();
}

void PayloadBits::setValues(const PayloadValues& values) {
  if (values == m_values) return;
  m_values = values;
  // The arrow keys go on from the field that was selected elsewhere.
  if (m_values.selected != 0 && (m_values.selected >> m_at & 1) == 0) m_at = firstAsRead(m_values.selected);
  describe();
  update();
}

void PayloadBits::describe() {
  QStringList bytes;
  for (int byte = 0; byte < m_values.length; ++byte)
    bytes += hexText(m_values.bytes[static_cast<std::size_t>(byte)]);
  setAccessibleDescription(bytes.isEmpty() ? tr("no data") : tr("hex %1").arg(bytes.join(QLatin1Char(' '))));
}

QSize PayloadBits::sizeHint() const { return PayloadGeometry{}.size().toSize(); }

QSize PayloadBits::minimumSizeHint() const { return PayloadGeometry::fitting({0, 0}).size().toSize(); }

void PayloadBits::pick(int bit) {
  if (!isThere(bit)) return;
  m_at = bit;
  update();
  Q_EMIT bitPicked(std::uint64_t{1} << bit);
}

void PayloadBits::mousePressEvent(QMouseEvent* event) {
  pick(PayloadGeometry::fitting(size()).bitAt(event->position()));
}

void PayloadBits::mouseMoveEvent(QMouseEvent* event) {
  const int bit = PayloadGeometry::fitting(size()).bitAt(event->position());
  point(isThere(bit) ? std::uint64_t{1} << bit : 0);
}

void PayloadBits::leaveEvent(QEvent*) { point(0); }

// Told once a bit, however often the pointer moves within it.
void PayloadBits::point(std::uint64_t bit) {
  if (bit == m_pointed) return;
  m_pointed = bit;
  Q_EMIT bitPointed(bit);
}

void PayloadBits::keyPressEvent(QKeyEvent* event) {
  // Reading order: bit 8 of byte 1 first, bit 1 of byte 8 last.
  const int place = m_at / 8 * 8 + 7 - m_at % 8;
  int next = place;
  switch (event->key()) {
    case Qt::Key_Left: next = place - 1; break;
    case Qt::Key_Right: next = place + 1; break;
    case Qt::Key_Up: next = place - 8; break;
    case Qt::Key_Down: next = place + 8; break;
    case Qt::Key_Home: next = 0; break;
    case Qt::Key_End: next = 8 * m_values.length - 1; break;
    default: QWidget::keyPressEvent(event); return;
  }
  if (next >= 0) pick(next / 8 * 8 + 7 - next % 8);
}

void PayloadBits::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Colours& c = coloursOf(this);
  const PayloadGeometry g = PayloadGeometry::fitting(size());
  // As large as the words around, as far as the places for it go.
  const double small = std::clamp(QFontInfo(font()).pixelSize() * 0.88, 12.0, 17.0);
  QFont digits = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  digits.setPixelSize(
      static_cast<int>(std::lround(std::min(g.cellHeight * 0.55, std::max(15.0, small * 1.1)))));
  QFont labels = font();
  labels.setPixelSize(static_cast<int>(small));

  p.setFont(labels);
  p.setPen(c.textSecondary);
  for (int column = 0; column < 8; ++column)
    p.drawText(g.bitLabel(column), Qt::AlignCenter, QString::number(8 - column));
  for (int byte = 0; byte < PayloadGeometry::kBytes; ++byte) {
    p.setPen(byte < m_values.length ? c.textSecondary : c.stale.ink);
    p.drawText(g.byteLabel(byte), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("B%1").arg(byte + 1));
  }

  const QRectF there(PayloadGeometry::kLeft, PayloadGeometry::kTop, 8 * g.cellWidth,
                     m_values.length * g.cellHeight);
  p.fillRect(there, c.surface);
  p.setFont(digits);
  for (int bit = 0; bit < 8 * m_values.length; ++bit) {
    const auto byte = static_cast<std::size_t>(bit / 8);
    const bool isOne = (m_values.bytes[byte] >> bit % 8 & 1) != 0;
    const bool isShown = (m_values.shown() >> bit & 1) != 0;
    const QRectF cell = g.cell(bit);
    if (isShown) p.fillRect(cell, c.accent.fill);
    p.setPen(isShown ? c.accent.onFill : isOne ? c.text : c.textSecondary);
    p.drawText(cell, Qt::AlignCenter, isOne ? QStringLiteral("1") : QStringLiteral("0"));
  }
  for (int byte = 0; byte < m_values.length; ++byte) {
    p.setPen(c.text);
    p.drawText(g.hexLabel(byte), Qt::AlignLeft | Qt::AlignVCenter,
               hexText(m_values.bytes[static_cast<std::size_t>(byte)]));
  }

  const auto drawOutline = [&](std::uint64_t bits, const QPen& pen) {
    p.setPen(pen);
    for (const QLineF& line : g.outline(bits)) p.drawLine(line);
  };
  const QPen thin(c.outline, c.stroke, Qt::SolidLine, Qt::SquareCap);
  p.setRenderHint(QPainter::Antialiasing, false);
  for (const std::uint64_t field : m_values.fields) drawOutline(field, thin);
  if (m_values.length > 0) {
    p.setPen(thin);
    p.setBrush(Qt::NoBrush);
    p.drawRect(there);
  }
  if (m_values.length < PayloadGeometry::kBytes) {
    QPen absent(c.stale.ink, c.stroke);
    absent.setDashPattern({2, 3});
    p.setPen(absent);
    p.drawRect(QRectF(there.left(), there.bottom(), there.width(),
                      (PayloadGeometry::kBytes - m_values.length) * g.cellHeight));
  }
  p.setRenderHint(QPainter::Antialiasing);
  QPen related(c.accent.ink, 2 * c.stroke, Qt::SolidLine, Qt::FlatCap);
  related.setDashPattern({2, 1.5});
  drawOutline(m_values.related, related);
  drawOutline(m_values.selected, QPen(c.text, 2 * c.stroke, Qt::SolidLine, Qt::SquareCap));
  if (hasFocus() && isThere(m_at)) {
    drawFocusRing(p, c, g.cell(m_at).toRect().adjusted(1, 1, -1, -1), (m_values.shown() >> m_at & 1) != 0);
  }
}

namespace {

constexpr double kMinWidth = 18, kMaxWidth = 44;
constexpr double kMinHeight = 17, kMaxHeight = 32;

}  // namespace

PayloadGeometry PayloadGeometry::fitting(QSizeF size) {
  PayloadGeometry g;
  g.cellWidth = std::floor(std::clamp((size.width() - kLeft - kRight) / 8, kMinWidth, kMaxWidth));
  g.cellHeight = std::floor(std::clamp((size.height() - kTop - 1) / kBytes, kMinHeight, kMaxHeight));
  return g;
}

QRectF PayloadGeometry::cell(int bit) const {
  const int column = 7 - bit % 8;
  return {kLeft + column * cellWidth, kTop + bit / 8 * cellHeight, cellWidth, cellHeight};
}

QRectF PayloadGeometry::byteLabel(int byte) const {
  return {0, kTop + byte * cellHeight, kLeft - 8, cellHeight};
}

QRectF PayloadGeometry::hexLabel(int byte) const {
  return {kLeft + 8 * cellWidth + 8, kTop + byte * cellHeight, kRight - 8, cellHeight};
}

QRectF PayloadGeometry::bitLabel(int column) const {
  return {kLeft + column * cellWidth, 0, cellWidth, kTop};
}

int PayloadGeometry::bitAt(QPointF point) const {
  const double x = point.x() - kLeft, y = point.y() - kTop;
  if (x < 0 || y < 0 || x >= 8 * cellWidth || y >= kBytes * cellHeight) return -1;
  return static_cast<int>(y / cellHeight) * 8 + 7 - static_cast<int>(x / cellWidth);
}

std::vector<QLineF> PayloadGeometry::outline(std::uint64_t bits) const {
  std::vector<QLineF> lines;
  const auto has = [bits](int byte, int column) {
    return byte >= 0 && byte < kBytes && column >= 0 && column < 8 &&
           (bits >> (byte * 8 + 7 - column) & 1) != 0;
  };
  for (int byte = 0; byte < kBytes; ++byte) {
    for (int column = 0; column < 8; ++column) {
      if (!has(byte, column)) continue;
      const QRectF r = cell(byte * 8 + 7 - column);
      if (!has(byte - 1, column)) lines.emplace_back(r.topLeft(), r.topRight());
      if (!has(byte + 1, column)) lines.emplace_back(r.bottomLeft(), r.bottomRight());
      if (!has(byte, column - 1)) lines.emplace_back(r.topLeft(), r.bottomLeft());
      if (!has(byte, column + 1)) lines.emplace_back(r.topRight(), r.bottomRight());
    }
  }
  return lines;
}

}  // namespace deckpipe
