// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/skipped.h"

#include <gtest/gtest.h>

#include <set>

namespace deckpipe {
namespace {

TEST(Skipped, KeepsTheFirstPlacesAndCountsAll) {
  SkippedList list;
  for (std::uint64_t i = 1; i <= 25'000; ++i) list.add(i, i % 5 == 0 ? Skipped::CanFd : Skipped::Layout);
  const SkippedPlaces content = list.content();
  EXPECT_EQ(content.places().size(), SkippedPlaces::kMaxPlaces);
  EXPECT_EQ(content.places().back().place, SkippedPlaces::kMaxPlaces);
  EXPECT_EQ(content.count(Skipped::CanFd), 5'000u);
  EXPECT_EQ(content.unreadable(), 20'000u);
  EXPECT_EQ(content.understood(), 5'000u);
}

TEST(Skipped, ListsJoinedAreTheListOfAll) {
  SkippedPlaces whole, joined;
  for (std::uint64_t block = 0; block < 5; ++block) {
    SkippedPlaces part;
    for (std::uint64_t i = 1; i <= 3'000; ++i) {
      part.add(i, Skipped::Data);
      whole.add(block * 3'000 + i, Skipped::Data);
    }
    joined.add(part, block * 3'000);
  }
  EXPECT_EQ(joined.places(), whole.places());
  EXPECT_EQ(joined.count(Skipped::Data), 15'000u);
}

TEST(Skipped, EveryReasonHasATextOfItsOwn) {
  std::set<std::string_view> texts;
  for (const Skipped reason : kAllOf<Skipped>) texts.insert(skippedText(reason));
  EXPECT_EQ(texts.size(), kCountOf<Skipped>);
  EXPECT_FALSE(texts.contains(""));
}

}  // namespace
}  // namespace deckpipe
