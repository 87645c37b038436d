// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator on can1, the console's session on can0, candump beside it: what we recorded is what was on
// the bus.
#include "guest_simulator.h"
#include "link/can_link.h"
#include "support/raw_frames.h"
#include "support/recording_listener.h"

namespace deckpipe::guest {
namespace {

const Pin kMonitor = *Pin::parse("1032AE100801035");
const Pin kRiser = *Pin::parse("1033AE100802117");
const Pin kJoystick = *Pin::parse("1035AE100804442");

struct Simulator : ::testing::Test {
  QString simulatorOn(const QString& interfaceName) const {
    return programOfBuild(QStringLiteral("deckpipectl")) +
           QStringLiteral(" simulate --moves-monitors --plugin socketcan --interface ") + interfaceName;
  }
  static std::uint64_t driverLost(const QString& name) {
    return counterOf(name, QStringLiteral("rx_over_errors")) + counterOf(name, QStringLiteral("rx_dropped"));
  }
  // Frame for frame and stamp for stamp, from the first that candump heard on.
  static void compare(Console& console, Witness& witness, const QString& saveAs) {
    const QStringList theirs = witness.lines();
    ASSERT_FALSE(theirs.isEmpty());
    ASSERT_TRUE(console.waitUntil([&] { return console.hasHeard(0x7FF); }));
    QStringList ours = console.lines(saveAs);
    const qsizetype from = ours.indexOf(theirs.first());
    ASSERT_GE(from, 0) << "not in our log: " << qPrintable(theirs.first());
    ours = ours.mid(from);
    for (qsizetype i = 0; i < std::min(ours.size(), theirs.size()); ++i) {
      ASSERT_EQ(ours[i].toStdString(), theirs[i].toStdString()) << "frame " << i;
    }
    EXPECT_EQ(ours.size(), theirs.size());
    std::printf("the same %lld frames in candump's log and ours\n", static_cast<long long>(theirs.size()));
  }
};

TEST_F(Simulator, DevicesAppearPositionsMoveAndOurLogIsCandumps) {
  Console console(QStringLiteral("can0"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  Witness witness(QStringLiteral("can0"), QStringLiteral("can1"));
  ASSERT_TRUE(witness.isRunning());
  {
    const Program simulator(simulatorOn(QStringLiteral("can1")));
    const auto device = [&](const Pin& pin) {
      return console.session.snapshot().view.state->devices().byPin(pin);
    };
    ASSERT_TRUE(console.waitUntil([&] { return device(kMonitor) && device(kRiser) && device(kJoystick); }));
    ASSERT_TRUE(console.waitUntil([&] { return device(kMonitor)->position().isKnown(); }));
    const auto rotation = [&] { return device(kMonitor)->position().value().rotation.tenths; };
    const auto begin = rotation();
    EXPECT_TRUE(console.waitUntil([&] { return rotation() != begin; })) << "its position never moves";
    QTest::qWait(3'000);
  }
  compare(console, witness, QStringLiteral("deckpipe-can0.log"));
  const FrameStore& frames = console.document().frames;
  EXPECT_GT(frames.count(), 100u);
  for (std::uint64_t i = 0; i < frames.count(); ++i) {
    ASSERT_EQ(frames[i].flags & (Frame::kSent | Frame::kConfirmed), 0) << "nothing here was sent by us";
    ASSERT_TRUE(frames[i].hasStamp());
  }
  // An emulated controller on a slow machine does lose some: exactly those that the driver counted.
  shell(QStringLiteral("ip -s -s link show can0"));
  EXPECT_TRUE(console.waitUntil([&] {
    return console.document().notes.missedFrames() == driverLost(QStringLiteral("can0"));
  })) << console.document().notes.missedFrames()
      << " counted, " << driverLost(QStringLiteral("can0")) << " lost by the driver";
}

// The emulated cards are a real bus to it, the vcan is none, and their names do not matter.
TEST_F(Simulator, Rule20OnlyAVcanNeedsNoWordForMovingMonitors) {
  const auto statusOf = [](const QString& arguments) {
    return shell(QStringLiteral("timeout -s HUP 20 %1 simulate --plugin socketcan --interface %2")
                     .arg(programOfBuild(QStringLiteral("deckpipectl")), arguments));
  };
  RecordingListener heard;
  CanLink link({QStringLiteral("socketcan"), QStringLiteral("can0"), 250'000, Channel{0}});
  link.open(heard);
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.state() == LinkState::Up; }, kPatience)) << heard.reason();
  EXPECT_EQ(statusOf(QStringLiteral("can1")), 2);
  QTest::qWait(0);
  EXPECT_TRUE(heard.frames.empty());
  constexpr int kTimedOut = 124;  // it ran until timeout's signal
  EXPECT_EQ(statusOf(QStringLiteral("vcan0 --bitrate 0")), kTimedOut);
  ASSERT_TRUE(ip(QStringLiteral("set can1 down")) && ip(QStringLiteral("set can1 name vcan9 up")));
  EXPECT_EQ(statusOf(QStringLiteral("vcan9")), 2) << "an adapter under the name of a vcan";
  ASSERT_TRUE(ip(QStringLiteral("set vcan9 down")) && ip(QStringLiteral("set vcan9 name can1 up")));
}

TEST_F(Simulator, Rule20StaysOffABusOnWhichAnotherSimulatorIsHeard) {
  Console console(QStringLiteral("can0"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  const Program first(simulatorOn(QStringLiteral("can1")));
  ASSERT_TRUE(console.waitUntil(
      [&] { return console.session.snapshot().view.state->devices().byPin(kMonitor) != nullptr; }));
  EXPECT_EQ(shell(simulatorOn(QStringLiteral("can1"))), 1);
}

// On the sender's own interface: the frames of another program are not ours, though they never were on a wire
// to us.
TEST_F(Simulator, OnItsOwnInterfaceTheSimulatorIsHeardAndNotTakenForUs) {
  Console console(QStringLiteral("can1"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  Witness witness(QStringLiteral("can1"), QStringLiteral("can0"));
  ASSERT_TRUE(witness.isRunning());
  {
    const Program simulator(simulatorOn(QStringLiteral("can1")));
    ASSERT_TRUE(console.waitUntil(
        [&] { return console.session.snapshot().view.state->devices().byPin(kMonitor) != nullptr; }));
    QTest::qWait(1'000);
  }
  compare(console, witness, QStringLiteral("deckpipe-can1.log"));
  const FrameStore& frames = console.document().frames;
  for (std::uint64_t i = 0; i < frames.count(); ++i) ASSERT_EQ(frames[i].flags & Frame::kSent, 0);
}

// What we send stands in our log once, where and when candump on the same interface has it, and marked as
// ours.
TEST_F(Simulator, OurOwnFramesAreLoggedOnceWhereCandumpHasThem) {
  Witness witness(QStringLiteral("can0"), QStringLiteral("can1"));
  ASSERT_TRUE(witness.isRunning());
  RecordingListener heard;
  CanLink link({QStringLiteral("socketcan"), QStringLiteral("can0"), 250'000, Channel{0}});
  link.open(heard);
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.state() == LinkState::Up; }, kPatience)) << heard.reason();
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(link.write(test::extendedFrame(0x18FF0000u + static_cast<std::uint32_t>(i), {i, 1, 2})),
              WriteResult::Accepted);
    if (i % 5 == 0) shell(QStringLiteral("cansend can1 123#%1").arg(i + 10));
    const std::uint64_t written = link.status().written;
    ASSERT_TRUE(QTest::qWaitFor([&] { return link.status().confirmed == written; }, kPatience));
  }
  const QStringList theirs = witness.lines();
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.frames.back().id == 0x7FF; }, kPatience));
  std::string text;
  for (Frame frame : heard.frames) {
    EXPECT_EQ((frame.flags & Frame::kSent) != 0, frame.isExtended());
    EXPECT_EQ((frame.flags & Frame::kConfirmed) != 0, frame.isExtended());
    frame.flags = 0;
    writeCandump(frame, "can0", text);
  }
  const QStringList ours = QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  EXPECT_GE(ours.size(), 61);
  EXPECT_EQ(ours.join(QLatin1Char('\n')).toStdString(),
            theirs.mid(theirs.size() - ours.size()).join(QLatin1Char('\n')).toStdString());
}

}  // namespace
}  // namespace deckpipe::guest
