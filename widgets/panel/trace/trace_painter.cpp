// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_painter.h"

#include <QPainter>
#include <cmath>
#include <optional>

#include "paint/app_style.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "panel/common/flat_header.h"

namespace deckpipe {
namespace {

using Marks = TraceModel::Marks;

constexpr int kCursorZone = 16;  // of the gutter; signs stand in the rest

// The most important first: a row has one sign, its words say the rest.
std::optional<Glyph> signOf(Marks marks) {
  if (marks.testFlag(TraceModel::Error)) return Glyph::Fault;
  if (marks.testFlag(TraceModel::Malformed)) return Glyph::Invalid;
  if (marks.testFlag(TraceModel::TimeJump)) return Glyph::Stale;
  if (marks.testFlag(TraceModel::Ambiguous)) return Glyph::Warning;
  if (marks.testFlag(TraceModel::Own)) return Glyph::CommandPlus;
  if (marks.testFlag(TraceModel::Presumed)) return Glyph::Unknown;
  return {};
}

QColor signInk(Glyph sign, const Colours& c) {
  switch (sign) {
    case Glyph::Fault: return c.fault.ink;
    case Glyph::CommandPlus: return c.accent.ink;
    case Glyph::Unknown: return c.textSecondary;
    default: return c.warning.ink;
  }
}

}  // namespace

TraceFonts::TraceFonts(const QFont& base) : text(base), figures(figureFont(base)) {
  // Figures need no shaping, which takes most of the time of laying them out.
  figures.setStyleStrategy(QFont::PreferNoShaping);
  figures.setKerning(false);
}

bool TraceFonts::isTabular(int column) {
  switch (column) {
    case TraceModel::Time:
    case TraceModel::Delta:
    case TraceModel::Identifier:
    case TraceModel::Pgn:
    case TraceModel::Length:
    case TraceModel::Data: return true;
    default: return false;
  }
}

TracePainter::TracePainter(QPainter& painter, const Colours& colours, const TraceFonts& fonts,
                           std::vector<TraceColumn> columns)
    : m_painter(painter),
      m_colours(colours),
      m_fonts(fonts),
      m_textMetrics(fonts.text),
      m_figureMetrics(fonts.figures),
      m_figureWidth(QFontMetricsF(fonts.figures).horizontalAdvance(QLatin1Char('0'))),
      m_columns(std::move(columns)) {}

void TracePainter::row(const QRect& rect, const QModelIndex& index, Look look) {
  const auto marks = Marks::fromInt(index.data(TraceModel::MarksRole).toUInt());
  const Colours& c = m_colours;
  m_painter.fillRect(rect, look.isSelected ? c.accent.fill : look.isOdd ? c.surfaceAlternate : c.surface);
  cells(rect, index, marks, look.isSelected);
  gutter(rect, marks, look.isSelected);
  if (marks.testFlag(TraceModel::TimeJump)) {
    QPen broken(look.isSelected ? c.accent.onFill : c.warning.ink, c.stroke);
    broken.setDashPattern({4, 4});
    m_painter.setPen(broken);
    m_painter.drawLine(rect.topLeft(), rect.topRight());
  }
  if (marks.testFlag(TraceModel::AtCursor)) {
    m_painter.fillRect(QRect(rect.left(), rect.bottom() - 1, rect.width(), 2),
                       look.isSelected ? c.accent.onFill : c.accent.fill);
  }
  if (look.hasFocus) drawFocusRing(m_painter, c, rect, look.isSelected);
}

void TracePainter::gutter(const QRect& rect, Marks marks, bool isSelected) {
  const Colours& c = m_colours;
  const QRect area(rect.left(), rect.top(), kGutter, rect.height());
  // Cells scrolled to the left pass below the gutter.
  m_painter.fillRect(area, isSelected ? c.accent.fill : c.surfaceAlternate);
  const double x = area.left() + kCursorZone / 2.0;
  if (marks.testFlag(TraceModel::AtCursor)) {
    m_painter.setRenderHint(QPainter::Antialiasing);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(isSelected ? c.accent.onFill : c.accent.fill);
    const double y = area.center().y() + 0.5;
    m_painter.drawPolygon(QPolygonF{{x - 4, y - 6}, {x + 6, y}, {x - 4, y + 6}});
    m_painter.setRenderHint(QPainter::Antialiasing, false);
  } else if (marks.testFlag(TraceModel::AfterCursor)) {
    // As many dots a row, so that they run on through all rows.
    constexpr int kDots = 4;
    for (int dot = 0; dot < kDots; ++dot) {
      const double y = area.top() + (dot + 0.5) * area.height() / kDots;
      m_painter.fillRect(QRectF(x - c.stroke, y - c.stroke, 2 * c.stroke, 2 * c.stroke),
                         isSelected ? c.accent.onFill : c.outline);
    }
  }
  if (const auto sign = signOf(marks)) {
    const double side = std::min(14.0, area.height() - 4.0);
    const QRectF box(area.left() + kCursorZone + 2, area.center().y() + 0.5 - side / 2, side, side);
    drawGlyph(m_painter, box, *sign, isSelected ? c.accent.onFill : signInk(*sign, c), Qt::transparent,
              c.stroke);
  }
}

QColor TracePainter::ink(int column, Marks marks, bool isSelected) const {
  const Colours& c = m_colours;
  if (isSelected) return c.accent.onFill;
  if (marks.testFlag(TraceModel::AfterCursor)) return c.stale.ink;
  const bool isWord = column == TraceModel::Name || column == TraceModel::Decoded;
  if (isWord && marks.testFlag(TraceModel::Error)) return c.fault.ink;
  if (isWord && (marks.testFlag(TraceModel::Malformed) || marks.testFlag(TraceModel::Ambiguous)))
    return c.warning.ink;
  if (column == TraceModel::Delta && marks.testFlag(TraceModel::TimeJump)) return c.warning.ink;
  if (column == TraceModel::Direction && marks.testFlag(TraceModel::Own)) return c.accent.ink;
  switch (column) {
    case TraceModel::Delta:
    case TraceModel::ChannelName:
    case TraceModel::Direction:
    case TraceModel::Pgn:
    case TraceModel::Length: return c.textSecondary;
    default: return c.text;
  }
}

// A trace is hundreds of short texts thirty times a second, so they are drawn at points, without the layout
// that drawing into a rectangle takes, and figures are measured by their count.
void TracePainter::cells(const QRect& rect, const QModelIndex& index, Marks marks, bool isSelected) {
  for (const TraceColumn& column : m_columns) {
    const int left = column.left + FlatHeader::kPadding;
    const int width = column.width - 2 * FlatHeader::kPadding;
    if (left + width < kGutter || left > rect.right() || width <= 0) continue;
    const QModelIndex at = index.siblingAtColumn(column.column);
    QString text = at.data().toString();
    if (text.isEmpty()) continue;
    const bool isTabular = TraceFonts::isTabular(column.column);
    const QFontMetrics& metrics = isTabular ? m_figureMetrics : m_textMetrics;
    const auto widthOf = [&](const QString& t) {
      return isTabular ? static_cast<int>(std::ceil(static_cast<double>(t.size()) * m_figureWidth))
                       : metrics.horizontalAdvance(t);
    };
    int needed = widthOf(text);
    if (needed > width) {
      text = metrics.elidedText(text, Qt::ElideRight, width);
      needed = widthOf(text);
    }
    const bool toRight = (at.data(Qt::TextAlignmentRole).value<Qt::Alignment>() & Qt::AlignRight) != 0;
    const int baseline = rect.top() + (rect.height() - metrics.height()) / 2 + metrics.ascent();
    m_painter.setFont(isTabular ? m_fonts.figures : m_fonts.text);
    m_painter.setPen(ink(column.column, marks, isSelected));
    m_painter.drawText(QPoint(toRight ? left + width - needed : left, baseline), text);
  }
}

}  // namespace deckpipe
