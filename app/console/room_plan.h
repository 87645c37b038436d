// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a screen the window takes.
#pragma once

#include <QRect>

namespace deckpipe {

// Size that the window has on a desk, without its frame, in logical pixels.
inline constexpr QSize kUsualWindow{1366, 720};

// Size of the first window, without its frame, on a screen that has `available` left beside its panels. A
// window that gets less than the usual size is better maximised.
QSize firstSize(const QRect& available);
// Place of a window that was left at `geometry`, without its frame: the same, if its screen has it, otherwise as near
// and as large as the screen allows.
QRect fitted(const QRect& geometry, const QRect& available);

}  // namespace deckpipe
