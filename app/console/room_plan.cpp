// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_plan.h"

#include <algorithm>

namespace deckpipe {
namespace {

// A window's title and borders, which nobody knows before the window is seen.
constexpr QSize kFrame{16, 48};

}  // namespace

QSize firstSize(const QRect& available) { return kUsualWindow.boundedTo(available.size() - kFrame); }

QRect fitted(const QRect& geometry, const QRect& available) {
  if (available.contains(geometry)) return geometry;
  const QPoint begin = available.topLeft() + QPoint(kFrame.width() / 2, kFrame.height() - kFrame.width() / 2);
  const QRect room(begin, available.size() - kFrame);
  QRect inside(geometry.topLeft(), geometry.size().boundedTo(room.size()));
  inside.moveLeft(std::clamp(inside.left(), room.left(), room.right() + 1 - inside.width()));
  inside.moveTop(std::clamp(inside.top(), room.top(), room.bottom() + 1 - inside.height()));
  return inside;
}

}  // namespace deckpipe
