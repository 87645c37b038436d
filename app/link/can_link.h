// SPDX-License-Identifier: GPL-3.0-or-later
// A CAN adapter through any of Qt's plugins: the Port of the real thing. The session makes one per channel on
// the bus thread, gives it a listener and owns it; every call and every callback is on that thread, which
// needs an event loop. Frames are converted as they arrive, many at a time, and none is kept here.
//
// 1. It never sends at a bit rate other than the one asked for, where that can be found out: nobody can
// change the
//    rate of an interface of Linux that is up, so it is left alone, its rate is read from the driver and the
//    link refused if it differs. Plugins that would not take the rate are refused too.
// 2. It says Up only for what is up: socketcan connects to interfaces that are down, and virtualcan waits for
//    ever where nobody listens. The first is refused, the second given up after kConnectTimeout.
// 3. An interface of Linux that goes down, is pulled out or comes back at another rate is Lost, and Up again
// by
//    itself as soon as one of that name is up at the rate asked for. However short the gap was, it is told:
//    the kernel's events are followed one by one. Other adapters that are gone are Lost until opened again.
// 4. A failed write is told by its result and status().reason, not by linkChanged. Error frames are never
//    written: virtualcan would put them on the bus as identifier 0, which is an NMT command.
#pragma once

#include <QObject>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bus/own_frames.h"
#include "bus/port.h"
#include "link/interface_source.h"
#include "link/kernel_socket.h"

class QCanBusDevice;
class QCanBusFrame;
class QSocketNotifier;
class QTimer;

namespace deckpipe {

struct LinkSettings {
  QString plugin;         // a key of QCanBus::plugins(): "socketcan", "virtualcan", "peakcan" ...
  QString interfaceName;  // in the plugin's way: "can0", "usb0", "tcp://127.0.0.1:41234/can0?echo"
  int bitRate = 250'000;  // bit/s. 0: as the interface has it, which only socketcan can do
  Channel channel;        // put into every frame
};

enum class LinkFault : std::uint8_t {
  None,
  NoPlugin,  // not installed, or its library is missing
  NoInterface,
  InterfaceDown,   // needs: ip link set NAME up type can bitrate RATE
  WrongBitRate,    // the interface runs at another rate than asked for
  BitRateRefused,  // the adapter cannot do the rate asked for
  NoAnswer,
  Gone,   // unplugged, or its other end went away
  Other,  // in the adapter's words
};

// What is known of a link besides its frames, for the status strip. Counters are since open().
struct LinkStatus {
  LinkState state = LinkState::Closed;
  LinkFault fault = LinkFault::None;
  std::string reason;                    // the last that went wrong, in words
  std::optional<CanInterface> hardware;  // bit rate, listen-only, controller; of socketcan only
  std::uint64_t received = 0;            // from others
  std::uint64_t written = 0;             // accepted by the adapter
  std::uint64_t confirmed = 0;           // of these came back
  std::uint64_t refused = 0;             // writes that were not Accepted
  std::uint64_t notKept = 0;
  std::uint64_t errors = 0;  // reports of the adapter that left the link up
};

class CanLink : public QObject, public Port {
  Q_OBJECT
 public:
  static constexpr std::chrono::seconds kConnectTimeout{5};

  // ns since 1970, for stamping frames that the adapter does not give back.
  using WallClock = std::function<std::int64_t()>;

  // How often the controller's state and counters are read, of which the kernel sends no news.
  static constexpr std::chrono::milliseconds kHardwarePeriod{1'000};
  // … and how soon after an error frame.
  static constexpr std::chrono::milliseconds kAfterError{100};

  // Without `interfaces` the kernel is asked, for socketcan; a test may have its own.
  explicit CanLink(LinkSettings settings, QObject* parent = nullptr, WallClock clock = systemClock,
                   std::unique_ptr<InterfaceSource> interfaces = nullptr);
  ~CanLink() override;

  void open(PortListener& listener) override;
  void close() override;
  WriteResult write(const Frame& frame) override;
  bool echoes() const override;

  const LinkSettings& settings() const { return m_settings; }
  const LinkStatus& status() const { return m_status; }
  // Frames written that have not come back; only of use where echoes().
  std::size_t unconfirmed() const { return m_own.waiting(); }
  // The kernel's, of socketcan while it is open. What it drops comes to the listener as NotKept::Overflow,
  // and so does what controller and driver lost.
  std::optional<ReceiveBuffer> receiveBuffer() const;

  static std::int64_t systemClock();

 private:
  // Opening, in this order; each says what stands in the way, if anything does.
  struct Obstacle {
    LinkFault fault;
    QString reason;
  };
  std::optional<Obstacle> checkHardware();
  std::optional<Obstacle> obstacleIn(const CanInterface& facts) const;
  std::optional<Obstacle> createDevice();
  std::optional<Obstacle> connectDevice();

  bool isSocketCan() const;
  void deviceStateChanged();
  void deviceError();
  void socketFailed();
  void interfaceChanged(const CanInterface& facts);
  void readHardware(bool hasMissedEvents);
  void follow(const CanInterface& facts);
  void wentDown(const Obstacle& obstacle);
  void wasRemoved();
  void reconnect();
  void stopFollowing();
  void cameUp();
  void gone(LinkFault fault, const QString& reason);
  void tell(LinkState state, LinkFault fault, const QString& reason);
  enum class Leave { Politely, AtOnce };
  void dropDevice(Leave leave);

  void postDelivery();
  void takeFrames();
  void takeRest();
  void takeFrame(const QCanBusFrame& frame);
  void deliver();
  bool deliverRest();
  std::uint32_t newDrops();
  void countOverruns(const CanInterface& facts);

  LinkSettings m_settings;
  WallClock m_clock;
  PortListener* m_listener = nullptr;
  QCanBusDevice* m_device = nullptr;
  std::unique_ptr<InterfaceSource> m_interfaces;  // null where the adapter is no interface of Linux
  QTimer* m_connectTimer = nullptr;
  QTimer* m_hardwareTimer = nullptr;
  int m_session = 0;  // counts what open() began and close() ended
  LinkStatus m_status;

  OwnFrames m_own;
  std::vector<Frame> m_batch;
  std::vector<std::pair<std::size_t, NotKept>> m_missing;  // place in m_batch
  bool m_deliveryPosted = false;
  bool m_writing = false;
  QString m_writeError;
  int m_descriptor = -1;  // of socketcan's socket
  QSocketNotifier* m_notifier = nullptr;
  std::uint32_t m_drops = 0;
  std::uint64_t m_overruns = 0;     // of the interface, as last read
  std::uint32_t m_newOverruns = 0;  // not told yet
};

}  // namespace deckpipe
