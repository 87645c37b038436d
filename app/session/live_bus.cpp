// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/live_bus.h"

#include <QThread>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "link/adapters.h"
#include "session/clocks.h"

namespace deckpipe {
namespace {

// The driver's; without one the rate that was asked for, which adapters take or refuse. 0: not known.
std::uint32_t bitRateOf(const LinkSettings& settings, const LinkStatus& status) {
  if (status.hardware) return status.hardware->bitRate;
  return pluginTakesBitRate(settings.plugin) ? static_cast<std::uint32_t>(settings.bitRate) : 0;
}

// "socketcan can0, 250 kbit/s"
std::string adapterWords(const LinkSettings& settings, std::uint32_t bitRate) {
  QString words = settings.plugin + QLatin1Char(' ') + settings.interfaceName;
  if (bitRate != 0) words += QStringLiteral(", %1 kbit/s").arg(bitRate / 1000.0);
  return words.toStdString();
}

}  // namespace

LiveBus::Board::Board() {
  m_published.state = std::make_shared<const State>();
  m_published.services = std::make_shared<const ServiceStatus>();
}

LiveBus::Published LiveBus::Board::latest() const {
  const std::lock_guard lock(m_lock);
  return m_published;
}

LiveBus::LiveBus(std::shared_ptr<LogDocument> document, LinkSettings settings, ClaimSettings claim,
                 const std::shared_ptr<const Board>& before)
    : m_document(std::move(document)),
      m_settings(std::move(settings)),
      m_services({m_settings.channel, m_settings.bitRate,
                  pluginEchoes(m_settings.plugin, m_settings.interfaceName), claim,
                  echoProvesBus(m_settings.plugin, m_settings.interfaceName)}),
      m_times(m_document->frames) {
  if (before == nullptr) return;
  const Published last = before->latest();
  m_state = *last.state;
  m_board->m_published.state = last.state;
}

LiveBus::~LiveBus() = default;

void LiveBus::start() {
  m_tick = new QTimer(this);
  m_tick->setTimerType(Qt::PreciseTimer);
  connect(m_tick, &QTimer::timeout, this, [this] {
    m_link->drain();
    publish();
    if (!m_isTold.exchange(true)) Q_EMIT ticked();
  });
  m_tick->start(kTick);
  m_serviceTimer = new QTimer(this);
  m_serviceTimer->setTimerType(Qt::PreciseTimer);
  m_serviceTimer->setSingleShot(true);
  connect(m_serviceTimer, &QTimer::timeout, this, &LiveBus::deadlineCame);
  m_link = std::make_unique<CanLink>(m_settings);
  m_link->open(*this);
}

void LiveBus::apply(const StampedIntent& intent) {
  if (m_storeFull && !onlyStops(intent.value)) return;
  if (m_link != nullptr) m_link->drain();
  followHardware();
  followClocks();
  if (std::holds_alternative<intent::ArmJoystick>(intent.value) && !m_armingLock.take()) {
    m_services.refuse(intent, Refusal::ArmedElsewhere);
  } else {
    m_services.apply(bootTime(), m_state, intent);
  }
  serve();
  // A hand's word comes fifty times a second, and shows with the next tick.
  if (!std::holds_alternative<intent::HoldJoystick>(intent.value)) publish();
}

void LiveBus::followHardware() {
  if (m_link == nullptr) return;
  const auto& hardware = m_link->status().hardware;
  if (hardware) {
    m_services.setEchoProves(hardware->echoesInDriver);
    m_services.setBitRate(static_cast<int>(hardware->bitRate));
    if (m_services.controllerRead(bootTime(), m_state, {hardware->controller, hardware->sendErrors})) serve();
  }
  const bool isListenOnly = hardware && hardware->isListenOnly;
  const bool wasLocked = m_services.isLocked();
  m_services.setListenOnly(bootTime(), m_state, isListenOnly);
  if (isListenOnly && !wasLocked) serve();
}

void LiveBus::followClocks() {
  constexpr Duration kJump = 100ms;
  const Duration asleep = bootTime() - monotonicTime();
  const Duration jump = asleep - std::exchange(m_asleep, asleep).value_or(asleep);
  if (m_services.isLocked() || std::chrono::abs(jump) <= kJump) return;
  m_services.apply(bootTime(), m_state, {intent::DisarmJoystick{MotionCause::ClockJumped}, bootTime(), 0});
}

void LiveBus::sayDrive(Address address, bool isDrive) {
  write(note::DriveSaid{m_settings.channel, address, isDrive});
  publish();
}

void LiveBus::serve() {
  // The outcome of one write may make a service send another frame.
  for (m_services.takeFrames(m_toSend); !m_toSend.empty(); m_services.takeFrames(m_toSend)) {
    for (const OutFrame& out : std::exchange(m_toSend, {})) {
      const WriteResult result = m_link != nullptr ? m_link->write(out.frame) : WriteResult::NotOpen;
      m_services.wrote(bootTime(), m_state, out, result);
    }
  }
  m_services.takeNotes(m_toNote);
  for (Note& note : m_toNote) write(std::move(note.value));
  m_toNote.clear();
  if (m_isClosing && m_services.isLocked()) {
    // Not from inside a call of the link, which ends with it.
    QMetaObject::invokeMethod(
        this,
        [this] {
          stop();
          thread()->quit();
        },
        Qt::QueuedConnection);
    return m_serviceTimer->stop();
  }
  const Instant next = m_services.nextTime();
  if (next == kNever) return m_serviceTimer->stop();
  const auto wait = std::chrono::ceil<std::chrono::milliseconds>(next - bootTime());
  m_serviceTimer->start(std::max(wait, std::chrono::milliseconds{0}));
}

// Frames first: those that arrived while the thread was held up may be answers in time.
void LiveBus::deadlineCame() {
  m_link->drain();
  followClocks();
  m_services.timeCame(bootTime(), m_state);
  serve();
}

void LiveBus::close() {
  if (std::exchange(m_isClosing, true)) return;
  m_services.close(bootTime(), m_state);
  serve();
}

void LiveBus::stop() {
  if (m_link == nullptr) return;
  m_tick->stop();
  m_serviceTimer->stop();
  m_link->close();
  noteLeftOut();
  publish();
  m_link.reset();
}

Arrival LiveBus::arrival() const {
  Arrival arrival{.now = bootTime(), .reached = m_state.cursor().time};
  if (pluginStampsWallClock(m_settings.plugin)) arrival.wallOffset = arrival.now - wallClockTime();
  return arrival;
}

void LiveBus::framesReceived(std::span<const Frame> frames) {
  if (!m_document->frames.append(frames, arrival())) {
    // What is not recorded is not known either: nothing is sent on a picture that stands still.
    m_storeFull = true;
    m_services.apply(bootTime(), m_state, {intent::Lock{}, bootTime(), 0});
    serve();
    return;
  }
  const std::uint64_t count = m_document->frames.count();
  for (std::uint64_t i = m_state.cursor().frames; i < count; ++i) {
    const Instant at = m_times.at(i);
    m_state.apply(m_document->frames[i], at);
    m_services.received(at, m_state, m_document->frames[i]);
  }
  serve();
}

void LiveBus::framesNotKept(NotKept reason, std::uint32_t count) {
  switch (reason) {
    case NotKept::Overflow:
      write(note::Dropped{m_settings.channel, count});
      m_services.echoesLost(bootTime(), m_state);
      serve();
      break;
    case NotKept::Overrun: write(note::Dropped{m_settings.channel, count}); break;
    case NotKept::FlexibleDataRate: leftOut(note::LeftOut::Why::CanFd, count); break;
    case NotKept::Invalid: leftOut(note::LeftOut::Why::NotClassic, count); break;
  }
}

void LiveBus::leftOut(note::LeftOut::Why why, std::uint32_t count) {
  const auto known = std::ranges::find(m_leftOut, why, &note::LeftOut::why);
  if (known != m_leftOut.end()) {
    known->count += count;
  } else {
    m_leftOut.push_back({m_settings.channel, why, count});
  }
  if (bootTime() >= m_nextLeftOut) noteLeftOut();
}

void LiveBus::noteLeftOut() {
  if (m_leftOut.empty()) return;
  for (const note::LeftOut& leftOut : std::exchange(m_leftOut, {})) write(leftOut);
  m_nextLeftOut = bootTime() + 1s;
}

void LiveBus::linkChanged(LinkState state, const std::string& reason) {
  const bool wasUp = m_linkState == LinkState::Up;
  m_linkState = state;
  if (state == LinkState::Up && !wasUp) {
    const std::uint32_t bitRate = bitRateOf(m_settings, m_link->status());
    write(note::LinkUp{m_settings.channel, adapterWords(m_settings, bitRate), bitRate});
  }
  if (state != LinkState::Up && wasUp) {
    const LinkFault fault = state == LinkState::Closed ? LinkFault::None : m_link->status().fault;
    write(note::LinkDown{m_settings.channel, fault, state == LinkState::Closed ? std::string() : reason});
  }
  followHardware();
  m_services.linkChanged(bootTime(), m_state, state == LinkState::Up);
  serve();
  publish();
}

void LiveBus::write(NoteValue value) {
  // Behind every cursor that was published: a note at a cursor's own time has happened there.
  const Instant time = std::max(m_state.cursor().time, bootTime() - kBehind) + 1ns;
  const Note note{.frame = m_document->frames.count(), .time = time, .value = std::move(value)};
  m_document->notes.append(note);
  m_state.apply(note);
}

void LiveBus::publish() {
  followHardware();
  if (bootTime() >= m_nextLeftOut) noteLeftOut();
  m_state.timeCame(bootTime() - kBehind);
  if (m_linkState == LinkState::Up && !m_storeFull)
    m_document->notes.append({.time = m_state.cursor().time, .value = note::RanUntil{}});
  auto state = std::make_shared<const State>(m_state);
  auto services = std::make_shared<const ServiceStatus>(m_services.status(bootTime(), m_state));
  if (services->joystick.progress == JoystickStatus::Progress::Off) m_armingLock.free();
  const std::lock_guard lock(m_board->m_lock);
  Published& published = m_board->m_published;
  published.state = std::move(state);
  if (m_link != nullptr) published.link = m_link->status();
  published.services = std::move(services);
  published.storeFull = m_storeFull;
}

}  // namespace deckpipe
