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

}  // namespace
}  // namespace deckpipe
