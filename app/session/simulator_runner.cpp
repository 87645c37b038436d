// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/simulator_runner.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "session/clocks.h"
#include "session/simulator_faults.h"

namespace deckpipe {
namespace {

// A timer that is later than this belongs to a thread that heard nothing meanwhile.
constexpr Duration kHeldUp = 100ms;

}  // namespace

SimulatorRunner::SimulatorRunner(std::uint64_t seed, unsigned monitors, IsSimulated isSimulated)
    : m_simulator(simulator::standardSimulator(seed, {}, monitors)),
      m_isSimulated(std::move(isSimulated)),
      m_status(simulatorStatus(m_simulator)) {}
// The link goes first, without a word: it tells its listener nothing from its destructor.
SimulatorRunner::~SimulatorRunner() = default;

void SimulatorRunner::startDemo() {
  m_bus = std::make_unique<VirtualBus>();
  if (!m_bus->start()) {
    Q_EMIT failed({.fault = LinkFault::Other, .detail = m_bus->errorString().toStdString()});
    return;
  }
  LinkSettings settings;
  settings.plugin = QStringLiteral("virtualcan");
  settings.interfaceName = m_bus->interfaceName(0);
  start(settings);
}

void SimulatorRunner::start(const LinkSettings& settings, bool movesMonitors) {
  m_movesMonitors = movesMonitors;
  m_timer = new QTimer(this);
  m_timer->setTimerType(Qt::PreciseTimer);
  m_timer->setSingleShot(true);
  connect(m_timer, &QTimer::timeout, this, &SimulatorRunner::run);
  m_listening = new QTimer(this);
  m_listening->setTimerType(Qt::PreciseTimer);
  m_listening->setSingleShot(true);
  connect(m_listening, &QTimer::timeout, this, &SimulatorRunner::listened);
  m_link = std::make_unique<CanLink>(settings);
  m_link->open(*this);
}

// Simulator time starts at 0 with power-on.
Instant SimulatorRunner::now() const { return Instant{} + (monotonicTime() - m_powerOn); }

void SimulatorRunner::linkChanged(LinkState state, const std::string&) {
  if (state == LinkState::Up) {
    // Also said of a link that stays up, when the adapter reports a fault.
    if (m_sending == Sending::NoBus) busCame();
    return;
  }
  if (m_sending != Sending::Refused) m_sending = Sending::NoBus;
  m_watch.reset();
  m_listening->stop();
  if (state == LinkState::Closed && m_link != nullptr && m_link->status().fault != LinkFault::None) {
    Q_EMIT failed(m_link->status().error());
  } else if (state == LinkState::Lost) {
    Q_EMIT lost(m_link->status().error());
  }
}

// The interface may be another one each time it comes.
void SimulatorRunner::busCame() {
  if (m_isSimulated(m_link->settings(), m_link->status().hardware)) return begin();
  if (!m_movesMonitors) {
    m_sending = Sending::Refused;
    Q_EMIT wordMissing();
    return;
  }
  m_sending = Sending::Listening;
  m_watch.emplace(ownAddresses());
  listen();
}

void SimulatorRunner::listen() {
  m_listensUntil = monotonicTime() + StrangerWatch::kListen;
  m_listening->start(std::chrono::duration_cast<std::chrono::milliseconds>(StrangerWatch::kListen));
}

// Frames first: while the thread is held up, they wait before it like the timer.
void SimulatorRunner::listened() {
  m_link->drain();
  if (m_sending != Sending::Listening || m_listening->isActive()) return;  // the link went down, or is back
  const std::vector<Stranger> strangers = m_watch->strangers();
  // The kernel may have dropped frames while the thread was held up, so that nothing heard proves nothing.
  if (strangers.empty() && monotonicTime() > m_listensUntil + kHeldUp) return listen();
  m_watch.reset();
  if (strangers.empty()) return begin();
  m_sending = Sending::Refused;
  Q_EMIT strangersHeard(strangers);
}

void SimulatorRunner::begin() {
  m_sending = Sending::Allowed;
  if (!std::exchange(m_powered, true)) {
    m_powerOn = monotonicTime();
    m_simulator.simulator.powerOn(now());
    Q_EMIT busReady(m_link->settings().interfaceName);
  }
  run();
}

// What it sends from; before power, what that will be where nobody else is.
std::vector<Address> SimulatorRunner::ownAddresses() const {
  std::vector<Address> own{m_simulator.joystick->source()};
  if (m_simulator.simulator.isFilled()) own.push_back(simulator::Background::kSource);
  for (std::size_t i = 0; i < m_simulator.simulator.size(); ++i) {
    const Address held = m_simulator.simulator.device(i).address();
    own.push_back(held != kNullAddress ? held : Address{static_cast<std::uint8_t>(kFirstDynamic.value + i)});
  }
  return own;
}

void SimulatorRunner::framesReceived(std::span<const Frame> frames) {
  for (const Frame& frame : frames) {
    if (m_watch) m_watch->received(frame, monotonicTime());
    if (m_powered && (frame.flags & Frame::kSent) == 0) m_simulator.simulator.received(now(), frame);
  }
  run();
}

void SimulatorRunner::run() {
  if (m_link == nullptr || !m_powered) return;
  m_simulator.simulator.timeCame(now());
  send();
  publish();
  const Instant next = m_simulator.simulator.nextTime();
  if (next == kNever) return;
  const auto wait = std::chrono::ceil<std::chrono::milliseconds>(next - now());
  m_timer->start(std::max(wait, std::chrono::milliseconds{0}));
}

void SimulatorRunner::obey(const SimulatorIntent& intent) {
  if (m_link == nullptr || !m_powered || intent.device >= m_status.devices.size()) return;
  if (const auto* button = std::get_if<SimulatorButton>(&intent.what)) {
    m_simulator.simulator.press(now(), intent.device, *button);
  } else {
    SimulatedFaults& faults = m_status.devices[intent.device].faults;
    if (const auto* one = std::get_if<SimulatorSwitch>(&intent.what)) {
      faults.set(one->fault, one->on);
    } else {
      faults = {};
    }
    m_simulator.simulator.misbehave(now(), intent.device, misbehaviourOf(faults));
  }
  m_isNews = true;
  run();
}

// Only the demo's panel listens.
void SimulatorRunner::publish() {
  if (m_bus == nullptr) return;
  for (std::size_t i = 0; i < m_status.devices.size(); ++i) {
    const simulator::Device& device = m_simulator.simulator.device(i);
    SimulatedDevice& shown = m_status.devices[i];
    if (shown.address == device.address() && shown.isPowered == device.isPowered()) continue;
    shown.address = device.address();
    shown.isPowered = device.isPowered();
    m_isNews = true;
  }
  if (std::exchange(m_isNews, false)) Q_EMIT simulatorChanged(m_status);
}

void SimulatorRunner::send() {
  m_due.clear();
  m_simulator.simulator.takeFrames(m_due);
  // A frame that finds no room is lost, as on a controller whose mailbox is full: the next one is fresher.
  if (m_sending != Sending::Allowed) return;
  for (const simulator::DueFrame& due : m_due) m_link->write(due.frame);
}

}  // namespace deckpipe
