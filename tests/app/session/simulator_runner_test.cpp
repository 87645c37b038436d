// SPDX-License-Identifier: GPL-3.0-or-later
// Wishes for the simulator while it runs on its virtual bus, and what it says of its devices.
#include "session/simulator_runner.h"

#include <gtest/gtest.h>

#include <QDeadlineTimer>
#include <QSemaphore>
#include <QTcpSocket>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <QUrl>
#include <memory>
#include <utility>

#include "session/simulator_faults.h"
#include "support/frames.h"
#include "support/patience.h"
#include "support/recording_listener.h"

namespace deckpipe {
namespace {

class RunningSimulator : public testing::Test {
 protected:
  void SetUp() override {
    QObject::connect(&m_simulator, &SimulatorRunner::simulatorChanged, &m_simulator,
                     [this](const SimulatorStatus& status) { m_status = status; });
    m_simulator.startDemo();
    ASSERT_TRUE(waitFor([&] { return m_status.devices.size() == 4 && has(0) && has(1); }));
  }
  template <typename F>
  static bool waitFor(F&& f) {
    return QTest::qWaitFor(std::forward<F>(f), kPatience);
  }
  bool has(std::size_t device) const { return m_status.devices[device].address != kNullAddress; }

  SimulatorStatus m_status;
  SimulatorRunner m_simulator;
};

TEST_F(RunningSimulator, SaysWhoItsDevicesAre) {
  EXPECT_EQ(m_status.devices[0].pin.text(), "1032AE100801035");
  const unsigned models[] = {6032, 6033, 6039, 6035};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(m_status.devices[i].model, models[i]);
  EXPECT_TRUE(m_status.devices[2].pin.isNull());
  EXPECT_TRUE(m_status.devices[0].possible.has(SimulatedFault::NotFitted));
  EXPECT_FALSE(m_status.devices[1].possible.has(SimulatedFault::NotFitted));
}

TEST_F(RunningSimulator, SwitchesTheirPower) {
  m_simulator.obey({1, SimulatorButton::PowerOff});
  EXPECT_FALSE(m_status.devices[1].isPowered);
  EXPECT_FALSE(has(1));
  m_simulator.obey({1, SimulatorButton::PowerOn});
  EXPECT_TRUE(m_status.devices[1].isPowered);
  EXPECT_TRUE(waitFor([&] { return has(1); }));
}

TEST_F(RunningSimulator, LetsThemGoWrongAndRightAgain) {
  m_simulator.obey({0, SimulatorSwitch{SimulatedFault::Silent, true}});
  m_simulator.obey({0, SimulatorSwitch{SimulatedFault::AcksLost, true}});
  m_simulator.obey({0, SimulatorSwitch{SimulatedFault::AcksLate, true}});
  m_simulator.obey({0, SimulatorSwitch{SimulatedFault::AcksLate, false}});
  EXPECT_EQ(m_status.devices[0].faults, (SimulatedFaults{SimulatedFault::Silent, SimulatedFault::AcksLost}));
  EXPECT_TRUE(m_simulator.simulator().simulator.device(0).misbehaviour().silent);
  EXPECT_TRUE(m_status.devices[1].faults.isNone());
  m_simulator.obey({0, SimulatorAllWell{}});
  EXPECT_TRUE(m_status.devices[0].faults.isNone());
  EXPECT_EQ(m_simulator.simulator().simulator.device(0).misbehaviour(), simulator::Misbehaviour{});
}

TEST_F(RunningSimulator, ResetsThemAndMovesThemElsewhere) {
  const Address before = m_status.devices[0].address;
  m_simulator.obey({0, SimulatorSwitch{SimulatedFault::ReturnsElsewhere, true}});
  m_simulator.obey({0, SimulatorButton::Reset});
  EXPECT_FALSE(has(0));
  ASSERT_TRUE(waitFor([&] { return has(0); }));
  EXPECT_NE(m_status.devices[0].address, before);
}

TEST_F(RunningSimulator, IgnoresADeviceItDoesNotHave) {
  const SimulatorStatus before = m_status;
  m_simulator.obey({4, SimulatorButton::PowerOff});
  EXPECT_EQ(m_status, before);
}

// A virtual bus that the simulator takes for one with real monitors.
class Rule20Simulator : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(m_bus.start());
    m_other = std::make_unique<CanLink>(link());
    m_other->open(m_heard);
    ASSERT_TRUE(waitFor([&] { return m_heard.state() == LinkState::Up; }));
    QObject::connect(&m_simulator, &SimulatorRunner::busReady, &m_simulator, [this] { m_isReady = true; });
    QObject::connect(&m_simulator, &SimulatorRunner::wordMissing, &m_simulator,
                     [this] { m_isWordMissing = true; });
    QObject::connect(&m_simulator, &SimulatorRunner::strangersHeard, &m_simulator,
                     [this](const std::vector<Stranger>& strangers) { m_strangers = strangers; });
  }
  template <typename F>
  static bool waitFor(F&& f) {
    return QTest::qWaitFor(std::forward<F>(f), kPatience);
  }
  LinkSettings link() const { return {QStringLiteral("virtualcan"), m_bus.interfaceName(0), 250'000, {}}; }

  VirtualBus m_bus;
  RecordingListener m_heard;
  std::unique_ptr<CanLink> m_other;
  SimulatorRunner m_simulator{1, 1, [](auto&&...) { return false; }};
  bool m_isReady = false, m_isWordMissing = false;
  std::vector<Stranger> m_strangers;
};

TEST_F(Rule20Simulator, WithoutTheWordSendsNothing) {
  m_simulator.start(link());
  ASSERT_TRUE(waitFor([&] { return m_isWordMissing; }));
  EXPECT_FALSE(m_isReady);
  EXPECT_TRUE(m_heard.frames.empty());
}

TEST_F(Rule20Simulator, WithTheWordSendsOnceItHasListened) {
  m_simulator.start(link(), true);
  ASSERT_TRUE(waitFor([&] { return m_isReady; }));
  EXPECT_TRUE(m_heard.frames.empty());
  EXPECT_TRUE(waitFor([&] { return !m_heard.frames.empty(); }));
}

TEST_F(Rule20Simulator, WithTheWordStaysOffABusWithAJoystick) {
  m_simulator.start(link(), true);
  ASSERT_TRUE(waitFor([&] { return m_bus.clients(0) == 2; }));
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, &hand,
                   [this] { m_other->write(test::frame("0CFDD638", "0100010000000000")); });
  hand.start(20);
  ASSERT_TRUE(waitFor([&] { return !m_strangers.empty(); }));
  EXPECT_EQ(m_strangers, (std::vector{Stranger{.kind = Stranger::Kind::Joystick, .address = Address{0x38}}}));
  EXPECT_FALSE(m_isReady);
  EXPECT_TRUE(std::ranges::all_of(m_heard.frames, [](const Frame& f) {
    return (f.flags & Frame::kSent) != 0;
  })) << "it sent something";
}

// The simulator on a thread that stands still as soon as it listens, until goOn().
class Rule20StandingSimulator : public Rule20Simulator {
 protected:
  void SetUp() override {
    Rule20Simulator::SetUp();
    m_runner = new SimulatorRunner(1, 1, [](auto&&...) { return false; });
    // It listens as soon as the bus knows it. The bus may say so again; the thread stands still once.
    QObject::connect(&m_bus, &VirtualBus::clientsChanged, &m_bus, [this] {
      if (m_bus.clients(0) == 2 && !std::exchange(m_hasStood, true))
        QMetaObject::invokeMethod(
            m_runner, [this] { standStill(); }, Qt::QueuedConnection);
    });
    QObject::connect(m_runner, &SimulatorRunner::busReady, m_other.get(), [this] { m_isReady = true; });
    QObject::connect(m_runner, &SimulatorRunner::strangersHeard, m_other.get(),
                     [this](const std::vector<Stranger>& strangers) { m_strangers = strangers; });
    QObject::connect(&m_thread, &QThread::finished, m_runner, &QObject::deleteLater);
    m_runner->moveToThread(&m_thread);
    m_thread.start();
    QObject::connect(&m_hand, &QTimer::timeout, &m_hand,
                     [this] { m_other->write(test::frame("0CFDD638", "0100010000000000")); });
  }
  void TearDown() override {
    QObject::disconnect(&m_bus, nullptr, &m_bus, nullptr);
    goOn();
    m_thread.quit();
    m_thread.wait();
  }

