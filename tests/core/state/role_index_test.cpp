// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/role_index.h"

#include <gtest/gtest.h>

#include <random>

#include "protocol/samples.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

TEST(RoleIndex, ClassifiesFromAnyRowAsAWalkFromTheStartDoes) {
  std::mt19937 random(7);
  FrameStore frames;
  NoteStore notes;
  std::vector<Frame> batch;
  std::int64_t stamp = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Sample& sample = kSamples[random() % std::size(kSamples)];
    Frame f = test::frame(sample.id, sample.data, static_cast<std::uint8_t>(random() % 6));
    if (f.isExtended() && random() % 2 == 0)
      f.id = (f.id & ~0xFFu) | static_cast<std::uint32_t>(0x80 + random() % 3);
    if (sample.message == MessageId::Name && random() % 2 == 0)
      f.data[2] = static_cast<std::uint8_t>(random());
    f.stamp = stamp += static_cast<std::int64_t>(random() % 200'000'000);
    batch.push_back(f);
  }
  ASSERT_TRUE(frames.append(batch));
  for (std::uint64_t i = 50; i < batch.size(); i += 611) {
    const Channel channel{static_cast<std::uint8_t>(random() % 6)};
    const NoteValue values[] = {note::DriveSaid{channel, {0x81}, i % 2 == 0}, note::LinkDown{channel, {}, {}},
                                note::LinkUp{channel}};
    for (const NoteValue& value : values) {
      if (random() % 2 == 0) notes.append({.frame = i, .time = frames.timeAt(i - 1), .value = value});
    }
  }
  RoleIndex index(frames, notes);
  while (index.build(777)) {
  }
  ASSERT_EQ(index.built(), frames.count());

  RoleWalk straight;
  std::vector<Classified> expected;
  const std::vector<Note> all = notes.all();
  std::size_t nextNote = 0;
  for (std::uint64_t i = 0; i < frames.count(); ++i) {
    for (; nextNote < all.size() && all[nextNote].frame == i; ++nextNote) teach(straight, all[nextNote]);
    expected.push_back(straight.next(frames[i], frames.timeAt(i)));
  }
  for (int round = 0; round < 300; ++round) {
    const std::uint64_t i = random() % frames.count();
    ASSERT_EQ(index.walk(i).next(frames[i], frames.timeAt(i)), expected[i]) << "row " << i;
  }

  // One who goes through it, now and then back.
  RoleIndex::Stand stand;
  const auto classifySome = [&] {
    for (std::uint64_t i = 0, round = 0; round < 2'000; ++round, i = (i + random() % 97) % frames.count())
      ASSERT_EQ(index.classify(i, frames[i], frames.timeAt(i), stand), expected[i]) << "row " << i;
  };
  classifySome();

  index.invalidateAfter(9'000);
  EXPECT_EQ(index.built(), 9'000u);
  while (index.build(5'000)) {
  }
  for (int round = 0; round < 100; ++round) {
    const std::uint64_t i = random() % frames.count();
    ASSERT_EQ(index.walk(i).next(frames[i], frames.timeAt(i)), expected[i]) << "row " << i;
  }
  classifySome();
}

}  // namespace
}  // namespace deckpipe
