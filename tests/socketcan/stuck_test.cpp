// SPDX-License-Identifier: GPL-3.0-or-later
// Handed over is not on the bus: an adapter that keeps what it is given, one whose queue is full, one that
// only listens. We are on can0, the simulator on can1.
#include <QRegularExpression>
#include <algorithm>

#include "guest_simulator.h"

namespace deckpipe::guest {
namespace {

constexpr auto kMonitorPin = "1032AE100801035";

// An emulated card sends at once, so the kernel's queue before it is made slow: one frame has 16 bytes, and so many
// bits a second go out. It holds so many frames. The guest's kernel is one that can do that.
bool slowDown(int bitsASecond, int frames) {
  return shell(QStringLiteral("tc qdisc replace dev can0 root tbf rate %1bit burst 16 limit %2")
                   .arg(bitsASecond)
                   .arg(16 * frames)) == 0;
}
// The next frame goes out after 16 s.
bool freeze(int frames) { return slowDown(8, frames); }
bool isQueueEmpty() { return shell(QStringLiteral("tc -s qdisc show dev can0 | grep -q 'backlog 0b'")) == 0; }

struct Stuck : ::testing::Test {
  Stuck()
      : simulator(programOfBuild(QStringLiteral("deckpipectl")) +
                  QStringLiteral(" simulate --moves-monitors --plugin socketcan --interface can1")) {}
  ~Stuck() override { shell(QStringLiteral("tc qdisc del dev can0 root 2>/dev/null")); }

