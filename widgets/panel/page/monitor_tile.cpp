// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/monitor_tile.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>
#include <cmath>

#include "paint/app_style.h"
#include "paint/dial.h"
#include "paint/figures.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "panel/common/health_look.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr int kTilePad = 12;
constexpr int kFrame = 3;  // of the focus
constexpr double kTileSign = 14;
constexpr double kTileGap = 8;

int lineHeight(const QFont& font) { return static_cast<int>(std::ceil(QFontMetricsF(font).height())) + 4; }

}  // namespace

MonitorTile::MonitorTile(QWidget* parent) : QAbstractButton(parent), m_dial(new Dial(this)) {
  setObjectName(QStringLiteral("monitorTile"));
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::StrongFocus);
  m_dial->setAttribute(Qt::WA_TransparentForMouseEvents);  // the tile takes the click
  m_dial->setObjectName(QStringLiteral("tileDial"));
}

void MonitorTile::setMonitor(const OverviewMonitor& monitor) {
  m_dial->setValues(monitor.dial);
  // Ages run on; what counts is what is written of them. The dial looks after itself.
  const bool isSame = monitor.key == m_monitor.key && monitor.title == m_monitor.title &&
                      monitor.identity == m_monitor.identity && monitor.detail == m_monitor.detail &&
                      monitor.health == m_monitor.health && monitor.reasons == m_monitor.reasons &&
                      monitor.stops == m_monitor.stops && monitor.areStopsStale == m_monitor.areStopsStale &&
                      ageText(monitor.age) == ageText(m_monitor.age);
  m_monitor = monitor;
  if (isSame) return;
  describe();
  update();
}

void MonitorTile::setChosen(bool chosen) {
  if (chosen == m_isChosen) return;
  m_isChosen = chosen;
  describe();
  update();
}

void MonitorTile::setAnimated(bool animated) { m_dial->setAnimated(animated); }

void MonitorTile::describe() {
  QString details = m_monitor.detail;
  if (!m_monitor.identity.isEmpty()) details.prepend(m_monitor.identity + QStringLiteral(" · "));
  setAccessibleName(tr("%1, %2, %3", "a monitor's name, details and health")
                        .arg(m_monitor.title, details, healthWord(m_monitor.health)));
  QStringList parts = m_monitor.reasons;
  if (!m_monitor.stops.isEmpty()) parts << tr("Stands at: %1.").arg(m_monitor.stops);
  if (m_isChosen) parts << tr("Its page is shown.");
  setAccessibleDescription(parts.join(QLatin1Char(' ')));
  parts.prepend(details);
  parts.prepend(m_monitor.title);
  setToolTip(parts.join(QLatin1Char('\n')));
}

void MonitorTile::resizeEvent(QResizeEvent*) {
  const int head = kTilePad / 2 + lineHeight(strongFont(font())) + lineHeight(secondaryFont(font()));
  const int foot = lineHeight(secondaryFont(font())) + kTilePad / 2;
  m_dial->setGeometry(kFrame + 1, head, width() - 2 * kFrame - 2, height() - head - foot);
}

void MonitorTile::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

void MonitorTile::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double stroke = hasFocus() ? kFrame : m_isChosen ? 2 : 1;
  const QColor frame = hasFocus() || m_isChosen ? c.accent.ink : underMouse() ? c.text : c.outline;
  p.setPen(QPen(frame, stroke));
  p.setBrush(c.surface);
  p.drawRoundedRect(QRectF(rect()).adjusted(stroke / 2, stroke / 2, -stroke / 2, -stroke / 2), 6, 6);

  const QFont strong = strongFont(font()), small = secondaryFont(font());
  const QFontMetricsF strongMetrics(strong), smallMetrics(small);
  const double left = kTilePad, right = width() - kTilePad;
  const double first = kTilePad / 2.0 + (lineHeight(strong) + strongMetrics.capHeight()) / 2;
  const double second =
      kTilePad / 2.0 + lineHeight(strong) + (lineHeight(small) + smallMetrics.capHeight()) / 2;

  const QColor health = inkOf(c, inkOf(m_monitor.health.severity()));
  const QString age = ageText(m_monitor.age);
  const double signLeft = right - kTileSign;
  const double ageLeft = signLeft - kTileGap - smallMetrics.horizontalAdvance(age);
  drawGlyph(p, QRectF(signLeft, first - strongMetrics.capHeight() / 2 - kTileSign / 2, kTileSign, kTileSign),
            healthGlyph(m_monitor.health.severity()), health, Qt::transparent, c.stroke);
  p.setFont(strong);
  p.setPen(c.text);
  // The name before the age: the dial has its own.
  const QString name = elidedPin(m_monitor.title, strongMetrics, signLeft - kTileGap - left);
  p.drawText(QPointF(left, first), name);
  p.setFont(small);
  p.setPen(c.textSecondary);
  if (left + strongMetrics.horizontalAdvance(name) + kTileGap <= ageLeft)
    p.drawText(QPointF(ageLeft, first), age);

  // A PIN, then the words of the health; the rest has what they leave.
  double detailLeft = left;
  if (!m_monitor.identity.isEmpty()) {
    const QString pin = elidedPin(m_monitor.identity, smallMetrics, right - left);
    p.drawText(QPointF(left, second), pin);
    detailLeft += smallMetrics.horizontalAdvance(pin) + kTileGap;
  }
  const QString words = wordsThatFit(healthWords(m_monitor.health), smallMetrics, right - detailLeft);
  const double wordsLeft = right - smallMetrics.horizontalAdvance(words);
  p.drawText(QPointF(detailLeft, second),
             smallMetrics.elidedText(m_monitor.detail, Qt::ElideRight, wordsLeft - kTileGap - detailLeft));
  p.setPen(health);
  p.drawText(QPointF(wordsLeft, second), words);

  // At the foot the trouble in words, then the stops in what it leaves.
  const double foot = height() - kTilePad / 2.0 - lineHeight(small) / 2.0;
  const auto drawFoot = [&](double from, Glyph glyph, const QColor& ink, const QString& text) {
    const double textLeft = from + kTileSign + kTileGap / 2;
    if (text.isEmpty() || right <= textLeft) return from;
    drawGlyph(p, QRectF(from, foot - kTileSign / 2, kTileSign, kTileSign), glyph, ink, Qt::transparent,
              c.stroke);
    p.setPen(ink);
    const QString shown = smallMetrics.elidedText(text, Qt::ElideRight, right - textLeft);
    p.drawText(QPointF(textLeft, foot + smallMetrics.capHeight() / 2), shown);
    return textLeft + smallMetrics.horizontalAdvance(shown) + kTileGap;
  };
  const double stopsLeft =
      drawFoot(left, healthGlyph(m_monitor.health.severity()), health, m_monitor.trouble);
  drawFoot(stopsLeft, m_monitor.areStopsStale ? Glyph::Stale : Glyph::Stop,
           m_monitor.areStopsStale ? c.stale.ink : c.text, m_monitor.stops);
}

}  // namespace deckpipe
