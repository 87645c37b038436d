// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl move against the simulated truck on a virtual bus of this process. A computer that is too busy for
// motion ends a move by the rules; such a run is made again.
#include <QTimer>
#include <csignal>

#include "bus/j1939.h"
#include "live.h"
#include "protocol/typed.h"
#include "session/arming_lock.h"
#include "simulator/address_claim.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::kMonitor;
using test::kPatience;
using test::Outcome;
using test::text;
using test::words;

constexpr std::uint8_t kOurJoystick = 0x38;
constexpr const char* kMove = "move --unlock --pin 1032AE100801035 --x 30";

class Move : public test::Live {
 protected:
  Move() { m_simulator.simulator().joystick->release(); }
  // Out of its stowed position, which it would leave in the middle of the move otherwise.
  void SetUp() override {
    Live::SetUp();
    QTimer up;
    QObject::connect(&up, &QTimer::timeout, &up, [this] {
      Frame back = test::frame("0CFDD634", "010004FA00000000");
      m_witnessLink->write(back);
    });
    up.start(20);
    ASSERT_TRUE(QTest::qWaitFor([this] { return elevation() > -300; }, kPatience));
    up.stop();
    const auto isStill = [this] {
      const std::size_t n = m_positions.size();
      return n > 5 && m_positions[n - 1] == m_positions[n - 4];
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return look(), isStill(); }, kPatience));
  }

  static std::uint8_t source(const Frame& frame) { return static_cast<std::uint8_t>(frame.id); }
  static bool isStick(const Frame& frame) {
    return source(frame) == kOurJoystick && J1939Id::of(frame.identifier()).pgn == pgn::kBasicJoystick;
  }
  static bool isMotion(const Frame& frame) {
    return isStick(frame) && frame.data != test::frame("00000000", "0100010000000000").data;
  }
  // The positions that the monitor said so far.
  void look() {
    for (; m_seen < m_witness.frames.size(); ++m_seen) {
      const Frame& frame = m_witness.frames[m_seen];
      if (frame.isExtended() && J1939Id::of(frame.identifier()).pgn == pgn::kProprietaryA &&
          source(frame) == m_status.devices[0].address.value && frame.data[0] == 0x01)
        m_positions.push_back(PositionLimitStatus::of(frame));
    }
  }
  int elevation() {
    look();
    return m_positions.empty() ? -1000 : m_positions.back().elevation.tenths;
  }
  std::size_t motionFrames() const {
    return static_cast<std::size_t>(std::ranges::count_if(m_witness.frames, isMotion));
  }
  // What the last message of our joystick was.
  bool endsByNeutral() const {
    const auto last = std::find_if(m_witness.frames.rbegin(), m_witness.frames.rend(), isStick);
    return last != m_witness.frames.rend() && !isMotion(*last);
  }
  static bool wasTooBusy(const Outcome& r) {
    return r.err.contains("too busy") || r.err.contains("do not reach the bus") ||
           r.err.contains("a monitor is not heard any more") || r.err.contains("another Deckpipe") ||
           r.err.contains("a controller appeared");
  }
  Outcome move(const char* more, const QByteArray& input = {}) {
    Outcome r;
    for (int i = 0; i < 10; ++i) {
      r = run(kMove, input, words(more));
      if (!wasTooBusy(r)) break;
    }
    return r;
  }
  // Until it moves.
  void startMoving(QProcess& process, const char* more) {
    for (int i = 0; i < 10; ++i) {
      const std::size_t before = motionFrames();
      start(process, kMove, words(more));
      const auto moves = [&] { return motionFrames() > before + 5; };
      ASSERT_TRUE(
          QTest::qWaitFor([&] { return moves() || process.state() == QProcess::NotRunning; }, kPatience));
      if (process.state() != QProcess::NotRunning) return;
    }
    FAIL() << process.readAllStandardError().constData();
  }

  std::size_t m_seen = 0;
  std::vector<PositionLimitStatus> m_positions;
};

TEST_F(Move, Rule20ItMovesForSoLongAndEndsByNeutral) {
  const Outcome r = move("--for 1000");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  ASSERT_EQ(r.objects().size(), 1) << r.out.constData();
  const QJsonObject line = r.objects()[0];
  EXPECT_EQ(text(line, "pin"), QLatin1String(kMonitor));
  EXPECT_EQ(line[QLatin1String("source")].toInt(), kOurJoystick);
  EXPECT_EQ(text(line, "end"), QStringLiteral("done"));
  EXPECT_GT(line[QLatin1String("rotation_deg")].toDouble(),
            line[QLatin1String("rotation_before_deg")].toDouble() + 1);
  EXPECT_GT(line[QLatin1String("frames")].toInt(), 50);
  EXPECT_TRUE(r.err.contains("moves 1 monitor, and whoever else listens to address 38")) << r.err.constData();
  EXPECT_TRUE(endsByNeutral());
  for (const Frame& frame : m_witness.frames) {
    if (source(frame) != kOurJoystick) continue;
    const std::uint32_t pgn = J1939Id::of(frame.identifier()).pgn;
    EXPECT_TRUE(pgn == pgn::kBasicJoystick || pgn == pgn::kAddressClaimed);
    EXPECT_LE(std::abs(BasicJoystick::of(frame).x.tenths.value_or(0)),
              pgn == pgn::kBasicJoystick ? 300 : 1000);
  }
}

