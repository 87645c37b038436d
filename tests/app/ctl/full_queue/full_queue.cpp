// SPDX-License-Identifier: GPL-3.0-or-later
// A plugin of QtSerialBus for the tests of the tool: `virtualcan` with an adapter whose queue is full once, when the
// third packet for a data pipe is written. QCanBus refuses that frame as it does for socketcan.
#include <QCanBus>
#include <QCanBusDevice>
#include <QCanBusDeviceInfo>
#include <QCanBusFactory>
#include <QCanBusFrame>
#include <cerrno>
#include <memory>

constexpr int kRefused = 3;  // packet

class FullQueueDevice final : public QCanBusDevice {
  Q_OBJECT
 public:
  FullQueueDevice(const QString& interfaceName, QString* error)
      : m_bus(QCanBus::instance()->createDevice(QStringLiteral("virtualcan"), interfaceName, error)) {
    if (m_bus == nullptr) return;
    connect(m_bus.get(), &QCanBusDevice::framesReceived, this,
            [this] { enqueueReceivedFrames(m_bus->readAllFrames()); });
    connect(m_bus.get(), &QCanBusDevice::stateChanged, this, [this](CanBusDeviceState to) { setState(to); });
  }
  bool isMade() const { return m_bus != nullptr; }

  bool writeFrame(const QCanBusFrame& frame) override {
    const QByteArray payload = frame.payload();
    const bool isPacket =
        (frame.frameId() & 0xFF'0000) == 0xEF'0000 && payload.size() > 1 && payload[0] == '\xFE';
    if (isPacket && ++m_packets == kRefused) {
      setError(qt_error_string(ENOBUFS), WriteError);
      return false;
    }
    return m_bus->writeFrame(frame);
  }
  QString interpretErrorFrame(const QCanBusFrame&) override { return {}; }

 protected:
  bool open() override { return m_bus->connectDevice(); }
  void close() override { m_bus->disconnectDevice(); }

 private:
  std::unique_ptr<QCanBusDevice> m_bus;
  int m_packets = 0;
};

class FullQueuePlugin final : public QObject, public QCanBusFactory {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID "org.qt-project.Qt.QCanBusFactory" FILE "full_queue.json")
  Q_INTERFACES(QCanBusFactory)
 public:
  QCanBusDevice* createDevice(const QString& interfaceName, QString* error) const override {
    auto device = std::make_unique<FullQueueDevice>(interfaceName, error);
    return device->isMade() ? device.release() : nullptr;
  }
  QList<QCanBusDeviceInfo> availableDevices(QString*) const override { return {}; }
};

#include "full_queue.moc"
