// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/devices/device_header.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include "model/device_model.h"
#include "paint/app_style.h"
#include "panel/common/secondary_font.h"

namespace deckpipe {
namespace {

constexpr double kSectionPad = 8;
constexpr double kArrow = 3.5;  // half its width

}  // namespace

DeviceHeader::DeviceHeader(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
  setObjectName(QStringLiteral("deviceListHeader"));
  setAccessibleName(tr("Sort the devices by"));
  setSectionsMovable(false);
  setStretchLastSection(false);
  setSortIndicatorClearable(true);
  setSortIndicator(-1, Qt::AscendingOrder);
  setMinimumSectionSize(32);
  setFixedHeight(32);
  setHighlightSections(false);
}

// What lies beside the sections, over the scroll bar.
void DeviceHeader::paintEvent(QPaintEvent* event) {
  QPainter(viewport()).fillRect(viewport()->rect(), coloursOf(this).surface);
  QHeaderView::paintEvent(event);
}

void DeviceHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  const Colours& c = coloursOf(this);
  QPainter& p = *painter;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.fillRect(rect, c.surface);
  const QFont small = secondaryFont(font());
  const QFontMetricsF metrics(small);
  const QString text = model()->headerData(section, orientation()).toString();
  const double width = metrics.horizontalAdvance(text);
  const bool isSorted = sortIndicatorSection() == section;
  double left = rect.left() + kSectionPad;
  if (section == DeviceModel::HealthColumn) {
    left = rect.center().x() + 0.5 - width / 2;  // as its cells: centred
  } else if (section != DeviceModel::DeviceColumn) {
    left = rect.right() + 1 - kSectionPad - width;
  }
  const double baseline = rect.center().y() + metrics.capHeight() / 2;
  p.setFont(small);
  p.setPen(isSorted ? c.accent.ink : c.textSecondary);
  p.drawText(QPointF(left, baseline), text);
  if (isSorted) {
    // Under the word, where it takes no room from it.
    const QPointF tip(left + width / 2, rect.bottom() - 3);
    const double down = sortIndicatorOrder() == Qt::DescendingOrder ? 1 : -1;
    p.setPen(Qt::NoPen);
    p.setBrush(c.accent.ink);
    p.drawPolygon(QPolygonF{tip + QPointF(-kArrow, -2 * down), tip + QPointF(kArrow, -2 * down),
                            tip + QPointF(0, 2.5 * down)});
  }
  p.setPen(QPen(c.stale.fill, 1));
  p.setRenderHint(QPainter::Antialiasing, false);
  p.drawLine(rect.bottomLeft(), rect.bottomRight());
  p.restore();
}

}  // namespace deckpipe
