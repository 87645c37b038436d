// SPDX-License-Identifier: GPL-3.0-or-later
// How the application looks: Fusion in the colours of a theme, with targets that can be hit, at least 32
// pixels at a desk and 44 in the field, where hands wear gloves. The console gives one to the application,
// with a font to match, and a new one when a person changes over: nothing else has to be told.
//
// A widget that paints asks coloursOf() while it paints. Words in a colour of their own get it once by
// setInk(), and follow the style from then on. What keeps a colour otherwise, in an icon or a document,
// renews it on QEvent::StyleChange.
#pragma once

#include <QFont>
#include <QProxyStyle>
#include <cstdint>

#include "paint/palette.h"

namespace deckpipe {

enum class Density : std::uint8_t { Desk, Field };

class AppStyle : public QProxyStyle {
  Q_OBJECT

 public:
  AppStyle(Density density, Theme theme);

  int sizeFromDensity() const { return m_target; }
  const Colours& colours() const { return m_colours; }

  using QProxyStyle::polish;
  void polish(QApplication* application) override;
  void polish(QWidget* widget) override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;

 private:
  int m_target;
  const Colours& m_colours;
};

// The ring around what takes the keys, inside `rect`. On a ground filled with the accent it is drawn in the colour of
// the words there. Painted widgets and delegates draw it too; the style draws it for Qt's own.
void drawFocusRing(QPainter& painter, const Colours& colours, const QRect& rect, bool isOnAccent = false);

// The least height of what is touched on a widget; painted widgets and delegates ask for it. 32 under any
// other style.
int targetHeight(const QWidget* widget);

// The height of a row of a list of many: `desk` at a desk, where many rows in sight are worth more; in the field that of
// a target.
int denseRowHeight(const QWidget* widget, int desk);

// The colours to paint a widget in; those of the light theme under any other style.
const Colours& coloursOf(const QWidget* widget);

// The words of a label or a line edit are written in this ink from now on, in every theme.
void setInk(QWidget& words, Ink ink);

// The application's font at a density, from the font of a desk.
QFont fontFor(Density density, const QFont& desk);

}  // namespace deckpipe
