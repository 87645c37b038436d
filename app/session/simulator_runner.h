// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator on a real port: runs core/simulator's simulator in real time, on its thread's event loop and
// over a link. The demo starts one behind a virtual bus; `deckpipectl simulate` puts one on any interface, on
// a real one only with a word for it and where no stranger is heard (stranger_watch.h). Time for the simulator is
// CLOCK_MONOTONIC, which stands still while the machine sleeps: no burst on waking.
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>

#include "bus/port.h"
#include "control/simulator_control.h"
#include "link/can_link.h"
#include "link/virtual_bus.h"
#include "session/stranger_watch.h"
#include "simulator/standard_simulator.h"

class QTimer;

namespace deckpipe {

class SimulatorRunner : public QObject, private PortListener {
  Q_OBJECT
 public:
  // isSimulatedBus(), or a test's own answer.
  using IsSimulated = std::function<bool(const LinkSettings&, const std::optional<CanInterface>&)>;

  explicit SimulatorRunner(std::uint64_t seed = 1, unsigned monitors = 1,
                           IsSimulated isSimulated = isSimulatedBus);
  ~SimulatorRunner() override;

  // For setting up before it starts: what misbehaves, and when (relative to power-on, time 0).
  simulator::StandardSimulator& simulator() { return m_simulator; }

 public Q_SLOTS:
  // On a virtual bus of its own. busReady() tells where, once the simulator is on it.
  void startDemo();
  // On an interface that is there. `movesMonitors`: a person said that it may be one with real monitors.
  void start(const deckpipe::LinkSettings& settings, bool movesMonitors = false);
  // At once. Nothing while it is not on a bus yet, or where it has no such device.
  void obey(const deckpipe::SimulatorIntent& intent);

 Q_SIGNALS:
  void busReady(const QString& interfaceName);
  // It will not start, or its link went away for good.
  void failed(const deckpipe::LinkError& why);
  // Its bus went down after it was there. Only an interface of Linux comes back by itself.
  void lost(const deckpipe::LinkError& why);
  // It sends nothing from now on: real monitors may be there and nobody said that it may move them …
  void wordMissing();
  // … or these were heard.
  void strangersHeard(const std::vector<deckpipe::Stranger>& strangers);
  // How its devices are, whenever that has changed: power, addresses, what was intended.
  void simulatorChanged(const deckpipe::SimulatorStatus& status);

 private:
  void framesReceived(std::span<const Frame> frames) override;
  void framesNotKept(NotKept, std::uint32_t) override {}
  void linkChanged(LinkState state, const std::string& reason) override;
  Instant now() const;
  void busCame();
  void listen();
  void listened();
  void begin();
  std::vector<Address> ownAddresses() const;
  void run();
  void send();
  void publish();

  simulator::StandardSimulator m_simulator;
  std::unique_ptr<VirtualBus> m_bus;
  std::unique_ptr<CanLink> m_link;
  QTimer* m_timer = nullptr;
  QTimer* m_listening = nullptr;
  IsSimulated m_isSimulated;
  std::optional<StrangerWatch> m_watch;  // while it listens
  Instant m_listensUntil;
  Instant m_powerOn;
  bool m_movesMonitors = false;
  bool m_powered = false;
  // Whether what the simulator sends goes out. The simulator itself goes on without.
  enum class Sending : std::uint8_t { NoBus, Listening, Allowed, Refused } m_sending = Sending::NoBus;
  std::vector<simulator::DueFrame> m_due;
  SimulatorStatus m_status;
  bool m_isNews = true;  // something of it is not published
};

}  // namespace deckpipe
