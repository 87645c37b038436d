// SPDX-License-Identifier: GPL-3.0-or-later
// The bench twin on a real port: runs core/simulator's bench in real time, on its thread's event loop and
// over a link. The demo starts one behind a virtual bus; `deckpipectl simulate` puts one on any interface.
// Time for the bench is CLOCK_MONOTONIC, which stands still while the machine sleeps: no burst on waking.
#pragma once

#include <QObject>
#include <memory>

#include "bus/port.h"
#include "control/twin_control.h"
#include "link/can_link.h"
#include "link/virtual_bus.h"
#include "simulator/standard_bench.h"

class QTimer;

namespace deckpipe {

class BenchRunner : public QObject, private PortListener {
  Q_OBJECT
 public:
  explicit BenchRunner(std::uint64_t seed = 1, unsigned monitors = 1);
  ~BenchRunner() override;

  // For setting up before it starts: what misbehaves, and when (relative to power-on, time 0).
  simulator::StandardBench& bench() { return m_bench; }

 public Q_SLOTS:
  // On a virtual bus of its own. busReady() tells where, once the twin is on it.
  void startDemo();
  // On an interface that is there.
  void start(const deckpipe::LinkSettings& settings);
  // At once. Nothing while it is not on a bus yet, or where it has no such device.
  void obey(const deckpipe::TwinWish& wish);

 Q_SIGNALS:
  void busReady(const QString& interfaceName);
  // It will not start, or its link went away for good.
  void failed(const QString& reason);
  // How its devices are, whenever that has changed: power, addresses, what was wished for.
  void twinChanged(const deckpipe::TwinStatus& status);

 private:
  void stop();
  void framesReceived(std::span<const Frame> frames) override;
  void framesNotKept(NotKept, std::uint32_t) override {}
  void linkChanged(LinkState state, const std::string& reason) override;
  Instant now() const;
  void run();
  void send();
  void publish();

  simulator::StandardBench m_bench;
  std::unique_ptr<VirtualBus> m_bus;
  std::unique_ptr<CanLink> m_link;
  QTimer* m_timer = nullptr;
  Instant m_powerOn;
  bool m_powered = false;
  std::vector<simulator::DueFrame> m_due;
  std::vector<TwinFaults> m_wished;  // of each device
  TwinStatus m_published;
};

}  // namespace deckpipe
