// SPDX-License-Identifier: GPL-3.0-or-later
// Console and truck over a wire that loses, delays and doubles frames at random, with claims from outside and
// restarts: seeded, hundreds of times. Whatever happens, every request comes to an end, never two of a kind
// are in flight, a packet of the pipe goes twice only by hand, and locked nothing goes out.
#include <gtest/gtest.h>

#include "simulator/random.h"
#include "support/enums.h"
#include "support/pair.h"

namespace deckpipe::test {
namespace {

class Storm : public ::testing::TestWithParam<int> {};

TEST_P(Storm, EverythingComesToAnEndAndNothingIsSentThatShouldNot) {
  simulator::Random random(static_cast<std::uint64_t>(GetParam()));
  TruckPair pair(random.next());
  const auto chance = [&](int percent) { return random.between(0, 99) < percent; };
  const auto oneOf = [&](const auto& values) {
    return values[static_cast<std::size_t>(random.between(0, static_cast<int>(std::size(values)) - 1))];
  };
  const int lost = random.between(0, 30), late = random.between(0, 30), doubled = random.between(0, 20);
  pair.wire = [&](const Frame&) {
    if (chance(lost)) return Pair::Fate{0, 0ns};
    return Pair::Fate{chance(doubled) ? 2 : 1,
                      chance(late) ? random.between(0, 1200) * Duration(1ms) : Duration{0}};
  };
  pair.unlock();
  const DeviceKey monitor = TruckPair::monitor();
  std::string typed;
  for (int i = 0; i < 30; ++i) {
    switch (random.between(0, 9)) {
      case 0: pair.intend(intent::SendRequests{{}, kPolls}); break;
      case 1: pair.intend(intent::SendRequests{monitor, RequestSet{oneOf(kAllOf<Request>)}}); break;
      case 2: pair.intend(intent::Repeat{monitor, kPolls, random.between(0, 3) * Duration(1s)}); break;
      case 3: pair.intend(intent::PipeWrite{monitor, "0123456789"}); break;
      case 4:
        pair.intend(intent::PipeFile{monitor, "f", std::make_shared<const std::string>(200, 'f')});
        break;
      case 5: pair.intend(intent::PipeAction{monitor, oneOf(allOf<intent::PipeAction::What>())}); break;
      case 6:
        pair.inject(frame(chance(50) ? "18EEFFF9" : "18EEFFFA",
                          chance(50) ? "0100000000000000" : "FFFFFFFFFFFFFFFF"));
        break;
      case 7:
        pair.setLink(pair.console(), false);
        pair.run(random.between(0, 500) * Duration(1ms));
        pair.setLink(pair.console(), true);
        break;
      case 8: pair.intend(intent::RequestNames{}); break;
      default:
        if (chance(30)) {
          pair.intend(intent::Lock{});
          const Instant locked = pair.now();
          pair.run(2s);
          ASSERT_TRUE(pair.sentBy(&pair.console(), locked + 1ns).empty());
          pair.intend(intent::Unlock{});
        }
    }
    pair.run(random.between(0, 3000) * Duration(1ms));
  }
  // Without repeats everything is over after the longest deadline there is.
  pair.intend(intent::Repeat{{}, kPolls, 0s});
  pair.run(30s);
  for (const DeviceServices& device : pair.console().status(pair.now()).devices) {
    for (const RequestStatus& request : device.requests) {
      EXPECT_TRUE(request.progress == RequestStatus::Progress::Idle ||
                  request.progress == RequestStatus::Progress::Ended)
          << static_cast<int>(request.progress);
    }
  }
  // Of one kind to one device: never a second one within the patience of the first unless it was answered.
  std::map<std::pair<std::uint8_t, std::uint8_t>, Instant> last;
  for (const Pair::Seen& seen : pair.log) {
    const J1939Id id = seen.id();
    if (id.pgn != pgn::kProprietaryA || seen.frame.length != 1) continue;
    const std::uint8_t type = seen.frame.data[0];
    if (type != 0x41 && type != 0x45 && type != 0x46) continue;
    if (seen.sender == nullptr) continue;
    const auto at = std::pair(type, id.destination.value);
    if (last.contains(at)) {
      EXPECT_GT(seen.time - last[at], 0ns);
    }
    last[at] = seen.time;
  }
  const ClaimStatus claim = pair.claim();
  EXPECT_NE(claim.progress, ClaimStatus::Progress::Claiming);
  EXPECT_NE(claim.progress, ClaimStatus::Progress::Asking);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Storm, ::testing::Range(1, 301));

}  // namespace
}  // namespace deckpipe::test
