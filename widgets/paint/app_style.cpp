// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/app_style.h"

#include <QApplication>
#include <QPainter>
#include <QStyleOption>
#include <QWidget>
#include <algorithm>

namespace deckpipe {
namespace {

constexpr int kDesk = 32, kField = 44;
constexpr int kRoomBesideText = 12;
constexpr double kFieldFont = 1.2;

constexpr char kInkProperty[] = "ink";

const AppStyle* styleOf(const QWidget* widget) {
  return widget == nullptr ? nullptr : qobject_cast<const AppStyle*>(widget->style());
}

// Changed only when it changes: a new palette lays out anew.
void write(QWidget& words, const QColor& ink) {
  QPalette palette = words.palette();
  // On a window labels write in one of these, on a surface in the other.
  if (palette.color(QPalette::WindowText) == ink && palette.color(QPalette::Text) == ink) return;
  palette.setColor(QPalette::WindowText, ink);
  palette.setColor(QPalette::Text, ink);
  words.setPalette(palette);
}

}  // namespace

AppStyle::AppStyle(Density density, Theme theme)
    : QProxyStyle(QStringLiteral("Fusion")),
      m_target(density == Density::Field ? kField : kDesk),
      m_colours(coloursOf(theme)) {}

void AppStyle::polish(QApplication* application) {
  QProxyStyle::polish(application);
  QApplication::setPalette(qtPalette(m_colours));
}

void AppStyle::polish(QWidget* widget) {
  QProxyStyle::polish(widget);
  if (const QVariant ink = widget->property(kInkProperty); ink.isValid())
    write(*widget, inkOf(m_colours, static_cast<Ink>(ink.toInt())));
}

int AppStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
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

// Fusion's own is hard to see in the sun. A light line inside the dark one keeps it in sight on any ground.
void drawFocusRing(QPainter& painter, const Colours& colours, const QRect& rect, bool isOnAccent) {
  constexpr double kRing = 3, kInside = 1;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  const auto draw = [&](double from, double width, const QColor& ink) {
    const double middle = from + width / 2;
    painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(QRectF(rect).adjusted(middle, middle, -middle, -middle));
  };
  draw(0, kRing, isOnAccent ? colours.accent.onFill : colours.accent.ink);
  draw(kRing, kInside, isOnAccent ? colours.accent.fill : colours.surface);
  painter.restore();
}

void AppStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
  if (element == PE_FrameFocusRect) {
    if ((option->state & State_KeyboardFocusChange) == 0) return;
    // Views tell the ground of a row.
    const auto* focus = qstyleoption_cast<const QStyleOptionFocusRect*>(option);
    const bool isOnAccent = focus != nullptr && focus->backgroundColor == m_colours.accent.fill;
    drawFocusRing(*painter, m_colours, option->rect, isOnAccent);
    return;
  }
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  if ((option->state & State_HasFocus) == 0) return;
  // Fusion marks a button that has the focus by a thin line alone; a choice is drawn as a button.
  const bool isButton = element == PE_PanelButtonCommand && (option->state & State_KeyboardFocusChange) != 0;
  if (element == PE_FrameLineEdit || isButton) drawFocusRing(*painter, m_colours, option->rect);
}

// Without Fusion's line under a menu bar: other things stand beside this one.
void AppStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                           const QWidget* widget) const {
  QProxyStyle::drawControl(element, option, painter, widget);
  const auto keys = State_HasFocus | State_KeyboardFocusChange;
  if (element == CE_TabBarTabLabel && (option->state & keys) == keys)
    return drawFocusRing(*painter, m_colours, option->rect);
  const bool isOpen = (option->state & State_Sunken) != 0;
  if (element != CE_MenuBarEmptyArea && (element != CE_MenuBarItem || isOpen)) return;
  const QRect& rect = option->rect;
  painter->fillRect(QRect(rect.left(), rect.bottom(), rect.width(), 1), option->palette.window());
}

void AppStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                  QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawComplexControl(control, option, painter, widget);
  if (control == CC_SpinBox && (option->state & State_HasFocus) != 0)
    drawFocusRing(*painter, m_colours, option->rect);
}

QSize AppStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
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
  const AppStyle* style = styleOf(widget);
  return style != nullptr ? style->sizeFromDensity() : kDesk;
}

int denseRowHeight(const QWidget* widget, int desk) {
  const int target = targetHeight(widget);
  return target > kDesk ? std::max(target, desk) : desk;
}

const Colours& coloursOf(const QWidget* widget) {
  const AppStyle* style = styleOf(widget);
  return style != nullptr ? style->colours() : coloursOf(Theme::Light);
}

void setInk(QWidget& words, Ink ink) {
  words.setProperty(kInkProperty, static_cast<int>(ink));
  write(words, inkOf(coloursOf(&words), ink));
}

QFont fontFor(Density density, const QFont& desk) {
  QFont font = desk;
  if (density == Density::Field) font.setPointSizeF(desk.pointSizeF() * kFieldFont);
  return font;
}

}  // namespace deckpipe
