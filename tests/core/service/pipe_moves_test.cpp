// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the data pipe walked whole: each state is reached, each event made from outside, on a device
// of the simulator. That two pipes join is made in pipe_test.cpp (Moved).
#include <gtest/gtest.h>

#include "service/pipe.h"
#include "support/pair.h"

namespace deckpipe::test {
namespace {

using State = PipeStatus::Progress;
using What = intent::PipeAction::What;

constexpr std::array<const char*, kPipeStates> kStateNames{"Idle", "Sending", "Settling", "Paused",
                                                           "Stalled"};
constexpr std::array<const char*, kPipeMoves> kMoveNames{"Next",     "Nothing", "Hold",     "Ack",
                                                         "AckAgain", "Silence", "LateEcho", "Resend",
                                                         "Skip",     "GiveUp",  "Settled",  "Joined"};

class PipeTable : public ::testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  PipeTable() {
    pair.unlock();
    pair.wire = [this](const Frame& f) {
      const bool isAck = f.length == 1 && f.data[0] == 0xFE;
      const bool isOurs = J1939Id::of(f.identifier()).source == Address{0xF9};
      return Fate{isAck && !isOurs && losesAcks ? 0 : 1, 0ns};
    };
  }
  State state() { return pair.console().pipe(pair.now(), monitor).progress; }
  void type() {
    pair.intend(intent::PipeWrite{monitor, "x"});
    pair.run(2 * Pair::kFlight);
  }
  void act(What what) {
    pair.intend(intent::PipeAction{monitor, what});
    pair.run(2 * Pair::kFlight);
  }
  void ack() {
    Frame f = frame("18EF0000", "FE");
    f.id = J1939Id{6, pgn::kProprietaryA, pair.addressOf(monitor), Address{0xF9}}.frameId();
    losesAcks = false;
    pair.inject(f);
    pair.run(2 * Pair::kFlight);
    losesAcks = true;
  }
  void keepPackets(Duration wait) {
    pair.console().leaves = [wait](const Frame& f) {
      const bool isPacket = J1939Id::of(f.identifier()).pgn == pgn::kProprietaryA && f.data[0] == 0xFE;
      return std::optional<Duration>(isPacket ? wait : Duration{0});
    };
  }

  // With a packet that was sent twice, or one that is not on the bus, where the move is about such a one.
  void reach(State wanted, PipeMove move) {
    type();
    ack();
    const bool isTwice = move == PipeMove::AckAgain;
    if (move == PipeMove::LateEcho && wanted == State::Stalled) keepPackets(Pipe::kAckTimeout + 500ms);
    if (wanted == State::Paused) act(What::Pause);
    if (wanted == State::Idle || wanted == State::Paused) return;
    type();
    if (wanted == State::Sending && !isTwice) return;
    pair.run(Pipe::kAckTimeout + 50ms);
    if (wanted == State::Settling) return act(What::Skip);
    if (!isTwice) return;
    act(What::Resend);
    if (wanted == State::Stalled) pair.run(Pipe::kAckTimeout + 50ms);
  }
  void make(PipeMove move, State in) {
    constexpr Duration kShort = 900ms;  // neither ack nor settling times out
    switch (move) {
      case PipeMove::Next:
        type();
        if (in == State::Paused) act(What::Resume);
        return;
      case PipeMove::Nothing: return act(What::Resume);
      case PipeMove::Hold: return act(What::Pause);
      case PipeMove::Ack:
      case PipeMove::AckAgain: return ack();
      case PipeMove::Silence: return pair.run(in == State::Settling ? kShort : Pipe::kAckTimeout + 50ms);
      case PipeMove::LateEcho: return pair.run(in == State::Stalled ? 600ms : kShort);
      case PipeMove::Resend: return act(What::Resend);
      case PipeMove::Skip: return act(What::Skip);
      case PipeMove::GiveUp: return act(What::Abort);
      case PipeMove::Settled: return pair.run(in == State::Settling ? Pipe::kSettle : kShort);
      case PipeMove::Joined:
      case PipeMove::Count: return;
    }
  }

  TruckPair pair;
  const DeviceKey monitor = TruckPair::monitor();
  bool losesAcks = true;
};

TEST_P(PipeTable, EachEventInEachStateLeadsWhereTheTableSays) {
  const auto from = static_cast<State>(std::get<0>(GetParam()));
  const auto move = static_cast<PipeMove>(std::get<1>(GetParam()));
  reach(from, move);
  ASSERT_EQ(state(), from);
  make(move, from);
  EXPECT_EQ(state(), after(from, move).value_or(from));
}

INSTANTIATE_TEST_SUITE_P(All, PipeTable,
                         ::testing::Combine(::testing::Range(std::size_t{0}, kPipeStates),
                                            ::testing::Range(std::size_t{0}, kPipeMoves - 1)),
                         [](const auto& row) {
                           return std::string(kStateNames[std::get<0>(row.param)]) +
                                  kMoveNames[std::get<1>(row.param)];
                         });

}  // namespace
}  // namespace deckpipe::test
