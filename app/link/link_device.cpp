// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/link_device.h"

#include <QAbstractSocket>
#include <QCanBus>
#include <QCanBusDevice>
#include <QCoreApplication>
#include <QEvent>
#include <QSocketNotifier>
#include <QVariant>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <utility>

#include "link/adapters.h"

namespace deckpipe {
namespace {

constexpr int kReceiveBufferBytes = 4 * 1'024 * 1'024;  // some 5,000 frames, more than 0.1 s of a full bus
// Limit for plugins that queue inside: a longer queue would be sent long after it was meant.
constexpr qint64 kMaxQueued = 32;

}  // namespace

LinkDevice::LinkDevice(const LinkSettings& settings, QObject* parent)
    : QObject(parent), m_settings(settings), m_again(this) {
  m_again.setSingleShot(true);
  connect(&m_again, &QTimer::timeout, this, &LinkDevice::open);
}

LinkDevice::~LinkDevice() {
  close(Leave::Politely);
  for (auto* socket : findChildren<QAbstractSocket*>()) socket->flush();
}

void LinkDevice::open() {
  std::optional<LinkObstacle> obstacle;
  {
    const std::unique_lock lock(serialBusMutex(), std::try_to_lock);
    if (!lock) return m_again.start(kTryAgain);
    obstacle = make();
    if (!obstacle) obstacle = connectDevice();
  }
  if (obstacle) {
    Q_EMIT failed(obstacle->fault, obstacle->reason);
    return;
  }
  // Only now, as no callback may come with the lock held. What happened before is looked at here.
  connect(m_device, &QCanBusDevice::framesReceived, this, &LinkDevice::framesReceived);
  connect(m_device, &QCanBusDevice::errorOccurred, this, &LinkDevice::errorOccurred);
  connect(m_device, &QCanBusDevice::stateChanged, this, &LinkDevice::stateChanged);
  // The virtualcan plugin does not listen to its socket's errors.
  if (auto* socket = tcpSocket())
    connect(socket, &QAbstractSocket::errorOccurred, this, &LinkDevice::socketFailed);
  if (m_device->state() == QCanBusDevice::ConnectedState) cameUp();
}

std::optional<LinkObstacle> LinkDevice::make() {
  QString error;
  m_device = QCanBus::instance()->createDevice(m_settings.plugin, m_settings.interfaceName, &error);
  if (m_device == nullptr) return LinkObstacle{LinkFault::NoPlugin, error};
  m_device->setParent(this);
  // virtualcan finds fault with its interface in the constructor, and would go on with some other channel.
  if (m_device->error() != QCanBusDevice::NoError) {
    return LinkObstacle{LinkFault::NoInterface, m_device->errorString()};
  }
  if (const auto obstacle = setBitRate()) return obstacle;
  if (isSocketCan(m_settings.plugin)) {
    m_device->setConfigurationParameter(QCanBusDevice::LoopbackKey, true);
    m_device->setConfigurationParameter(QCanBusDevice::ReceiveOwnKey, true);
    m_device->setConfigurationParameter(QCanBusDevice::CanFdKey, true);  // only so that they are counted
  }
  return {};
}

// The plugins' own 500,000 must not stand. Without a value socketcan leaves the interface alone, whose rate
// was just looked at; with one it would try to set it, through libsocketcan, and fail because it is up.
std::optional<LinkObstacle> LinkDevice::setBitRate() {
  if (!pluginTakesBitRate(m_settings.plugin)) return {};
  const bool leavesIt = isSocketCan(m_settings.plugin);
  const QVariant asked = m_settings.bitRate != 0 && !leavesIt ? QVariant(m_settings.bitRate) : QVariant();
  m_device->setConfigurationParameter(QCanBusDevice::BitRateKey, asked);
  const bool isTaken = m_device->configurationParameter(QCanBusDevice::BitRateKey) == asked;
  if (isTaken && (m_settings.bitRate != 0 || leavesIt)) return {};
  return LinkObstacle{LinkFault::BitRateRefused, m_device->errorString()};
}

std::optional<LinkObstacle> LinkDevice::connectDevice() {
  if (!m_device->connectDevice()) return LinkObstacle{LinkFault::Other, m_device->errorString()};
  const auto* socket = tcpSocket();
  if (socket != nullptr && socket->error() != QAbstractSocket::UnknownSocketError) {
    return LinkObstacle{LinkFault::NoAnswer, socket->errorString()};
  }
  return {};
}

QAbstractSocket* LinkDevice::tcpSocket() const {
  return m_device->findChild<QAbstractSocket*>(QString(), Qt::FindDirectChildrenOnly);
}

void LinkDevice::cameUp() {
  // Otherwise a small frame may wait for the acknowledgement of the one before, up to 40 ms.
  if (auto* socket = tcpSocket()) socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
  if (isSocketCan(m_settings.plugin)) {
    m_notifier = m_device->findChild<QSocketNotifier*>(QString(), Qt::FindDirectChildrenOnly);
    m_descriptor = m_notifier != nullptr ? static_cast<int>(m_notifier->socket()) : -1;
  }
  if (m_descriptor >= 0) {
    startStamping(m_descriptor);
    growReceiveBuffer(m_descriptor, kReceiveBufferBytes);
  }
  m_drops = 0;
  m_isUp = true;
  Q_EMIT connected();
}

void LinkDevice::stateChanged() {
  if (m_device->state() == QCanBusDevice::ConnectedState && !m_isUp) return cameUp();
  if (m_device->state() == QCanBusDevice::UnconnectedState) {
    Q_EMIT failed(LinkFault::Gone, m_device->errorString());
  }
}

void LinkDevice::socketFailed() {
  Q_EMIT failed(m_isUp ? LinkFault::Gone : LinkFault::NoAnswer, tcpSocket()->errorString());
}

void LinkDevice::errorOccurred() {
  // Plugins tell a refused write in words alone. They do so from inside the write, while its error number still stands.
  if (const int error = errno; m_writing) {
    m_writeErrno = error;
    m_writeError = m_device->errorString();
  } else {
    Q_EMIT reported(m_device->errorString());
  }
}

void LinkDevice::close(Leave leave) {
  m_again.stop();
  m_isUp = false;
  m_notifier = nullptr;
  m_descriptor = -1;
  if (m_device == nullptr) return;
  QCanBusDevice* device = std::exchange(m_device, nullptr);
  if (auto* socket = device->findChild<QAbstractSocket*>(QString(), Qt::FindDirectChildrenOnly)) {
    socket->disconnect(this);
  }
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

WriteResult LinkDevice::write(const Frame& frame, QString& reason) {
  if (m_device == nullptr) return WriteResult::NotOpen;
  if (frame.isError() || frame.length > 8) return WriteResult::Failed;
  if (m_device->framesToWrite() >= kMaxQueued) return WriteResult::QueueFull;
  const QCanBusFrame out = toCanBusFrame(frame);
  m_writeError.clear();
  m_writeErrno = errno = 0;
  m_writing = true;
  const bool isWritten = m_device->writeFrame(out);
  m_writing = false;
  if (isWritten) return WriteResult::Accepted;
  reason = m_writeError;
  return m_writeErrno == ENOBUFS || m_writeErrno == EAGAIN ? WriteResult::QueueFull : WriteResult::Failed;
}

QList<QCanBusFrame> LinkDevice::takeFrames() {
  if (m_device == nullptr || m_device->state() != QCanBusDevice::ConnectedState) return {};
  return m_device->readAllFrames();
}

// The plugin reads when its notifier fires. The first time may give only the socket's error, hence twice.
void LinkDevice::readRest() {
  for (int i = 0; i < 2 && m_notifier != nullptr && receiveBuffer() && receiveBuffer()->used > 0; ++i) {
    QEvent ready(QEvent::SockAct);
    QCoreApplication::sendEvent(m_notifier, &ready);
  }
}

std::optional<ReceiveBuffer> LinkDevice::receiveBuffer() const {
  return m_descriptor >= 0 ? readReceiveBuffer(m_descriptor) : std::nullopt;
}

std::uint32_t LinkDevice::takeDrops() {
  const auto buffer = receiveBuffer();
  return buffer ? buffer->drops - std::exchange(m_drops, buffer->drops) : 0;
}

Result<Frame, NotKept> fromCanBusFrame(const QCanBusFrame& frame, Channel channel) {
  const QByteArray payload = frame.payload();
  if (frame.hasFlexibleDataRateFormat()) return Failure{NotKept::FlexibleDataRate};
  if (payload.size() > 8) return Failure{NotKept::Invalid};

  Frame out;
  switch (frame.frameType()) {
    case QCanBusFrame::DataFrame:
    case QCanBusFrame::RemoteRequestFrame:
      if (!frame.isValid()) return Failure{NotKept::Invalid};
      out.id = frame.frameId() | (frame.hasExtendedFrameFormat() ? kExtendedBit : 0u);
      if (frame.frameType() == QCanBusFrame::RemoteRequestFrame) out.id |= kRemoteBit;
      break;
    case QCanBusFrame::ErrorFrame:
      // frameId() is 0 for these; the error class stands where the identifier would.
      out.id = kErrorBit | (static_cast<std::uint32_t>(frame.error().toInt()) & kIdMask);
      break;
    case QCanBusFrame::UnknownFrame:
    case QCanBusFrame::InvalidFrame: return Failure{NotKept::Invalid};
  }
  out.channel = channel.value;
  out.length = static_cast<std::uint8_t>(payload.size());
  if (!out.isRemote()) std::copy(payload.cbegin(), payload.cend(), out.data.begin());
  const QCanBusFrame::TimeStamp stamp = frame.timeStamp();
  if (stamp.seconds() != 0 || stamp.microSeconds() != 0) {
    out.stamp = stamp.seconds() * 1'000'000'000 + stamp.microSeconds() * 1'000;
  }
  return out;
}

QCanBusFrame toCanBusFrame(const Frame& frame) {
  QCanBusFrame out(QCanBusFrame::DataFrame);
  if (frame.isError()) {
    out.setFrameType(QCanBusFrame::ErrorFrame);
    out.setError(QCanBusFrame::FrameErrors::fromInt(static_cast<int>(frame.identifier())));
  } else {
    if (frame.isRemote()) out.setFrameType(QCanBusFrame::RemoteRequestFrame);
    out.setFrameId(frame.identifier());
    out.setExtendedFrameFormat(frame.isExtended());
  }
  const qsizetype length = std::min<qsizetype>(frame.length, 8);
  QByteArray payload(length, '\0');
  if (!frame.isRemote()) std::copy_n(frame.data.begin(), length, payload.begin());
  out.setPayload(payload);
  if (frame.hasStamp()) {
    out.setTimeStamp(QCanBusFrame::TimeStamp::fromMicroSeconds(frame.stamp / 1'000));
  }
  return out;
}

}  // namespace deckpipe
