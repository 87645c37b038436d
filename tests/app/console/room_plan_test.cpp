// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/room_plan.h"

#include <gtest/gtest.h>

namespace deckpipe {
namespace {

TEST(FirstWindow, FitsItsScreenWithItsFrame) {
  const struct {
    const char* screen;
    QRect available;
    QSize size;
  } rows[] = {
      {"1920×1080 with a panel of 40", {0, 0, 1920, 1040}, {1366, 720}},
      {"4K at scale 2 with a panel at the left", {64, 0, 1856, 1080}, {1366, 720}},
      {"1366×768 with a panel of 40", {0, 0, 1366, 728}, {1350, 680}},
      {"1366×768 at 150 %", {0, 0, 910, 512}, {894, 464}},
      {"1024×600 without panels", {0, 0, 1024, 600}, {1008, 552}},
  };
  for (const auto& row : rows) EXPECT_EQ(firstSize(row.available), row.size) << row.screen;
}

TEST(RestoredWindow, IsPutInsideOfItsScreen) {
  const QRect available(64, 0, 1302, 728);
  const struct {
    const char* left;
    QRect geometry, put;
  } rows[] = {
      {"inside", {100, 40, 1024, 600}, {100, 40, 1024, 600}},
      {"over all of it, without a frame", {64, 0, 1302, 728}, {64, 0, 1302, 728}},
      {"on a larger screen", {100, 40, 1920, 1000}, {72, 40, 1286, 680}},
      {"beyond the right and the foot", {1000, 500, 1024, 600}, {334, 120, 1024, 600}},
      {"on a screen at the left", {-1500, -300, 800, 500}, {72, 40, 800, 500}},
  };
  for (const auto& row : rows) EXPECT_EQ(fitted(row.geometry, available), row.put) << row.left;
}

}  // namespace
}  // namespace deckpipe
