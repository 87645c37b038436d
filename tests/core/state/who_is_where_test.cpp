// SPDX-License-Identifier: GPL-3.0-or-later
// State, a walk without one, the index of roles, conversations and events agree on who is at which address,
// at every frame of random claim traffic.
#include <gtest/gtest.h>

#include <random>

#include "protocol/samples.h"
#include "state/advance.h"
#include "state/log_view.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::frame;

constexpr std::uint8_t kChannels = 3;
constexpr unsigned kFirst = 0x80, kAddresses = 4;
// From low to high; the second and third are the NAMEs of the PINs.
constexpr const char* kNames[] = {"0100200000000000", "0B1AC22800420090", "0C1AC22800420090",
                                  "02002001000000FE", "01002001000000FF", "0000000000000000"};
constexpr const char* kPins[] = {"FF83150206021A0B", "FF83150206021A0C", "FF83150206021A0D"};
constexpr const char* kTalk[] = {"02", "02000000000000", "FE41", "FE", "46", "41"};

class ClaimTraffic : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    std::mt19937 random(GetParam() ? 11 : 12);
    constexpr Duration kSteps[] = {0ns, 1ms, 20ms, 100ms, 249ms, 250ms, 251ms};
    std::int64_t stamp = 0;
    std::vector<Frame> batch;
    const auto address = [&] { return kFirst + static_cast<unsigned>(random() % kAddresses); };
    const auto among = [&](const auto& words) { return words[random() % std::size(words)]; };
    for (int i = 0; i < 20'000; ++i) {
      char id[9];
      std::string_view data;
      switch (random() % 8) {
        case 0:
        case 1:
          std::snprintf(id, sizeof id, "18EEFF%02X", random() % 12 == 0 ? 0xFEu : address());
          data = among(kNames);
          break;
        case 2:
          std::snprintf(id, sizeof id, "18EFFF%02X", address());
          data = among(kPins);
          break;
        case 3:
          std::snprintf(id, sizeof id, "18EFFF%02X", address());
          data = "011D940371000041";
          break;
        case 4: std::snprintf(id, sizeof id, "18FF00%02X", address()); break;
        default:
          std::snprintf(id, sizeof id, "18EF%02X%02X", address(), random() % 2 == 0 ? 0xF9u : address());
          data = among(kTalk);
      }
      stamp += kSteps[random() % (random() % 3 == 0 ? std::size(kSteps) : 3)].count();
      batch.push_back(
          frame(id, data, static_cast<std::uint8_t>(random() % kChannels), GetParam() ? stamp : kNoStamp));
    }
    ASSERT_TRUE(m_log.frames.append(batch));
    for (std::uint64_t i = 30; i < batch.size(); i += 1 + random() % 200) {
      // Anywhere in the silence before the frame.
      const Instant from = m_log.frames.timeAt(i - 1);
      const auto gap = (m_log.frames.timeAt(i) - from).count();
      const Channel channel{static_cast<std::uint8_t>(random() % kChannels)};
      const NoteValue values[] = {
          note::DriveSaid{channel, {static_cast<std::uint8_t>(address())}, random() % 2 == 0},
          note::LinkDown{channel, {}, {}}, note::LinkUp{channel}};
      const std::size_t which = random() % 8;
      m_log.notes.append({.frame = i,
                          .time = from + Duration(gap == 0 ? 0 : static_cast<std::int64_t>(random()) % gap),
                          .value = values[which < std::size(values) ? which : 0]});
    }
    while (m_log.roles.build(777)) {
    }
  }
  // Every frame in order: `each` is given the frame's index and a walk that stands before it, its time come.
  template <typename Each>
  void walk(Each each) {
    RoleWalk walk;
    const std::vector<Note> notes = m_log.notes.all();
    std::size_t nextNote = 0;
    for (std::uint64_t i = 0; i < m_log.frames.count(); ++i) {
      for (; nextNote < notes.size() && notes[nextNote].frame == i; ++nextNote) teach(walk, notes[nextNote]);
      const Instant time = m_log.frames.timeAt(i);
      walk.timeCame(time);
      each(i, walk);
      walk.next(m_log.frames[i], time);
    }
  }

  LogDocument m_log;
};

TEST_P(ClaimTraffic, IsToldAlikeByStateAndWalk) {
  State state;
  std::uint64_t contested = 0;
  walk([&](std::uint64_t i, const RoleWalk& walk) {
    advance(state, m_log.frames, m_log.notes, {i, m_log.frames.timeAt(i)});
    for (std::uint8_t c = 0; c < kChannels; ++c) {
      const Channel channel{c};
      const AddressBook& book = walk.book(channel);
      ASSERT_EQ(state.channel(channel).book, book) << "frame " << i;
      for (unsigned a = kFirst; a < kFirst + kAddresses; ++a) {
        const Address address{static_cast<std::uint8_t>(a)};
        const Device* device = state.devices().byAddress(channel, address);
        ASSERT_EQ(device == nullptr ? Pin() : device->pin, book.pin(address)) << "frame " << i;
        contested += book.isContested(address);
      }
    }
  });
  EXPECT_EQ(contested > 1'000, GetParam()) << "the traffic is worth the test";
}

TEST_P(ClaimTraffic, IsToldAlikeByTheIndexFromAnywhere) {
  std::vector<std::uint64_t> places;
  std::mt19937 random(3);
  for (int i = 0; i < 400; ++i) places.push_back(random() % m_log.frames.count());
  std::vector<std::pair<std::uint64_t, RoleWalk>> expected;
  std::ranges::sort(places);
  walk([&](std::uint64_t i, const RoleWalk& walk) {
    if (std::ranges::binary_search(places, i)) expected.emplace_back(i, walk);
  });
  std::ranges::shuffle(expected, random);
  RoleIndex::Stand stand;
  const auto compare = [&] {
    for (const auto& [i, walk] : expected) {
      const Frame& here = m_log.frames[i];
      const Instant time = m_log.frames.timeAt(i);
      for (std::uint8_t c = 0; c < kChannels; ++c)
        ASSERT_EQ(m_log.roles.bookBefore(i, {c}, stand), walk.book({c})) << "frame " << i;
      ASSERT_EQ(m_log.roles.walk(i).next(here, time), walk.peek(here, time)) << "frame " << i;
    }
  };
  compare();
  m_log.roles.invalidateAfter(9'000);
  while (m_log.roles.build(5'000)) {
  }
  compare();
}

TEST_P(ClaimTraffic, IsToldAlikeByExchanges) {
  while (m_log.exchanges.build(333)) {
  }
  const auto exchanges = m_log.exchanges.list();
  std::size_t next = 0, identified = 0;
  walk([&](std::uint64_t i, const RoleWalk& walk) {
    const Channel channel{m_log.frames[i].channel};
    const AddressBook& book = walk.book(channel);
    for (; next < exchanges->size() && (*exchanges)[next].frame == i; ++next) {
      const Exchange& exchange = (*exchanges)[next];
      const J1939Id id = J1939Id::of(m_log.frames[i].identifier());
      const Pin pin = book.pin(exchange.isFromDevice ? id.source : id.destination);
      ASSERT_EQ(exchange.device.pin, pin) << "frame " << i;
      identified += !pin.isNull();
    }
  });
  EXPECT_GT(identified, 1'000u) << "the traffic is worth the test";
}

INSTANTIATE_TEST_SUITE_P(Logs, ClaimTraffic, testing::Bool(),
                         [](const auto& row) { return row.param ? "WithTimes" : "WithoutTimes"; });

}  // namespace
}  // namespace deckpipe
