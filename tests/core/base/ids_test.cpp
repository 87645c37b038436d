// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ids.h"

#include <gtest/gtest.h>

namespace deckpipe {
namespace {

TEST(Pin, PadsEveryNumberWithZeros) {
  EXPECT_EQ(Pin::make(1032, 'A', 'E', 801035)->text(), "1032AE000801035");
  EXPECT_EQ(Pin::make(7, 'A', 'E', 0)->text(), "0007AE000000000");
}

TEST(Pin, IsNullWhereANumberDoesNotFitOrALetterCannotBePrinted) {
  EXPECT_FALSE(Pin::make(1032, 'A', 'E', 1'000'000'000));
  EXPECT_FALSE(Pin::make(10000, 'A', 'E', 1));
  EXPECT_FALSE(Pin::make(1032, 0x1F, 'E', 1));
  EXPECT_FALSE(Pin::make(1032, 'A', 0x7F, 1));
}

TEST(Pin, ParsesWhatItPrintsAndNothingElse) {
  const auto pin = Pin::parse("1032AE100801035");
  ASSERT_TRUE(pin);
  EXPECT_EQ(pin->text(), "1032AE100801035");
  EXPECT_EQ(pin->deviceType(), 1032u);
  EXPECT_EQ(pin->serial(), 100801035u);
  EXPECT_FALSE(Pin::parse(""));
  EXPECT_FALSE(Pin::parse("1032AE10080103"));
  EXPECT_FALSE(Pin::parse("1032AE1008O1035"));
  EXPECT_TRUE(Pin().isNull());
  EXPECT_EQ(Pin().text(), "");
}

}  // namespace
}  // namespace deckpipe
