// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/own_frames.h"

#include <gtest/gtest.h>

#include "support/raw_frames.h"

namespace deckpipe {
namespace {

using namespace test;

TEST(OwnFrames, EachComesBackOnce) {
  OwnFrames own;
  own.wrote(frameOf(0x123, {1}));
  own.wrote(frameOf(0x123, {1}));
  EXPECT_TRUE(own.cameBack(frameOf(0x123, {1})));
  EXPECT_EQ(own.waiting(), 1u);
  EXPECT_TRUE(own.cameBack(frameOf(0x123, {1})));
  EXPECT_FALSE(own.cameBack(frameOf(0x123, {1})));
}

// Told by which one is given up next: of the two equal frames the first has come back.
TEST(OwnFrames, EqualFramesComeBackFirstInFirstOut) {
  OwnFrames own(3);
  own.wrote(frameOf(0x123, {1}));
  own.wrote(frameOf(0x200, {}));
  own.wrote(frameOf(0x123, {1}));
  EXPECT_TRUE(own.cameBack(frameOf(0x123, {1})));
  own.wrote(frameOf(0x300, {}));
  own.wrote(frameOf(0x400, {}));  // one too many: 200 is the oldest now
  EXPECT_TRUE(own.cameBack(frameOf(0x123, {1}))) << "the second one was taken for the first";
  EXPECT_FALSE(own.cameBack(frameOf(0x200, {})));
}

TEST(OwnFrames, StampChannelAndFlagsDoNotMatter) {
  OwnFrames own;
  own.wrote(frameOf(0x123, {1}));
  Frame echo = frameOf(0x123, {1});
  echo.stamp = 5;
  echo.channel = 2;
  echo.flags = Frame::kSent;
  EXPECT_TRUE(own.cameBack(echo));
}

TEST(OwnFrames, IdentifierBitsLengthAndDataDo) {
  OwnFrames own;
  own.wrote(frameOf(0x123, {0}));
  EXPECT_FALSE(own.cameBack(extendedFrame(0x123, {0})));
  EXPECT_FALSE(own.cameBack(frameOf(0x123, {0, 0})));
  EXPECT_FALSE(own.cameBack(frameOf(0x123, {1})));
  EXPECT_EQ(own.waiting(), 1u);
}

TEST(OwnFrames, ALaterOneMayOvertake) {
  OwnFrames own;
  own.wrote(frameOf(0x700, {}));
  own.wrote(frameOf(0x080, {}));
  EXPECT_TRUE(own.cameBack(frameOf(0x080, {})));
  EXPECT_TRUE(own.cameBack(frameOf(0x700, {})));
}

TEST(OwnFrames, OfEqualFramesTheFirstHandedOverComesBackFirst) {
  OwnFrames own;
  own.wrote(frameOf(0x123, {1}), {0, 1}, Instant{10});
  own.wrote(frameOf(0x124, {1}), {1, 2}, Instant{20});
  own.wrote(frameOf(0x123, {1}), {2, 3}, Instant{30});
  EXPECT_EQ(own.waitingSince(Instant{20}), 2u);
  EXPECT_EQ(own.take(frameOf(0x123, {1})).value().tag, (FrameTag{0, 1}));
  EXPECT_EQ(own.take(frameOf(0x123, {1})).value().when, Instant{30});
  EXPECT_FALSE(own.take(frameOf(0x123, {1})));
  ASSERT_EQ(own.takeAll().size(), 1u);
  EXPECT_EQ(own.waiting(), 0u);
}

TEST(OwnFrames, TheOldestIsGivenUpAboveTheLimit) {
  OwnFrames own(2);
  EXPECT_FALSE(own.wrote(frameOf(0x123, {0}), {7, 1}));
  EXPECT_FALSE(own.wrote(frameOf(0x123, {1})));
  EXPECT_EQ(own.wrote(frameOf(0x123, {2})).value().tag, (FrameTag{7, 1}));
  EXPECT_EQ(own.waiting(), 2u);
  EXPECT_FALSE(own.cameBack(frameOf(0x123, {0})));
  EXPECT_TRUE(own.cameBack(frameOf(0x123, {2})));
}

}  // namespace
}  // namespace deckpipe
