// SPDX-License-Identifier: GPL-3.0-or-later
// Contrast by WCAG 2.1 (1.4.3, 1.4.11), and every pair of colours that this room puts one on the other.
// Whoever paints with a new pair adds it to contrastPairs(); a test computes them all in all themes.
#pragma once

#include <string>
#include <vector>

#include "paint/palette.h"

namespace deckpipe {

// 1 (the same) .. 21 (black on white). Both colours opaque.
double contrastRatio(const QColor& a, const QColor& b);

inline constexpr double kTextContrast = 4.5;
inline constexpr double kGraphicsContrast = 3.0;

struct ContrastPair {
  std::string what;
  QColor front;
  QColor back;
  double atLeast;
};
std::vector<ContrastPair> contrastPairs(const Colours& colours);

}  // namespace deckpipe
