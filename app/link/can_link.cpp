// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/can_link.h"

#include <QCanBusFrame>

#include "link/adapters.h"
#include "link/hardware_facts.h"
#include "link/interface_watch.h"
#include "link/link_device.h"

namespace deckpipe {
namespace {

struct Judgement {
  LinkEvent event = LinkEvent::Fits;
  LinkFault fault = LinkFault::None;
};

Judgement judge(const CanInterface& facts, int bitRate) {
  if (!facts.isCan) {
    return {LinkEvent::Unfit, LinkFault::NoInterface};
  }
  if (!facts.isUp) {
    return {LinkEvent::IsDown, LinkFault::InterfaceDown};
  }
  const auto asked = static_cast<std::uint32_t>(bitRate);
  if (asked != 0 && facts.bitRate != 0 && facts.bitRate != asked) {
    return {LinkEvent::Unfit, LinkFault::WrongBitRate};
  }
  return {};
}

}  // namespace

CanLink::CanLink(LinkSettings settings, QObject* parent, WallClock clock,
                 std::unique_ptr<InterfaceSource> interfaces)
    : QObject(parent),
      m_settings(std::move(settings)),
      m_clock(std::move(clock)),
      m_delivery(m_settings.channel, pluginEchoes(m_settings.plugin, m_settings.interfaceName), m_status),
      m_waiting(this),
      m_device(std::make_unique<LinkDevice>(m_settings, this)) {
  m_waiting.setSingleShot(true);
  connect(&m_waiting, &QTimer::timeout, this,
          [this] { happened(LinkEvent::DeviceFailed, LinkFault::NoAnswer); });
  connect(m_device.get(), &LinkDevice::connected, this, [this] { happened(LinkEvent::DeviceConnected); });
  connect(m_device.get(), &LinkDevice::failed, this, [this](LinkFault fault, const QString& reason) {
    happened(LinkEvent::DeviceFailed, fault, reason);
  });
  connect(m_device.get(), &LinkDevice::reported, this, &CanLink::report);
  connect(m_device.get(), &LinkDevice::framesReceived, this, &CanLink::takeFrames);

  if (interfaces == nullptr && isSocketCan(m_settings.plugin))
    interfaces = std::make_unique<InterfaceWatch>();
  if (interfaces == nullptr) return;
  m_hardware =
      std::make_unique<HardwareFacts>(m_settings.interfaceName.toStdString(), std::move(interfaces), this);
  connect(m_hardware.get(), &HardwareFacts::learned, this, &CanLink::follow);
  connect(m_hardware.get(), &HardwareFacts::missing, this,
          [this](const QString& reason) { happened(LinkEvent::Missing, LinkFault::NoInterface, reason); });
  connect(m_hardware.get(), &HardwareFacts::removed, this, [this] {
    m_status.hardware.reset();
    happened(LinkEvent::Missing, LinkFault::Gone);
  });
  connect(m_hardware.get(), &HardwareFacts::lost, this, [this](std::uint32_t frames) {
    m_delivery.overran(frames);
    postDelivery();
  });
}

CanLink::~CanLink() { m_delivery.end(); }

std::int64_t CanLink::systemClock() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

bool CanLink::echoes() const { return pluginEchoes(m_settings.plugin, m_settings.interfaceName); }

std::optional<ReceiveBuffer> CanLink::receiveBuffer() const { return m_device->receiveBuffer(); }

void CanLink::open(PortListener& listener) {
  close();
  m_status = {};
  m_delivery.begin(listener);
  enter(next(m_stage, LinkEvent::Open), true);
  const int moves = m_moves;
  tell(LinkFault::None, {});
  if (m_moves != moves) return;  // the listener closed, or opened anew
  if (m_hardware != nullptr) {
    m_hardware->start();
  } else {
    happened(LinkEvent::Fits);
  }
}

void CanLink::close() {
  while (m_delivery.hasListener() && !deliverRest()) {
  }
  PortListener* listener = m_delivery.end();
  if (listener == nullptr) return;
  const bool wasOpen = m_stage != LinkStage::Closed;
  enter(next(m_stage, LinkEvent::Close), true);
  m_status.state = LinkState::Closed;
  if (wasOpen) listener->linkChanged(LinkState::Closed, {});
}

// Carries out one move of the table. The listener may close or open from inside: what is left of this move is
// then of no interest.
void CanLink::happened(LinkEvent event, LinkFault fault, const QString& reason) {
  const LinkStage before = m_stage, after = next(before, event);
  const bool isEnd = (before == LinkStage::Up && after != before) || (hasDevice(before) && !hasDevice(after));
  if (isEnd && !deliverRest()) return;
  enter(after, false);
  const bool isNews = fault != LinkFault::None && fault != m_status.fault;
  if (shown(after) != m_status.state || isNews) tell(fault, reason);
  if (!hasDevice(before) && hasDevice(after)) m_device->open();
}

// Carries out what the new stage needs; telling the listener is apart.
void CanLink::enter(LinkStage stage, bool politely) {
  const LinkStage before = std::exchange(m_stage, stage);
  if (before == stage) return;
  ++m_moves;
  if (isWaiting(stage)) {
    m_waiting.start(kConnectTimeout);
  } else {
    m_waiting.stop();
  }
  if (hasDevice(before) && !hasDevice(stage)) {
    m_device->close(politely ? LinkDevice::Leave::Politely : LinkDevice::Leave::AtOnce);
    m_delivery.clear();
  }
  if (m_hardware == nullptr) return;
  if (hasDevice(before) != hasDevice(stage)) m_hardware->setBound(hasDevice(stage));
  if (stage == LinkStage::Closed) m_hardware->stop();
}

void CanLink::follow(const CanInterface& facts) {
  const auto isBusOff = [this] {
    return m_status.hardware && m_status.hardware->controller == ControllerState::BusOff;
  };
  const bool wasBusOff = isBusOff();
  const bool wasUp = m_stage == LinkStage::Up;
  m_status.hardware = facts;
  const Judgement judged = judge(facts, m_settings.bitRate);
  happened(judged.event, judged.fault);
  if (wasUp && m_stage == LinkStage::Up && isBusOff() && !wasBusOff) report({});
}

// A fault that leaves the link standing.
void CanLink::report(const QString& reason) {
  ++m_status.errors;
  m_status.reason = reason.toStdString();
  if (m_stage == LinkStage::Up) m_delivery.tell(m_status.state, m_status.reason);
}

void CanLink::tell(LinkFault fault, const QString& reason) {
  m_status.state = shown(m_stage);
  m_status.fault = fault;
  m_status.reason = reason.toStdString();
  m_delivery.tell(m_status.state, m_status.reason);
}

WriteResult CanLink::write(const Frame& frame) {
  if (m_stage != LinkStage::Up) return WriteResult::NotOpen;
  QString reason;
  const WriteResult result = m_device->write(frame, reason);
  if (result != WriteResult::Accepted) {
    ++m_status.refused;
    m_status.reason = reason.toStdString();
    return result;
  }
  if (!echoes()) takeFrames();  // these came before
  m_delivery.wrote(frame, m_clock());
  if (!m_delivery.isEmpty()) postDelivery();
  return result;
}

void CanLink::postDelivery() {
  if (m_isDeliveryPosted) return;
  m_isDeliveryPosted = true;
  QMetaObject::invokeMethod(this, &CanLink::deliver, Qt::QueuedConnection);
}

// At once, since a device that is not connected any more gives nothing out; they are handed over together.
void CanLink::takeFrames() {
  for (const QCanBusFrame& frame : m_device->takeFrames()) {
    m_delivery.take(frame);
    const bool isError = frame.frameType() == QCanBusFrame::ErrorFrame;
    if (isError && m_hardware != nullptr) m_hardware->readSoon();
  }
  if (!m_delivery.isEmpty()) postDelivery();
}

void CanLink::deliver() {
  m_isDeliveryPosted = false;
  takeFrames();
  m_delivery.dropped(m_device->takeDrops());
  m_delivery.handOver();
}

void CanLink::drain() {
  if (m_stage == LinkStage::Up) deliverRest();
}

// Hands over what came before the end; false where that led to another stage, by the listener or the device.
bool CanLink::deliverRest() {
  const int moves = m_moves;
  m_device->readRest();
  deliver();
  return m_moves == moves;
}

}  // namespace deckpipe
