// SPDX-License-Identifier: GPL-3.0-or-later
// The tool on a live interface: the simulated truck on a virtual bus of this process, and a witness of what is said there.
#pragma once

#include <QTest>

#include "run_ctl.h"
#include "session/simulator_runner.h"
#include "support/recording_listener.h"

namespace deckpipe::test {

inline constexpr int kPatience = 60'000;  // ms; only ever used up by a failure
inline constexpr const char* kMonitor = "1032AE100801035";

inline QString text(const QJsonObject& object, const char* key) {
  return object[QLatin1String(key)].toString();
}

class Live : public testing::Test {
 protected:
  void SetUp() override {
    QObject::connect(&m_simulator, &SimulatorRunner::busReady, &m_simulator,
                     [this](const QString& name) { m_interface = name; });
    QObject::connect(&m_simulator, &SimulatorRunner::simulatorChanged, &m_simulator,
                     [this](const SimulatorStatus& status) { m_status = status; });
    m_simulator.startDemo();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          return m_status.devices.size() == 4 &&
                 std::ranges::all_of(m_status.devices,
                                     [](const SimulatedDevice& d) { return d.address != kNullAddress; });
        },
        kPatience));
    m_witnessLink =
        std::make_unique<CanLink>(LinkSettings{QStringLiteral("virtualcan"), m_interface, 250'000, {}});
    m_witnessLink->open(m_witness);
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_witness.state() == LinkState::Up; }, kPatience));
  }

  void start(QProcess& process, const char* command, const QStringList& more = {}) const {
    QStringList arguments = words(command);
    arguments += words("--plugin virtualcan --interface");
    arguments += m_interface;
    process.start(QStringLiteral(DECKPIPECTL), arguments + more);
  }
  static Outcome end(QProcess& process) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, kPatience));
    return test::outcomeOf(process);
  }
  Outcome run(const char* command, const QByteArray& input = {}, const QStringList& more = {}) const {
    QProcess process;
    start(process, command, more);
    process.write(input);
    process.closeWriteChannel();
    return end(process);
  }
  void intent(std::size_t device, SimulatedFault fault) {
    m_simulator.obey({device, SimulatorSwitch{fault, true}});
  }
  // A frame of the tool to this address, which has this type byte.
  bool wasSent(std::uint8_t to, std::uint8_t type) const {
    return std::ranges::any_of(m_witness.frames, [&](const Frame& frame) {
      return (frame.identifier() & 0xFF'FF'FF) == (0xEF'00F9u | to << 8) && frame.data[0] == type;
    });
  }
  // What the tool sent to the monitor at 80 over its data pipe.
  QByteArray piped() const {
    QByteArray sent;
    for (const Frame& frame : m_witness.frames) {
      if ((frame.identifier() & 0xFF'FF'FF) != 0xEF'80F9u || frame.data[0] != 0xFE) continue;
      for (std::size_t i = 1; i < frame.length; ++i) sent += static_cast<char>(frame.data[i]);
    }
    return sent;
  }
  bool anyFrom(std::uint8_t address) const {
    return std::ranges::any_of(m_witness.frames, [&](const Frame& frame) {
      return frame.isExtended() && (frame.identifier() & 0xFF) == address;
    });
  }

  SimulatorRunner m_simulator;
  SimulatorStatus m_status;
  QString m_interface;
  RecordingListener m_witness;
  std::unique_ptr<CanLink> m_witnessLink;
};

}  // namespace deckpipe::test
