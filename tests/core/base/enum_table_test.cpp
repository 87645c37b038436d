// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/enum_table.h"

#include <gtest/gtest.h>

namespace deckpipe {

enum class Gear : std::uint8_t { Low, Middle, High };
template <>
inline constexpr Gear kLastOf<Gear> = Gear::High;

// Their last enumerators were added without a thought of the count.
enum class Grown : std::uint8_t { Low, High, Reverse };
template <>
inline constexpr Grown kLastOf<Grown> = Grown::High;
enum class Overgrown : std::uint8_t { Low, Count, High };

static_assert(!kEndsAtLast<Grown> && !kEndsAtLast<Overgrown>);
static_assert(kEndsAtLast<Gear>);

namespace {

enum class Wide : std::uint8_t { First, Last = 99, Count };

constexpr EnumTable<Gear, int> kTeeth{{{Gear::Low, 40}, {Gear::Middle, 30}, {Gear::High, 20}}};

TEST(EnumTable, GivesTheRowOfEachEnumerator) {
  static_assert(kTeeth[Gear::Middle] == 30);
  for (const Gear gear : kAllOf<Gear>) EXPECT_EQ(kTeeth[gear], 40 - 10 * static_cast<int>(gear));
}

inline constexpr std::array kUsed{Gear::Low, Gear::High};

TEST(KeyTable, HasRowsForItsKeysAlone) {
  constexpr KeyTable<kUsed, const char*> kNames{{{Gear::Low, "low"}, {Gear::High, "high"}}};
  EXPECT_STREQ(*kNames.find(Gear::High), "high");
  EXPECT_EQ(kNames.find(Gear::Middle), nullptr);
}

TEST(EnumArray, StartsWithDefaultValues) {
  EnumArray<Gear, int> counts;
  ++counts[Gear::High];
  EXPECT_EQ(counts[Gear::Low], 0);
  EXPECT_EQ(counts[Gear::High], 1);
}

TEST(EnumSet, HoldsMoreThanAWordOfEnumerators) {
  EnumSet<Wide> set{Wide::Last};
  EXPECT_TRUE(set.has(Wide::Last));
  EXPECT_FALSE(set.has(Wide::First));
  EnumSet<Wide> other{Wide::First};
  EXPECT_TRUE((set & other).isEmpty());
  other |= set;
  EXPECT_EQ(other, (EnumSet<Wide>{Wide::First, Wide::Last}));
  EXPECT_EQ(other.count(), 2u);
  EXPECT_EQ(other - set, EnumSet(Wide::First));
  other.remove(Wide::First);
  EXPECT_EQ(other, set);
}

}  // namespace
}  // namespace deckpipe