TEST_F(Move, Rule20WhatIsMissingOrTooMuchIsRefusedBeforeAnything) {
  for (const char* bad :
       {"move --pin 1032AE100801035 --x 30 --for 1000", "move --unlock --x 30 --for 1000",
        "move --unlock --pin 1032AE100801035 --for 1000", "move --unlock --pin 1032AE100801035 --x 30",
        "move --unlock --pin 1032AE100801035 --x 30.1 --for 1000",
        "move --unlock --pin 1032AE100801035 --y -31 --for 1000",
        "move --unlock --pin 1032AE100801035 --x 30 --for 10001",
        "move --unlock --pin 1032AE100801035 --x 30 --for 1000 --source F9",
        "move --unlock --pin 1032AE100801035 --x 30 --for 1000 --hold"})
    EXPECT_EQ(run(bad).status, 2) << bad;
  EXPECT_FALSE(anyFrom(0xF9));
  EXPECT_FALSE(anyFrom(kOurJoystick));
}

TEST_F(Move, Rule20ItRefusesWhereItsSourceAddressIsHeardAndHasSaidNothingThen) {
  QTimer other;
  QObject::connect(&other, &QTimer::timeout, &other,
                   [this] { m_witnessLink->write(test::frame("18FECA38", "0000000000000000")); });
  other.start(300);
  const Outcome r = run(kMove, {}, words("--for 1000"));
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("does not move: another node sends from address 38")) << r.err.constData();
  EXPECT_FALSE(anyFrom(0xF9));
  EXPECT_EQ(motionFrames(), 0u);
}

TEST_F(Move, Rule20ItRefusesWhereTheMonitorsHeardAreNotExactlyThoseNamed) {
  const Outcome wrong = run("move --unlock --pin 1032AE100801036 --x 30 --for 1000");
  EXPECT_EQ(wrong.status, 1);
  EXPECT_TRUE(wrong.err.contains("not heard as a monitor: 1032AE100801036")) << wrong.err.constData();
  EXPECT_TRUE(wrong.err.contains("also move what is not named by --pin: 1032AE100801035"));
  QTimer other;
  const Pin pin = *Pin::parse("1042AE100801777");
  QObject::connect(&other, &QTimer::timeout, &other,
                   [&] { m_witnessLink->write(simulator::announcementFrame(pin, Address{0xA0})); });
  other.start(200);
  const Outcome r = run(kMove, {}, words("--for 1000"));
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("not named by --pin: 1042AE100801777 (6042 Global Platform) at address A0"))
      << r.err.constData();
  EXPECT_EQ(motionFrames(), 0u);
}

TEST_F(Move, Rule20EachSignalEndsItByNeutral) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    QProcess process;
    startMoving(process, "--for 10000");
    ::kill(static_cast<pid_t>(process.processId()), signal);
    const Outcome r = end(process);
    if (wasTooBusy(r)) continue;
    EXPECT_EQ(r.status, 1) << signal;
    EXPECT_EQ(text(r.objects().value(0), "end"), QStringLiteral("stopped")) << r.err.constData();
    EXPECT_TRUE(endsByNeutral());
  }
}

TEST_F(Move, Rule20HeldItEndsWithItsInput) {
  QProcess process;
  startMoving(process, "--for 10000 --hold");
  process.closeWriteChannel();
  const Outcome r = end(process);
  if (!wasTooBusy(r)) {
    EXPECT_EQ(r.status, 0) << r.err.constData();
    EXPECT_EQ(text(r.objects().value(0), "end"), QStringLiteral("input_ended"));
  }
  EXPECT_TRUE(endsByNeutral());
}

// Nothing says neutral then: the monitor's own 200 ms do.
TEST_F(Move, Rule10KilledTheMonitorStopsByItself) {
  QProcess process;
  startMoving(process, "--for 10000");
  process.kill();
  end(process);
  const auto statusesBehind = [this] {
    const auto last = std::find_if(m_witness.frames.rbegin(), m_witness.frames.rend(), isStick).base();
    std::vector<int> rotations;
    for (auto it = last; it != m_witness.frames.end(); ++it) {
      if (it->isExtended() && J1939Id::of(it->identifier()).pgn == pgn::kProprietaryA &&
          source(*it) == m_status.devices[0].address.value && it->data[0] == 0x01)
        rotations.push_back(PositionLimitStatus::of(*it).rotation.tenths);
    }
    return rotations;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return statusesBehind().size() >= 10; }, kPatience));
  const std::vector<int> rotations = statusesBehind();
  // 200 ms, and a quarter of a second at most to stand.
  for (std::size_t i = 6; i < rotations.size(); ++i) EXPECT_EQ(rotations[i], rotations[5]);
}

TEST_F(Move, Rule02OneDeckpipeAComputerMovesMonitors) {
  ArmingLock lock;
  ASSERT_TRUE(QTest::qWaitFor([&] { return lock.take(); }, kPatience));
  const Outcome r = run(kMove, {}, words("--for 1000"));
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("another Deckpipe on this computer")) << r.err.constData();
  EXPECT_EQ(motionFrames(), 0u);
}

TEST_F(Move, Rule06AMonitorThatIsDisabledIsNotMoved) {
  intent(0, SimulatedFault::EnableOff);
  const Outcome r = move("--for 1000");
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(text(r.objects().value(0), "end"), QStringLiteral("enable_off")) << r.err.constData();
  EXPECT_EQ(motionFrames(), 0u);
}

}  // namespace
}  // namespace deckpipe
