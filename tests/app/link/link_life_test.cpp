// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/link_life.h"

#include <gtest/gtest.h>

#include <set>

namespace deckpipe {
namespace {

using enum LinkStage;

template <typename Visit>
void forEachStage(Visit visit) {
  for (const LinkStage stage : kAllOf<LinkStage>) visit(stage);
}
template <typename Visit>
void forEachMove(Visit visit) {
  forEachStage([&](LinkStage stage) {
    for (const LinkEvent event : kAllOf<LinkEvent>) {
      SCOPED_TRACE(::testing::Message()
                   << "stage " << static_cast<int>(stage) << ", event " << static_cast<int>(event));
      visit(stage, event, next(stage, event));
    }
  });
}

struct Move {
  LinkStage from;
  LinkEvent event;
  LinkStage to;
};

// Every move there is. Whatever is not listed leaves the stage as it is.
constexpr Move kMoves[] = {
    {Closed, LinkEvent::Open, Asking},
    // The first opening ends in Up or in Closed with a reason.
    {Asking, LinkEvent::Fits, Opening},
    {Asking, LinkEvent::IsDown, Closed},
    {Asking, LinkEvent::Unfit, Closed},
    {Asking, LinkEvent::Missing, Closed},
    {Asking, LinkEvent::DeviceFailed, Closed},
    {Opening, LinkEvent::DeviceConnected, Up},
    {Opening, LinkEvent::IsDown, Closed},
    {Opening, LinkEvent::Unfit, Closed},
    {Opening, LinkEvent::Missing, Closed},
    {Opening, LinkEvent::DeviceFailed, Closed},
    // What was up is lost, and comes back by itself.
    {Up, LinkEvent::IsDown, Down},
    {Up, LinkEvent::Unfit, Away},
    {Up, LinkEvent::Missing, Away},
    {Up, LinkEvent::DeviceFailed, Away},
    {Down, LinkEvent::Fits, Up},
    {Down, LinkEvent::Unfit, Away},
    {Down, LinkEvent::Missing, Away},
    {Down, LinkEvent::DeviceFailed, Away},
    {Away, LinkEvent::Fits, Returning},
    {Returning, LinkEvent::DeviceConnected, Up},
    {Returning, LinkEvent::IsDown, Away},
    {Returning, LinkEvent::Unfit, Away},
    {Returning, LinkEvent::Missing, Away},
    {Returning, LinkEvent::DeviceFailed, Away},
};

TEST(LinkLife, GoesFromEachStageByEachEventWhereItShould) {
  forEachMove([](LinkStage stage, LinkEvent event, LinkStage to) {
    LinkStage expected = stage;
    for (const Move& move : kMoves) {
      if (move.from == stage && move.event == event) expected = move.to;
    }
    if (event == LinkEvent::Close) expected = Closed;
    EXPECT_EQ(to, expected);
  });
}

TEST(LinkLife, ComesUpOnlyByAConnectedDeviceOnAnInterfaceThatFits) {
  forEachMove([](LinkStage stage, LinkEvent event, LinkStage to) {
    if (to != Up || stage == Up) return;
    EXPECT_TRUE(hasDevice(stage));
    EXPECT_TRUE(event == LinkEvent::DeviceConnected || event == LinkEvent::Fits);
  });
}

TEST(LinkLife, IsUpOnNoInterfaceThatIsDownUnfitOrMissing) {
  forEachMove([](LinkStage, LinkEvent event, LinkStage to) {
    const bool isBad = event == LinkEvent::IsDown || event == LinkEvent::Unfit ||
                       event == LinkEvent::Missing || event == LinkEvent::DeviceFailed;
    EXPECT_FALSE(isBad && to == Up);
  });
}

TEST(LinkLife, ConnectsADeviceOnlyWhereTheInterfaceFits) {
  forEachMove([](LinkStage stage, LinkEvent event, LinkStage to) {
    if (hasDevice(stage) || !hasDevice(to)) return;
    EXPECT_EQ(event, LinkEvent::Fits);
    EXPECT_TRUE(isWaiting(to)) << "a device that never answers is given up";
  });
}

TEST(LinkLife, IsLostOnlyAfterItWasUpAndNeverConnectingAgain) {
  forEachMove([](LinkStage stage, LinkEvent, LinkStage to) {
    const bool wasUp = shown(stage) == LinkState::Up || shown(stage) == LinkState::Lost;
    EXPECT_FALSE(shown(to) == LinkState::Lost && !wasUp);
    EXPECT_FALSE(shown(to) == LinkState::Connecting && wasUp);
  });
}

TEST(LinkLife, EveryStageIsReachedAndNoneWaitsForEver) {
  std::set<LinkStage> reached{Closed};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    forEachMove([&](LinkStage stage, LinkEvent, LinkStage to) {
      if (reached.contains(stage)) reached.insert(to);
    });
  }
  EXPECT_EQ(reached.size(), kCountOf<LinkStage>);
  forEachStage([](LinkStage stage) { EXPECT_FALSE(isWaiting(next(stage, LinkEvent::DeviceFailed))); });
}

}  // namespace
}  // namespace deckpipe