  bool begin() {
    if (!console.waitFor(SourceStatus::Progress::Running)) return false;
    console.session.intend(intent::Unlock{});
    return console.waitUntil([&] { return services().canRequest() && services().find(monitor) != nullptr; });
  }
  const ServiceStatus& services() const { return *console.session.snapshot().services; }
  RequestStatus command() const {
    const DeviceServices* device = services().find(monitor);
    return device != nullptr ? device->of(Request::SetupMode) : RequestStatus{};
  }
  void request() { console.session.intend(intent::SendRequests{monitor, RequestSet{Request::SetupMode}}); }
  const Program simulator;
  Console console{QStringLiteral("can0")};
  const DeviceKey monitor = DeviceKey::of(*Pin::parse(kMonitorPin));
};

TEST_F(Stuck, ACommandInAFrozenAdapterIsSaidToWaitBeyondALockUntilTheInterfaceGoesDown) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(freeze(20));
  console.session.intend(intent::RequestNames{});  // takes what the queue lets pass at once
  request();
  ASSERT_TRUE(console.waitUntil([&] { return !services().waitingCommands.empty(); }));
  EXPECT_EQ(command().progress, RequestStatus::Progress::NotOnBusYet);
  EXPECT_EQ(console.notes<note::RequestWaits>().size(), 1u);
  console.session.intend(intent::Lock{});
  ASSERT_TRUE(console.waitUntil([&] { return services().locked; }));
  EXPECT_EQ(console.notes<note::StillWaits>().size(), 1u);
  EXPECT_EQ(services().waitingCommands.size(), 1u) << "nothing takes it back";
  ASSERT_TRUE(setInterfaceUp("can0", false));
  EXPECT_TRUE(console.waitUntil([&] { return command().end == RequestEnd::GoneWithInterface; }));
  EXPECT_TRUE(services().waitingCommands.empty());
  ASSERT_TRUE(setInterfaceUp("can0", true));
}

// What a second card hears of us, in order, behind the frame by which candump shows that it listens.
class SecondCard {
 public:
  bool listens() const {
    return QTest::qWaitFor(
        [this] { return shell(QStringLiteral("cansend can1 7FE#")) == 0 && !heard().isEmpty(); }, kPatience);
  }
  QStringList heard() const { return linesOf(fileInResults(m_file)); }
  // Waits for a command to the monitor. True if exactly one came, and nothing of ours after it.
  bool hearsOneCommandLast() const {
    const QString command = QStringLiteral("EF80F9#");
    const bool came = QTest::qWaitFor([&] { return !heard().filter(command).isEmpty(); }, kPatience);
    QTest::qWait(1'000);  // for what must not follow
    return came && heard().filter(command).size() == 1 && heard().last().contains(command);
  }

 private:
  const QString m_file = QStringLiteral("candump-of-us.log");
  const Program m_candump{QStringLiteral("candump -L can1,000000F9:000000FF,7FE:7FF"), m_file};
};

TEST_F(Stuck, ACommandThatWaitsAtALockIsTheLastThatASecondCardHears) {
  SecondCard second;
  ASSERT_TRUE(second.listens() && begin());
  ASSERT_TRUE(freeze(20));
  console.session.intend(intent::RequestNames{});  // takes what the queue lets pass at once
  request();
  ASSERT_TRUE(console.waitUntil([&] { return !services().waitingCommands.empty(); }));
  console.session.intend(intent::Lock{});
  ASSERT_TRUE(console.waitUntil([&] { return services().locked; }));
  ASSERT_EQ(services().waitingCommands.size(), 1u) << "the queue was to hold it until after the lock";
  EXPECT_TRUE(console.waitUntil([&] { return command().end == RequestEnd::WentOutLate; }));
  EXPECT_TRUE(console.waitUntil(&isQueueEmpty));
  EXPECT_TRUE(second.hearsOneCommandLast()) << qPrintable(second.heard().join(QLatin1Char('\n')));
}

TEST_F(Stuck, ACommandThatWaitsInTheKernelOutlivesTheLinkAndNothingFollowsIt) {
  SecondCard second;
  ASSERT_TRUE(second.listens() && begin());
  ASSERT_TRUE(freeze(20));
  console.session.intend(intent::RequestNames{});
  request();
  ASSERT_TRUE(console.waitUntil([&] { return !services().waitingCommands.empty(); }));
  const auto log = console.session.snapshot().view.document;
  console.session.closeSource();
  console.session.waitForEnd();
  ASSERT_FALSE(isQueueEmpty()) << "the queue was to hold it until after the end";
  const std::vector<Note> notes = log->notes.all();
  EXPECT_TRUE(std::ranges::any_of(
      notes, [](const Note& note) { return std::holds_alternative<note::StillWaits>(note.value); }));
  EXPECT_TRUE(console.waitUntil(&isQueueEmpty));
  EXPECT_TRUE(second.hearsOneCommandLast()) << qPrintable(second.heard().join(QLatin1Char('\n')));
}

// A frame goes out every 1.8 s, and the program asks more often for a device that is not there.
TEST_F(Stuck, FramesThatWaitInTheKernelOutliveTheProgramWhichSaysHowMany) {
  SecondCard second;
  ASSERT_TRUE(second.listens() && console.waitFor(SourceStatus::Progress::Running));
  ASSERT_TRUE(slowDown(71, 20));
  const QString errors = fileInResults(QStringLiteral("command-errors.log"));
  {
    Program command(QStringLiteral("sh -c \"%1 command setup-mode --yes --unlock --interface can0 --pin "
                                   "1032AE100801036 2>%2; true\"")
                        .arg(programOfBuild(QStringLiteral("deckpipectl")), errors));
    ASSERT_TRUE(command.waitForEnd());
  }
  const qsizetype before = second.heard().size();
  ASSERT_FALSE(isQueueEmpty()) << "the queue was to hold them until after the program";
  const auto said =
      QRegularExpression(QStringLiteral("(\\d+) frames are not on the bus yet and may still go out"))
          .match(readFile(errors));
  ASSERT_TRUE(said.hasMatch()) << qPrintable(readFile(errors));
  EXPECT_TRUE(console.waitUntil(&isQueueEmpty));
  QTest::qWait(1'000);  // for what must not follow
  const qsizetype late = second.heard().size() - before, waited = said.captured(1).toInt();
  EXPECT_TRUE(late == waited || late == waited - 1)
      << late << " of " << waited << ": one may have left at the end";
}

TEST_F(Stuck, WhatAFullQueueRefusesWasNotSent) {
  ASSERT_TRUE(begin());
  ASSERT_TRUE(freeze(1));
  const std::uint64_t before = services().notTaken;
  for (int i = 0; i < 10; ++i) console.session.intend(intent::RequestNames{});
  EXPECT_TRUE(console.waitUntil([&] { return services().notTaken > before; }));
  request();
  EXPECT_TRUE(console.waitUntil([&] { return command().end == RequestEnd::NotOnBus; }));
  EXPECT_TRUE(services().waitingCommands.empty());
}

TEST_F(Stuck, AnAdapterThatOnlyListensIsNotUnlocked) {
  ASSERT_TRUE(ip(QStringLiteral("set can0 down")) &&
              ip(QStringLiteral("set can0 up type can bitrate 250000 listen-only on")));
  ASSERT_TRUE(console.waitFor(SourceStatus::Progress::Running));
  ASSERT_TRUE(console.waitUntil([&] { return services().isListenOnly; }));
  console.session.intend(intent::Unlock{});
  EXPECT_TRUE(console.waitUntil([&] { return services().refusal == Refusal::ListenOnly; }));
  EXPECT_TRUE(services().locked);
  EXPECT_EQ(console.session.snapshot().services->sent, 0u);
  ASSERT_TRUE(ip(QStringLiteral("set can0 down")) &&
              ip(QStringLiteral("set can0 up type can bitrate 250000 listen-only off")));
}

}  // namespace
}  // namespace deckpipe::guest
