// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/time_readout.h"

#include <QDateTime>
#include <QFontInfo>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "paint/app_style.h"
#include "paint/figures.h"
#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kBesideFigures = 6;

}  // namespace

QString stampTimeText(std::int64_t stampNs) {
  if (!isDate(stampNs)) {
    const std::int64_t whole = stampNs - stampNs % 1'000'000;
    return TimeReadout::tr("%1 s").arg(static_cast<double>(whole) / 1e9, 0, 'f', 3);
  }
  return QDateTime::fromMSecsSinceEpoch(stampNs / 1'000'000).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")) +
         millisecondsText(stampNs);
}

std::optional<std::int64_t> stampAt(const LogView& view) {
  if (!view.document || view.cursor.frames == 0 || view.cursor.frames > view.document->frames.count())
    return {};
  if (!view.hasTimes()) return {};
  const std::uint64_t last = view.cursor.frames - 1;
  const Frame& frame = view.document->frames[last];
  if (!frame.hasStamp()) return {};
  std::int64_t stamp = 0;
  const Duration since = std::max(view.cursor.time - view.document->frames.timeAt(last), Duration(0));
  return __builtin_add_overflow(frame.stamp, since.count(), &stamp) ? frame.stamp : stamp;
}

TimeReadout::TimeReadout(QWidget* parent) : QAbstractButton(parent) {
  named(this, "timeReadout", tr("Time of the cursor"));
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setView({});
}

void TimeReadout::setView(const LogView& view) {
  const QString dash(QChar(0x2013));
  const bool isEmpty = !view.document || view.frameCount == 0 || !view.hasTimes();
  const Instant now = std::max(view.cursor.time, view.begin);
  const bool hasFrames = view.document && view.frameCount > 0;
  setEnabled(hasFrames);
  QString elapsed = isEmpty ? dash : elapsedText(now - view.begin);
  const auto stamp = stampAt(view);
  QString absolute = stamp ? stampTimeText(*stamp) : dash;
  if (hasFrames && !view.hasTimes()) {
    elapsed = QLocale().toString(static_cast<qulonglong>(view.cursor.frames));
    absolute = tr("frames, no times");
  }
  if (elapsed == m_elapsed && absolute == m_absolute) return;
  m_elapsed = elapsed;
  m_absolute = absolute;
  const QString where = !view.hasTimes() ? tr("The number of the frame; this log has no times")
                        : stamp          ? tr("Since the log's begin; below, the log's own clock: %1 s")
                                      .arg(static_cast<double>(*stamp) / 1e9, 0, 'f', 6)
                                : tr("Since the log's begin");
  setToolTip(tr("%1. A click or Ctrl+G takes another place.").arg(where));
  setAccessibleDescription(tr("%1; %2").arg(m_elapsed, m_absolute));
  update();
}

void TimeReadout::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

QFont TimeReadout::elapsedFont() const {
  QFont large = font();
  large.setPixelSize(QFontInfo(font()).pixelSize() * 3 / 2);
  large.setWeight(QFont::DemiBold);
  return large;
}

QSize TimeReadout::sizeHint() const {
  const double width = std::max(figuresWidth(elapsedFont(), QStringLiteral("000:00:00.000")),
                                figuresWidth(font(), QStringLiteral("0000-00-00 00:00:00.000")));
  const int height = QFontMetrics(elapsedFont()).height() + QFontMetrics(font()).height();
  return {static_cast<int>(std::ceil(width)) + 2 * kBesideFigures, std::max(40, height + 4)};
}

void TimeReadout::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const bool isTouched = isEnabled() && (underMouse() || isDown());
  p.setPen(QPen(hasFocus() ? c.accent.ink : c.outline, hasFocus() ? 2 : c.stroke));
  p.setBrush(isTouched ? c.surfaceAlternate : c.surface);
  p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  const double upper = height() * 0.56, right = width() - kBesideFigures;
  Figures figures;
  figures.number = m_elapsed;
  figures.numberFont = elapsedFont();
  figures.numberColour = m_absolute == m_elapsed ? c.textSecondary : c.text;
  drawFigures(p, QRectF(0, 1, right, upper - 1), figures);
  figures.number = m_absolute;
  figures.numberFont = font();
  figures.numberColour = c.textSecondary;
  drawFigures(p, QRectF(0, upper - 1, right, height() - upper), figures);
}

}  // namespace deckpipe
