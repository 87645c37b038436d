// SPDX-License-Identifier: GPL-3.0-or-later
// Fusion with targets that can be hit: at least 32 pixels at a desk, 44 in the field, where hands wear
// gloves. The console gives one to the application, with a font to match, and a new one when a person changes
// over.
#pragma once

#include <QFont>
#include <QProxyStyle>
#include <cstdint>

namespace deckpipe {

enum class Density : std::uint8_t { Desk, Field };

class DensityStyle : public QProxyStyle {
  Q_OBJECT

 public:
  explicit DensityStyle(Density density);

  int sizeFromDensity() const { return m_target; }
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                         const QWidget* widget) const override;

 private:
  int m_target;
};

// The least height of what is touched on a widget; painted widgets and delegates ask for it. 32 under any
// other style.
int targetHeight(const QWidget* widget);

// The application's font at a density, from the font of a desk.
QFont fontFor(Density density, const QFont& desk);

}  // namespace deckpipe
