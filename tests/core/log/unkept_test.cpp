// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/unkept.h"

#include <gtest/gtest.h>

#include <set>

namespace deckpipe {
namespace {

TEST(Unkept, KeepsTheFirstPlacesAndCountsAll) {
  UnkeptList list;
  for (std::uint64_t i = 1; i <= 25'000; ++i) list.add(i, i % 5 == 0 ? Unkept::CanFd : Unkept::Layout);
  const UnkeptPlaces content = list.content();
  EXPECT_EQ(content.places().size(), UnkeptPlaces::kMaxPlaces);
  EXPECT_EQ(content.places().back().place, UnkeptPlaces::kMaxPlaces);
  EXPECT_EQ(content.count(Unkept::CanFd), 5'000u);
  EXPECT_EQ(content.unreadable(), 20'000u);
  EXPECT_EQ(content.understood(), 5'000u);
}

TEST(Unkept, ListsJoinedAreTheListOfAll) {
  UnkeptPlaces whole, joined;
  for (std::uint64_t block = 0; block < 5; ++block) {
    UnkeptPlaces part;
    for (std::uint64_t i = 1; i <= 3'000; ++i) {
      part.add(i, Unkept::Data);
      whole.add(block * 3'000 + i, Unkept::Data);
    }
    joined.add(part, block * 3'000);
  }
  EXPECT_EQ(joined.places(), whole.places());
  EXPECT_EQ(joined.count(Unkept::Data), 15'000u);
}

TEST(Unkept, EveryReasonHasATextOfItsOwn) {
  std::set<std::string_view> texts;
  for (const Unkept reason : kAllOf<Unkept>) texts.insert(unkeptText(reason));
  EXPECT_EQ(texts.size(), kCountOf<Unkept>);
  EXPECT_FALSE(texts.contains(""));
}

}  // namespace
}  // namespace deckpipe
