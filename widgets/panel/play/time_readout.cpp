// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/time_readout.h"

#include <QDateTime>
#include <QFontInfo>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "paint/app_style.h"
#include "paint/figures.h"
#include "panel/common/build.h"

namespace deckpipe {

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

TimeReadout::TimeReadout(QWidget* parent) : QWidget(parent) {
  named(this, "timeReadout", tr("Time of the cursor"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setView({});
}

void TimeReadout::setView(const LogView& view) {
  const QString dash(QChar(0x2013));
  const bool isEmpty = !view.document || view.frameCount == 0 || !view.hasTimes();
  const Instant now = std::max(view.cursor.time, view.begin);
  const QString elapsed = isEmpty ? dash : elapsedText(now - view.begin);
  const auto stamp = stampAt(view);
  const QString absolute = stamp ? stampTimeText(*stamp) : dash;
  if (elapsed == m_elapsed && absolute == m_absolute) return;
  m_elapsed = elapsed;
  m_absolute = absolute;
  setToolTip(stamp ? tr("Since the log's begin; below, the log's own clock: %1 s")
                         .arg(static_cast<double>(*stamp) / 1e9, 0, 'f', 6)
                   : tr("Since the log's begin"));
  update();
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
  return {static_cast<int>(std::ceil(width)) + 4, std::max(40, height + 2)};
}

void TimeReadout::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  const double upper = height() * 0.56;
  Figures figures;
  figures.number = m_elapsed;
  figures.numberFont = elapsedFont();
  figures.numberColour = m_absolute == m_elapsed ? c.textSecondary : c.text;
  drawFigures(p, QRectF(0, 0, width() - 2, upper), figures);
  figures.number = m_absolute;
  figures.numberFont = font();
  figures.numberColour = c.textSecondary;
  drawFigures(p, QRectF(0, upper, width() - 2, height() - upper), figures);
}

}  // namespace deckpipe
