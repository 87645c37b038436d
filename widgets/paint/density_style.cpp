// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/density_style.h"

#include <QPainter>
#include <QStyleOption>
#include <QWidget>
#include <algorithm>

namespace deckpipe {
namespace {

constexpr int kDesk = 32, kField = 44;
constexpr int kRoomBesideText = 12;
constexpr double kFieldFont = 1.2;

}  // namespace

DensityStyle::DensityStyle(Density density)
    : QProxyStyle(QStringLiteral("Fusion")), m_target(density == Density::Field ? kField : kDesk) {}

int DensityStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  const int plain = QProxyStyle::pixelMetric(metric, option, widget);
  const bool isField = m_target == kField;
  switch (metric) {
    case PM_ScrollBarExtent: return isField ? 28 : std::max(plain, 16);
    case PM_ScrollBarSliderMin: return m_target;
    case PM_SplitterWidth:
    case PM_DockWidgetSeparatorExtent: return isField ? 14 : 8;
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight: return isField ? 24 : 18;
    default: return plain;
  }
}

// Fusion's own is hard to see in the sun.
void DensityStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
  if (element != PE_FrameFocusRect) return QProxyStyle::drawPrimitive(element, option, painter, widget);
  if ((option->state & State_KeyboardFocusChange) == 0) return;
  painter->save();
  painter->setPen(QPen(option->palette.color(QPalette::Highlight), 2));
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(option->rect.adjusted(1, 1, -1, -1));
  painter->restore();
}

QSize DensityStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                     const QWidget* widget) const {
  QSize result = QProxyStyle::sizeFromContents(type, option, size, widget);
  switch (type) {
    case CT_MenuItem:
      // Separators stay thin.
      if (const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
          item != nullptr && item->menuItemType == QStyleOptionMenuItem::Separator)
        break;
      [[fallthrough]];
    case CT_ItemViewItem:
    case CT_PushButton:
    case CT_ToolButton:
    case CT_ComboBox:
    case CT_LineEdit:
    case CT_SpinBox:
    case CT_CheckBox:
    case CT_RadioButton:
    case CT_MenuBarItem:
    case CT_TabBarTab: result.setHeight(std::max(result.height(), m_target)); break;
    default: break;
  }
  if (type == CT_PushButton) result.rwidth() += kRoomBesideText;
  if (type == CT_PushButton || type == CT_TabBarTab) result.setWidth(std::max(result.width(), m_target));
  return result;
}

int targetHeight(const QWidget* widget) {
  const auto* style = widget == nullptr ? nullptr : qobject_cast<const DensityStyle*>(widget->style());
  return style != nullptr ? style->sizeFromDensity() : kDesk;
}

QFont fontFor(Density density, const QFont& desk) {
  QFont font = desk;
  if (density == Density::Field) font.setPointSizeF(desk.pointSizeF() * kFieldFont);
  return font;
}

}  // namespace deckpipe
