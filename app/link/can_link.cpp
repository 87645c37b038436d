// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/can_link.h"

#include <QAbstractSocket>
#include <QCanBus>
#include <QCanBusDevice>
#include <QCoreApplication>
#include <QEvent>
#include <QSocketNotifier>
#include <QTimer>
#include <QVariant>
#include <algorithm>
#include <cerrno>
#include <mutex>

#include "link/convert.h"
#include "link/interface_watch.h"
#include "link/plugins.h"

namespace deckpipe {
namespace {

constexpr int kReceiveBufferBytes = 4 * 1'024 * 1'024;  // some 5,000 frames, more than 0.1 s of a full bus
constexpr qint64 kMostQueued =
    32;  // in plugins that queue inside; more would be sent long after it was meant

bool isAnyOf(const QString& text, std::initializer_list<int> errors) {
  return std::any_of(errors.begin(), errors.end(), [&](int e) { return text == qt_error_string(e); });
}

}  // namespace

CanLink::CanLink(LinkSettings settings, QObject* parent, WallClock clock,
                 std::unique_ptr<InterfaceSource> interfaces)
    : QObject(parent),
      m_settings(std::move(settings)),
      m_clock(std::move(clock)),
      m_interfaces(std::move(interfaces)),
      m_delivery(m_settings.channel, echoes(), m_status) {
  if (m_interfaces == nullptr && isSocketCan()) m_interfaces = std::make_unique<InterfaceWatch>();
  if (m_interfaces != nullptr) {
    connect(m_interfaces.get(), &InterfaceSource::changed, this, &CanLink::interfaceChanged);
    connect(m_interfaces.get(), &InterfaceSource::overrun, this, [this] { readHardware(true); });
  }
  m_hardwareTimer = new QTimer(this);
  m_hardwareTimer->setSingleShot(true);
  connect(m_hardwareTimer, &QTimer::timeout, this, [this] { readHardware(false); });
  m_connectTimer = new QTimer(this);
  m_connectTimer->setSingleShot(true);
  connect(m_connectTimer, &QTimer::timeout, this, [this] { gone(LinkFault::NoAnswer, tr("No answer.")); });
}

CanLink::~CanLink() {
  m_delivery.end();
  dropDevice(Leave::Politely);
  // What was written last, neutral perhaps, leaves before the sockets are destroyed.
  for (auto* socket : findChildren<QAbstractSocket*>()) socket->flush();
}

std::int64_t CanLink::systemClock() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

bool CanLink::isSocketCan() const { return m_settings.plugin == QLatin1String("socketcan"); }

bool CanLink::echoes() const { return pluginEchoes(m_settings.plugin, m_settings.interfaceName); }

void CanLink::open(PortListener& listener) {
  close();
  m_status = {};
  m_delivery.begin(listener);
  tell(LinkState::Connecting, LinkFault::None, {});
  for (const auto step : {&CanLink::checkHardware, &CanLink::createDevice, &CanLink::connectDevice}) {
    if (m_status.state != LinkState::Connecting) return;  // the listener thought better of it
    if (const auto obstacle = (this->*step)()) return gone(obstacle->fault, obstacle->reason);
  }
  if (m_status.state == LinkState::Connecting) m_connectTimer->start(kConnectTimeout);
}

void CanLink::close() {
  while (m_delivery.hasListener() && !deliverRest()) {
  }
  if (!m_delivery.hasListener()) return;
  ++m_session;
  dropDevice(Leave::Politely);
  stopFollowing();
  PortListener* listener = m_delivery.end();
  if (std::exchange(m_status.state, LinkState::Closed) != LinkState::Closed && listener != nullptr) {
    listener->linkChanged(LinkState::Closed, {});
  }
}

std::optional<CanLink::Obstacle> CanLink::checkHardware() {
  if (m_interfaces == nullptr) return {};
  const auto facts = m_interfaces->read(m_settings.interfaceName.toStdString());
  if (!facts) return Obstacle{LinkFault::NoInterface, QString::fromStdString(facts.error())};
  m_status.hardware = facts.value();
  return obstacleIn(facts.value());
}

std::optional<CanLink::Obstacle> CanLink::obstacleIn(const CanInterface& facts) const {
  if (!facts.isCan) return Obstacle{LinkFault::NoInterface, tr("This is no CAN interface.")};
  if (!facts.isUp) return Obstacle{LinkFault::InterfaceDown, tr("The interface is down.")};
  const auto asked = static_cast<std::uint32_t>(m_settings.bitRate);
  if (asked != 0 && facts.bitRate != 0 && facts.bitRate != asked) {
    return Obstacle{LinkFault::WrongBitRate,
                    tr("The interface runs at %1 bit/s, not at %2.").arg(facts.bitRate).arg(asked)};
  }
  return {};
}

std::optional<CanLink::Obstacle> CanLink::createDevice() {
  QString error;
  {
    const std::lock_guard lock(serialBusMutex());
    m_device = QCanBus::instance()->createDevice(m_settings.plugin, m_settings.interfaceName, &error);
  }
  if (m_device == nullptr) return Obstacle{LinkFault::NoPlugin, error};
  m_device->setParent(this);
  // virtualcan finds fault with its interface in the constructor, and would go on with some other channel.
  if (m_device->error() != QCanBusDevice::NoError) {
    return Obstacle{LinkFault::NoInterface, m_device->errorString()};
  }
  if (pluginTakesBitRate(m_settings.plugin)) {
    // The plugins' own 500,000 must not stand. Without a value socketcan leaves the interface alone, whose
    // rate was just looked at; with one it would try to set it, through libsocketcan, and fail because it is
    // up.
    const QVariant asked =
        m_settings.bitRate != 0 && !isSocketCan() ? QVariant(m_settings.bitRate) : QVariant();
    m_device->setConfigurationParameter(QCanBusDevice::BitRateKey, asked);
    const bool taken = m_device->configurationParameter(QCanBusDevice::BitRateKey) == asked;
    if (!taken || (m_settings.bitRate == 0 && !isSocketCan())) {
      const QString why = m_device->errorString();
      return Obstacle{LinkFault::BitRateRefused, why.isEmpty() ? tr("It needs a bit rate.") : why};
    }
  }
  if (isSocketCan()) {
    m_device->setConfigurationParameter(QCanBusDevice::LoopbackKey, true);
    m_device->setConfigurationParameter(QCanBusDevice::ReceiveOwnKey, true);
    m_device->setConfigurationParameter(QCanBusDevice::CanFdKey, true);  // only so that they are counted
  }
  connect(m_device, &QCanBusDevice::framesReceived, this, &CanLink::takeFrames);
  connect(m_device, &QCanBusDevice::errorOccurred, this, &CanLink::deviceError);
  connect(m_device, &QCanBusDevice::stateChanged, this, &CanLink::deviceStateChanged);
  return {};
}

std::optional<CanLink::Obstacle> CanLink::connectDevice() {
  bool opened = false;
  {
    // What the device reports while it opens is looked at below; no callback may come with the lock held.
    const std::lock_guard lock(serialBusMutex());
    const QSignalBlocker quiet(m_device);
    opened = m_device->connectDevice();
  }
  if (!opened) return Obstacle{LinkFault::Other, m_device->errorString()};
  if (auto* socket = m_device->findChild<QAbstractSocket*>(QString(), Qt::FindDirectChildrenOnly)) {
    // The plugin does not listen to its socket's errors.
    connect(socket, &QAbstractSocket::errorOccurred, this, &CanLink::socketFailed);
    if (socket->error() != QAbstractSocket::UnknownSocketError) {
      return Obstacle{LinkFault::NoAnswer, socket->errorString()};
    }
  }
  if (m_device->state() == QCanBusDevice::ConnectedState) cameUp();
  return {};
}

void CanLink::cameUp() {
  m_connectTimer->stop();
  if (auto* socket = m_device->findChild<QAbstractSocket*>(QString(), Qt::FindDirectChildrenOnly)) {
    // Otherwise a small frame may wait for the acknowledgement of the one before, up to 40 ms.
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
  }
  if (isSocketCan()) {
    m_notifier = m_device->findChild<QSocketNotifier*>(QString(), Qt::FindDirectChildrenOnly);
    m_descriptor = m_notifier != nullptr ? static_cast<int>(m_notifier->socket()) : -1;
    if (m_descriptor >= 0) {
      startStamping(m_descriptor);
      growReceiveBuffer(m_descriptor, kReceiveBufferBytes);
    }
    m_drops = 0;
  }
  if (m_interfaces != nullptr) {
    const int index = m_status.hardware->index;
    m_interfaces->start();
    m_hardwareTimer->start(kHardwarePeriod);
    // Again, as the source tells only what happens from now on.
    if (const auto obstacle = checkHardware()) return gone(obstacle->fault, obstacle->reason);
    if (m_status.hardware->index != index) return wasRemoved();  // the socket is bound to the one before
    m_overruns = m_status.hardware->overruns;
  }
  tell(LinkState::Up, LinkFault::None, {});
}

void CanLink::deviceStateChanged() {
  if (m_device == nullptr) return;
  const auto state = m_device->state();
  if (state == QCanBusDevice::ConnectedState && m_status.state != LinkState::Up) cameUp();
  if (state == QCanBusDevice::UnconnectedState) gone(LinkFault::Gone, m_device->errorString());
}

void CanLink::socketFailed() {
  const auto* socket = qobject_cast<QAbstractSocket*>(sender());
  const bool isUp = m_status.state == LinkState::Up;
  gone(isUp ? LinkFault::Gone : LinkFault::NoAnswer, socket != nullptr ? socket->errorString() : QString());
}

void CanLink::deviceError() {
  if (m_writing) {
    m_writeError = m_device->errorString();
    return;
  }
  ++m_status.errors;
  m_status.reason = m_device->errorString().toStdString();
  if (m_status.state == LinkState::Up) m_delivery.tell(m_status.state, m_status.reason);
}

void CanLink::interfaceChanged(const CanInterface& facts) {
  // An open socket is bound to the index, whatever happens to the name; without one the name is all there is.
  const bool isOurs = m_device != nullptr ? m_status.hardware && facts.index == m_status.hardware->index
                                          : facts.name == m_settings.interfaceName.toStdString();
  if (!isOurs) return;
  if (!facts.isRemoved) return follow(facts);
  if (m_device != nullptr) wasRemoved();
}

void CanLink::readHardware(bool hasMissedEvents) {
  m_hardwareTimer->start(kHardwarePeriod);
  const auto facts = m_interfaces->read(m_settings.interfaceName.toStdString());
  if (m_device != nullptr) {
    const bool isOther = facts && facts.value().index != m_status.hardware->index;
    if (isOther || (!facts && hasMissedEvents)) wasRemoved();
  }
  if (facts) follow(facts.value());
}

// The socket stays bound while its interface is down, so that nothing is missed when it comes up again; when
// the interface was removed or runs at another rate the device is dropped, and a new one made when all is
// well.
void CanLink::follow(const CanInterface& facts) {
  if (m_status.state != LinkState::Up && m_status.state != LinkState::Lost) return;
  const bool wasBusOff = m_status.hardware && m_status.hardware->controller == ControllerState::BusOff;
  countOverruns(facts);
  m_status.hardware = facts;
  if (const auto obstacle = obstacleIn(facts)) {
    if (obstacle->fault == m_status.fault) return;
    if (obstacle->fault == LinkFault::InterfaceDown) return wentDown(*obstacle);
    return gone(obstacle->fault, obstacle->reason);
  }
  if (m_status.state == LinkState::Lost) {
    if (m_device == nullptr) return reconnect();
    if (m_device->state() == QCanBusDevice::ConnectedState) tell(LinkState::Up, LinkFault::None, {});
  } else if (facts.controller == ControllerState::BusOff && !wasBusOff) {
    ++m_status.errors;
    m_status.reason = tr("The controller is bus-off.").toStdString();
    m_delivery.tell(LinkState::Up, m_status.reason);
  }
}

// Hands over what came before the end; false where the listener closed or opened anew on it.
bool CanLink::deliverRest() {
  const int session = m_session;
  takeRest();
  deliver();
  return m_session == session;
}

void CanLink::wentDown(const Obstacle& obstacle) {
  if (!deliverRest()) return;
  m_delivery.forgetOwn();
  tell(LinkState::Lost, obstacle.fault, obstacle.reason);
}

void CanLink::reconnect() {
  m_connectTimer->start(kConnectTimeout);
  for (const auto step : {&CanLink::createDevice, &CanLink::connectDevice}) {
    if (const auto obstacle = (this->*step)()) return gone(obstacle->fault, obstacle->reason);
  }
}

// Back to Closed if it was never up; otherwise Lost, and still following the interface if it is one.
void CanLink::gone(LinkFault fault, const QString& reason) {
  const bool wasUp = m_status.state == LinkState::Up || m_status.state == LinkState::Lost;
  if (!deliverRest()) return;
  dropDevice(Leave::AtOnce);  // nobody is there to take leave of
  if (!wasUp) stopFollowing();
  tell(wasUp ? LinkState::Lost : LinkState::Closed, fault, reason);
}

void CanLink::wasRemoved() {
  m_status.hardware.reset();
  gone(LinkFault::Gone, tr("The interface was removed."));
}

void CanLink::stopFollowing() {
  m_hardwareTimer->stop();
  if (m_interfaces != nullptr) m_interfaces->stop();
}

void CanLink::tell(LinkState state, LinkFault fault, const QString& reason) {
  m_status.state = state;
  m_status.fault = fault;
  m_status.reason = reason.toStdString();
  m_delivery.tell(state, m_status.reason);
}

void CanLink::dropDevice(Leave leave) {
  m_connectTimer->stop();
  m_notifier = nullptr;
  m_descriptor = -1;
  m_delivery.clear();
  if (m_device == nullptr) return;
  QCanBusDevice* device = std::exchange(m_device, nullptr);
  device->disconnect(this);
  if (leave == Leave::Politely && device->state() == QCanBusDevice::ConnectedState) {
    // virtualcan takes leave of its server first; the device is done with when that is answered.
    connect(device, &QCanBusDevice::stateChanged, device, [device](QCanBusDevice::CanBusDeviceState state) {
      if (state == QCanBusDevice::UnconnectedState) device->deleteLater();
    });
    device->disconnectDevice();
  } else {
    device->deleteLater();
  }
}

WriteResult CanLink::write(const Frame& frame) {
  if (m_status.state != LinkState::Up || m_device == nullptr) return WriteResult::NotOpen;
  const auto refuse = [this](WriteResult result, const QString& why) {
    ++m_status.refused;
    m_status.reason = why.toStdString();
    return result;
  };
  if (frame.isError() || frame.length > 8) return refuse(WriteResult::Failed, tr("No frame to send."));
  if (m_device->framesToWrite() >= kMostQueued) return refuse(WriteResult::QueueFull, tr("Queue full."));

  m_writeError.clear();
  m_writing = true;
  const bool written = m_device->writeFrame(toCanBusFrame(frame));
  m_writing = false;
  if (!written) {
    if (isAnyOf(m_writeError, {ENOBUFS, EAGAIN})) return refuse(WriteResult::QueueFull, m_writeError);
    return refuse(WriteResult::Failed, m_writeError);
  }
  if (!echoes()) takeFrames();  // these came before
  m_delivery.wrote(frame, m_clock());
  if (!m_delivery.isEmpty()) postDelivery();
  return WriteResult::Accepted;
}

void CanLink::postDelivery() {
  if (m_deliveryPosted) return;
  m_deliveryPosted = true;
  QMetaObject::invokeMethod(this, &CanLink::deliver, Qt::QueuedConnection);
}

// At once, since a device that is not connected any more gives nothing out; they are handed over together.
void CanLink::takeFrames() {
  if (m_device == nullptr || m_device->state() != QCanBusDevice::ConnectedState) return;
  const QList<QCanBusFrame> frames = m_device->readAllFrames();
  for (const QCanBusFrame& frame : frames) {
    m_delivery.take(frame);
    const bool isSoon = m_hardwareTimer->remainingTimeAsDuration() <= kAfterError;
    const bool isError = frame.frameType() == QCanBusFrame::ErrorFrame;
    if (isError && m_hardwareTimer->isActive() && !isSoon) m_hardwareTimer->start(kAfterError);
  }
  if (!m_delivery.isEmpty()) postDelivery();
}

// What the kernel still holds for us, before the socket goes: the plugin reads it when its notifier tells it
// to, and once more if the first time gave only the socket's error.
void CanLink::takeRest() {
  for (int i = 0; i < 2 && m_notifier != nullptr && receiveBuffer() && receiveBuffer()->used > 0; ++i) {
    QEvent ready(QEvent::SockAct);
    QCoreApplication::sendEvent(m_notifier, &ready);
  }
}

void CanLink::deliver() {
  m_deliveryPosted = false;
  takeFrames();
  m_delivery.lost(newDrops());
  m_delivery.handOver();
}

std::optional<ReceiveBuffer> CanLink::receiveBuffer() const {
  return m_descriptor >= 0 ? readReceiveBuffer(m_descriptor) : std::nullopt;
}

std::uint32_t CanLink::newDrops() {
  const auto buffer = receiveBuffer();
  return buffer ? buffer->drops - std::exchange(m_drops, buffer->drops) : 0;
}

// On the same interface the counter only grows.
void CanLink::countOverruns(const CanInterface& facts) {
  if (m_device == nullptr || !m_status.hardware || facts.index != m_status.hardware->index) return;
  const std::uint64_t before = std::exchange(m_overruns, std::max(m_overruns, facts.overruns));
  if (m_overruns == before) return;
  m_delivery.lost(static_cast<std::uint32_t>(m_overruns - before));
  postDelivery();
}

}  // namespace deckpipe
