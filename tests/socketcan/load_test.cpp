// SPDX-License-Identifier: GPL-3.0-or-later
// As much as the guest can send: whatever does not arrive is counted. And frames of every kind are what they
// are.
#include <QRegularExpression>

#include "guest_simulator.h"
#include "link/can_link.h"
#include "support/recording_listener.h"

namespace deckpipe::guest {
namespace {

std::uint64_t sentOn(const char* name) {
  return counterOf(QString::fromLatin1(name), QStringLiteral("tx_packets"));
}

// All that cangen sent is here or was counted as lost; waits until that is so.
void expectAllAccountedFor(Console& console, const char* interfaceName, std::uint64_t sentBefore) {
  const auto heard = [&] { return console.document().frames.count(); };
  const auto lost = [&] { return console.document().notes.missedFrames(); };
  const std::uint64_t sent = sentOn(interfaceName) - sentBefore;
  EXPECT_TRUE(console.waitUntil([&] { return heard() + lost() >= sent; }));
  QTest::qWait(300);  // more than was sent would be as wrong
  EXPECT_EQ(heard() + lost(), sent);
  std::uint64_t noted = 0;
  for (const Note& note : console.notes<note::Dropped>()) noted += std::get<note::Dropped>(note.value).count;
  EXPECT_EQ(noted, lost());
  EXPECT_EQ(console.channel().dropped, lost());
  std::printf("%s: %llu sent, %llu received, %llu counted as lost\n", interfaceName,
              static_cast<unsigned long long>(sent), static_cast<unsigned long long>(heard()),
              static_cast<unsigned long long>(lost()));
}

TEST(Load, NothingIsLostUnseenOnAVirtualInterface) {
  Console console(QStringLiteral("vcan0"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  const std::uint64_t before = sentOn("vcan0");
  {
    const Program cangen(QStringLiteral("cangen vcan0 -g 0 -i -e"));
    QTest::qWait(60'000);
  }
  expectAllAccountedFor(console, "vcan0", before);
  EXPECT_GT(console.document().frames.count(), 10'000u);
}

// The reader stands still while more comes than the socket can hold.
TEST(Load, WhatASleepingReaderMissedIsCountedAndStampsAreTheKernels) {
  RecordingListener heard;
  CanLink link({QStringLiteral("socketcan"), QStringLiteral("vcan0"), 250'000, Channel{0}});
  link.open(heard);
  ASSERT_TRUE(QTest::qWaitFor([&] { return heard.state() == LinkState::Up; }, kPatience)) << heard.reason();
  constexpr std::uint64_t kSent = 20'000;
  const std::int64_t begin = CanLink::systemClock();
  ASSERT_EQ(shell(QStringLiteral("cangen vcan0 -g 0 -i -n %1").arg(kSent)), 0);
  const std::int64_t end = CanLink::systemClock();
  const auto lost = [&] { return link.status().notKept; };
  EXPECT_TRUE(QTest::qWaitFor([&] { return heard.frames.size() + lost() >= kSent; }, kPatience));
  EXPECT_EQ(heard.frames.size() + lost(), kSent);
  EXPECT_GT(lost(), 0u) << "send more, or it shows nothing";
  ASSERT_FALSE(heard.frames.empty());
  for (const Frame& frame : heard.frames) {
    ASSERT_GE(frame.stamp, begin);
    ASSERT_LE(frame.stamp, end) << "stamped when it was read, not when it came";
  }
  std::printf("vcan0, nobody reading: %llu sent, %zu received, %llu counted as lost\n",
              static_cast<unsigned long long>(kSent), heard.frames.size(),
              static_cast<unsigned long long>(lost()));
}

// Mixed: base and extended, remote, CAN FD; candump says what they were.
TEST(Load, FramesOfEveryKindAreKeptOrCountedAsWhatTheyAre) {
  Console console(QStringLiteral("vcan0"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  Witness witness(QStringLiteral("vcan0"), QStringLiteral("vcan0"));
  ASSERT_TRUE(witness.isRunning());
  ASSERT_EQ(shell(QStringLiteral("cangen vcan0 -g 1 -m -n 500; cangen vcan0 -g 1 -R -n 50; "
                                 "cangen vcan0 -g 1 -R -e -n 50")),
            0);
  const QStringList theirs = witness.lines();
  ASSERT_TRUE(console.waitUntil([&] { return console.hasHeard(0x7FF); }));
  QStringList ours = console.lines(QStringLiteral("deckpipe-vcan0.log"));
  QStringList classic;
  std::uint64_t flexible = 0;
  for (const QString& line : theirs) {
    if (line.contains(QStringLiteral("##"))) {
      ++flexible;
    } else {
      classic.append(line);
    }
  }
  ours = ours.mid(ours.indexOf(classic.first()));
  // can-utils 2020.11 writes a remote frame without the length it asks for.
  for (QStringList* lines : {&ours, &classic})
    lines->replaceInStrings(QRegularExpression(QStringLiteral("#R\\d$")), QStringLiteral("#R"));
  EXPECT_EQ(ours.join(QLatin1Char('\n')).toStdString(), classic.join(QLatin1Char('\n')).toStdString());
  EXPECT_GT(flexible, 50u);
  EXPECT_TRUE(console.waitUntil([&] { return console.document().notes.missedFrames() == flexible; }));
  EXPECT_TRUE(console.waitUntil([&] { return console.channel().remoteFrames >= 100; }));
  EXPECT_EQ(console.channel().dropped, 0u);
}

struct Forged {
  const char* name;
  const char* frame;  // for cansend; its bytes as linux/can/error.h has them
  ControllerState controller;
};

class ErrorFrame : public ::testing::TestWithParam<Forged> {};

TEST_P(ErrorFrame, IsLoggedAsOneAndSaysHowTheControllerIs) {
  Console console(QStringLiteral("vcan0"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  Witness witness(QStringLiteral("vcan0"), QStringLiteral("vcan0"));
  ASSERT_TRUE(witness.isRunning());
  ASSERT_EQ(shell(QStringLiteral("cansend vcan0 ") + QLatin1String(GetParam().frame)), 0);
  ASSERT_TRUE(console.waitUntil([&] { return console.channel().errorFrames == 1; }));
  EXPECT_EQ(console.channel().controller, GetParam().controller);
  EXPECT_EQ(console.session.snapshot().source.progress, SourceStatus::Progress::Running);
  const QStringList theirs = witness.lines();
  const QString frame = QLatin1Char(' ') + QString::fromLatin1(GetParam().frame);
  const auto line = [&](const QStringList& lines) {
    return lines.filter(frame).join(QString()).toStdString();
  };
  EXPECT_FALSE(line(theirs).empty());
  EXPECT_EQ(line(console.lines(QStringLiteral("deckpipe-error.log"))), line(theirs));
}

INSTANTIATE_TEST_SUITE_P(
    Load, ErrorFrame,
    ::testing::Values(Forged{"warning", "20000004#0008000000006000", ControllerState::ErrorWarning},
                      Forged{"passive", "20000004#0020000000008000", ControllerState::ErrorPassive},
                      Forged{"active_again", "20000004#0040000000000000", ControllerState::ErrorActive},
                      Forged{"bus_off", "20000040#0000000000000000", ControllerState::BusOff},
                      Forged{"restarted", "20000100#0000000000000000", ControllerState::ErrorActive},
                      Forged{"missing_acknowledge", "20000020#0000000000000000", ControllerState::Unknown},
                      Forged{"overrun", "20000004#0001000000000000", ControllerState::Unknown}),
    [](const auto& row) { return std::string(row.param.name); });

// Between two emulated controllers a frame takes no time, so a burst overruns the receiving one, which says
// that it lost some and not how many. What it did give to the driver is all here, and each of its overruns is
// in the log as an error frame and counted. It is the end of the controller's use in a boot: it keeps what a
// burst overran.
TEST(LoadOnTheWire, WhatTheControllerGaveIsHereAndItsOverrunsAreCounted) {
  Console console(QStringLiteral("can0"));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  const std::uint64_t before = sentOn("can1");
  {
    const Program cangen(QStringLiteral("cangen can1 -g 0 -p 10 -e"));
    QTest::qWait(15'000);
  }
  const auto given = [] { return counterOf(QStringLiteral("can0"), QStringLiteral("rx_packets")); };
  const auto overruns = [] { return counterOf(QStringLiteral("can0"), QStringLiteral("rx_over_errors")); };
  const auto heard = [&] { return console.channel().frames; };
  const auto lost = [&] { return console.document().notes.missedFrames(); };
  // Each overrun is counted, and is a frame that we either hear or count as lost on its way from the driver
  // to us.
  const auto expected = [&] { return given() + 2 * overruns(); };
  EXPECT_TRUE(console.waitUntil([&] { return heard() + lost() >= expected(); }));
  QTest::qWait(300);
  EXPECT_EQ(heard() + lost(), expected());
  EXPECT_GE(lost(), overruns());
  const std::uint64_t sent = sentOn("can1") - before;
  EXPECT_TRUE(given() == sent || overruns() > 0) << "lost unseen";
  std::printf(
      "can1 to can0: %llu sent, %llu given to the driver, %llu heard, %llu counted as lost, %llu overruns\n",
      static_cast<unsigned long long>(sent), static_cast<unsigned long long>(given()),
      static_cast<unsigned long long>(heard()), static_cast<unsigned long long>(lost()),
      static_cast<unsigned long long>(overruns()));
}

}  // namespace
}  // namespace deckpipe::guest