  void start() {
    QMetaObject::invokeMethod(
        m_runner, [this] { m_runner->start(link(), true); }, Qt::QueuedConnection);
  }
  void standStill() {
    m_stands.release();
    m_goesOn.tryAcquire(1, kPatience);
  }
  void goOn() { m_goesOn.release(); }
  bool stands() {
    return waitFor([this] { return m_stands.tryAcquire(); });
  }
  // Longer than it listens.
  static bool passes() {
    const QDeadlineTimer end(std::chrono::milliseconds(1'500));
    return waitFor([&] { return end.hasExpired(); });
  }

  QThread m_thread;
  bool m_hasStood = false;
  QSemaphore m_stands, m_goesOn;
  SimulatorRunner* m_runner = nullptr;  // the thread deletes it
  QTimer m_hand;                        // of a joystick
};

TEST_F(Rule20StandingSimulator, HearsWhatCameMeanwhile) {
  start();
  ASSERT_TRUE(stands());
  m_hand.start(20);
  ASSERT_TRUE(passes());
  m_hand.stop();
  goOn();
  ASSERT_TRUE(waitFor([&] { return m_isReady || !m_strangers.empty(); }));
  EXPECT_FALSE(m_isReady);
  EXPECT_EQ(m_strangers, (std::vector{Stranger{.kind = Stranger::Kind::Joystick, .address = Address{0x38}}}));
}

TEST_F(Rule20StandingSimulator, ListensAnew) {
  start();
  ASSERT_TRUE(stands());
  ASSERT_TRUE(passes());
  goOn();
  m_hand.start(20);
  ASSERT_TRUE(waitFor([&] { return m_isReady || !m_strangers.empty(); }));
  EXPECT_FALSE(m_isReady);
}

// A frame that the link has taken, but not handed over yet, changes what the simulator would say.
TEST(SimulatorRunner, SaysNothingWhileItIsDestroyed) {
  auto simulator = std::make_unique<SimulatorRunner>();
  QUrl where;
  int said = 0;
  QObject::connect(simulator.get(), &SimulatorRunner::busReady,
                   [&](const QString& name) { where = QUrl(name); });
  QObject::connect(simulator.get(), &SimulatorRunner::simulatorChanged, [&] { ++said; });
  simulator->startDemo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return where.isValid() && !where.isEmpty(); }, kPatience));
  // Another end of the bus, without a link's own queue: what it has read has just been read by the simulator too.
  QTcpSocket peer;
  peer.connectToHost(where.host(), static_cast<quint16>(where.port()));
  peer.write("connect:can0\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return peer.bytesAvailable() > 0; }, kPatience));
  for (const qint64 before = peer.bytesAvailable(); peer.bytesAvailable() == before;)
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  simulator::Simulator& devices = simulator->simulator().simulator;
  devices.press(devices.nextTime(), 1, simulator::Simulator::Button::PowerOff);
  said = 0;
  simulator.reset();
  EXPECT_EQ(said, 0);
}

TEST(SimulatorFaultsOfTheSimulator, EachChangesSomethingOfItsOwn) {
  std::vector<simulator::Misbehaviour> all{{}};
  for (const SimulatedFault fault : kAllOf<SimulatedFault>) {
    const simulator::Misbehaviour one = misbehaviourOf({fault});
    for (const simulator::Misbehaviour& other : all) EXPECT_FALSE(one == other) << static_cast<int>(fault);
    all.push_back(one);
  }
}

}  // namespace
}  // namespace deckpipe
