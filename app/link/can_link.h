// SPDX-License-Identifier: GPL-3.0-or-later
// A CAN adapter through any of Qt's plugins: the Port of the real thing. The session makes one per channel on
// the bus thread, gives it a listener and owns it; every call and every callback is on that thread, which
// needs an event loop. Frames are converted as they arrive, many at a time, and none is kept here.
//
// 1. It never sends at a bit rate other than the one asked for, where that can be found out. Nobody can
//    change the rate of an interface of Linux that is up, so it is left alone: its rate is read from the
//    driver, and the link is refused if it differs. Plugins that would not take the rate are refused too.
// 2. It says Up only for what is up. socketcan connects to interfaces that are down: that is refused.
//    virtualcan waits for ever where nobody listens: that is given up after kConnectTimeout.
// 3. An interface of Linux that goes down, is pulled out or comes back at another rate is Lost, and Up again
//    by itself as soon as one of that name is up at the rate asked for. However short the gap was, it is
//    told: the kernel's events are followed one by one. Other adapters that are gone are Lost until the link
//    is opened again.
// 4. A failed write is told by its result and status().reason, not by linkChanged. Error frames are never
//    written: virtualcan would put them on the bus as identifier 0, which is an NMT command.
// 5. It asks the kernel nothing that waits. open() returns Connecting while a worker asks how the interface
//    is. What Qt's plugins do inside themselves remains, see LinkDevice.
//
// Its parts: link_life.h (the table of stages), HardwareFacts (the network interface), LinkDevice (the
// plugin) and LinkDelivery (frames to the listener).
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "bus/own_frames.h"
#include "bus/port.h"
#include "link/interface_watch.h"
#include "link/kernel_socket.h"
#include "link/link_delivery.h"
#include "link/link_life.h"
#include "link/link_status.h"

namespace deckpipe {

class HardwareFacts;
class LinkDevice;

class CanLink : public QObject, public Port {
  Q_OBJECT
 public:
  // For the interface to be known, and again for the device to be connected.
  static constexpr std::chrono::seconds kConnectTimeout{5};

  // ns since 1970, for stamping frames that the adapter does not give back.
  using WallClock = std::function<std::int64_t()>;

  // Without `interfaces` the kernel is asked, for socketcan; a test may have its own.
  explicit CanLink(LinkSettings settings, QObject* parent = nullptr, WallClock clock = systemClock,
                   std::unique_ptr<InterfaceSource> interfaces = nullptr);
  // Waits for nobody and calls nobody. What was written last still leaves.
  ~CanLink() override;

  void open(PortListener& listener) override;
  void close() override;
  WriteResult write(const Frame& frame) override;
  bool echoes() const override;
  // Hands over what has arrived by now, also what the kernel still holds: whoever judges time calls it first.
  void drain();

  const LinkSettings& settings() const { return m_settings; }
  const LinkStatus& status() const { return m_status; }
  // The kernel's, of socketcan while it is open. Frames that the kernel drops come to the listener as
  // NotKept::Overflow, those that controller or driver lose as NotKept::Overrun.
  std::optional<ReceiveBuffer> receiveBuffer() const;

  static std::int64_t systemClock();

 private:
  void happened(LinkEvent event, LinkFault fault = LinkFault::None, const QString& reason = {});
  void enter(LinkStage stage, bool politely);
  void follow(const CanInterface& facts);
  void report(const QString& reason);
  void tell(LinkFault fault, const QString& reason);

  void postDelivery();
  void takeFrames();
  void deliver();
  bool deliverRest();

  LinkSettings m_settings;
  WallClock m_clock;
  LinkStatus m_status;
  LinkStage m_stage = LinkStage::Closed;
  int m_moves = 0;  // of the stage: tells whether a callback has led to one
  LinkDelivery m_delivery;
  bool m_isDeliveryPosted = false;
  QTimer m_waiting;
  std::unique_ptr<LinkDevice> m_device;
  std::unique_ptr<HardwareFacts> m_hardware;  // null where the adapter is no interface of Linux
};

}  // namespace deckpipe
