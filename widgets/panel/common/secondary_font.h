// SPDX-License-Identifier: GPL-3.0-or-later
// The font of what stands beside the matter: types under PINs, words beside values, ages. Smaller than the
// application's own, never below 12 pixels.
#pragma once

#include <QFont>
#include <QFontInfo>
#include <algorithm>
#include <cmath>

namespace deckpipe {

inline QFont secondaryFont(const QFont& font) {
  QFont smaller = font;
  smaller.setPixelSize(std::max(12, static_cast<int>(std::lround(QFontInfo(font).pixelSize() * 0.88))));
  smaller.setWeight(QFont::Normal);
  return smaller;
}

}  // namespace deckpipe
