// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/overview_grid.h"

#include <algorithm>

namespace deckpipe {
namespace {

constexpr double kDialAspect = 1.45;  // a dial is that much wider than high where it fills its tile best

int rowsOf(int count, int columns) { return (count + columns - 1) / columns; }

}  // namespace

int OverviewGrid::height(int count) const { return kGap + rowsOf(count, columns) * (tile.height() + kGap); }

OverviewGrid overviewGrid(int count, const QSize& room) {
  constexpr int kGap = OverviewGrid::kGap;
  const auto share = [](int all, int n) { return (all - (n + 1) * kGap) / n; };
  const int most = std::max(1, (room.width() - kGap) / (OverviewGrid::kMin.width() + kGap));
  OverviewGrid best;
  double bestScore = 0;
  for (int columns = 1; columns <= std::min(most, count); ++columns) {
    const QSize tile = QSize(share(room.width(), columns), share(room.height(), rowsOf(count, columns)))
                           .boundedTo(OverviewGrid::kMax);
    if (tile.height() < OverviewGrid::kMin.height()) continue;
    const double score = std::min(tile.width() / kDialAspect, static_cast<double>(tile.height()));
    if (score <= bestScore) continue;
    bestScore = score;
    best = {columns, tile};
  }
  if (bestScore > 0) return best;
  return {most, {std::max(share(room.width(), most), 1), OverviewGrid::kMin.height()}};
}

}  // namespace deckpipe
