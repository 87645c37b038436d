// SPDX-License-Identifier: GPL-3.0-or-later
// How many tiles stand beside one another in the overview, and how large each is: all of them as large as fit
// at once; where that would be too small to read, at their least size, and the panel scrolls. Pure.
#pragma once

#include <QRect>
#include <QSize>

namespace deckpipe {

struct OverviewGrid {
  static constexpr int kGap = 8;
  static constexpr QSize kMin{264, 232};
  static constexpr QSize kMax{880, 600};  // larger than this is for a page

  int columns = 1;
  QSize tile = kMin;

  QRect place(int i) const {
    const QPoint step(tile.width() + kGap, tile.height() + kGap);
    return {QPoint(kGap + i % columns * step.x(), kGap + i / columns * step.y()), tile};
  }
  // Of `count` tiles with the gaps around them.
  int height(int count) const;
};

OverviewGrid overviewGrid(int count, const QSize& room);

}  // namespace deckpipe
