// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter itself: a device of one of Qt's plugins, made, connected, written to and dropped. The set-up
// that each plugin needs is here. CanLink owns one LinkDevice for its whole life.
//
// It lives on the bus thread. Two things could hold that thread up:
// 1. The plugin's own code. Qt loads its library on first use; the socketcan plugin opens, configures and
//    closes its socket inside connectDevice() and disconnectDevice(), and newer kernels take their network
//    lock for that. A plugin must run on the thread that uses it, so this cannot be moved to a worker. It
//    happens while a link is opened, closed or lost, never while it is up.
// 2. The lock of QtSerialBus (serialBusMutex). A listing of adapters holds it for as long as makers'
//    libraries take. open() does not wait for it, but tries again every kTryAgain.
#pragma once

#include <QCanBusFrame>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <optional>

#include "base/result.h"
#include "bus/port.h"
#include "link/kernel_socket.h"
#include "link/link_status.h"

class QAbstractSocket;
class QCanBusDevice;
class QSocketNotifier;

namespace deckpipe {

struct LinkObstacle {
  LinkFault fault;
  QString reason;
};

class LinkDevice : public QObject {
  Q_OBJECT
 public:
  static constexpr std::chrono::milliseconds kTryAgain{10};

  // `settings` must live as long.
  LinkDevice(const LinkSettings& settings, QObject* parent);
  // Frames written last, neutral perhaps, leave before the sockets are destroyed. No signal is emitted.
  ~LinkDevice() override;

  // Ends in connected() or failed(), within the call or later.
  void open();
  enum class Leave { Politely, AtOnce };
  // No signal is emitted until the next open().
  void close(Leave leave);

  // Sets `reason` to the adapter's words, if it has any, where the result is not Accepted.
  WriteResult write(const Frame& frame, QString& reason);
  // The frames that have arrived. None while it is not connected.
  QList<QCanBusFrame> takeFrames();
  // Reads what the kernel still holds for us, before the socket goes.
  void readRest();

  // The kernel's, of socketcan while it is connected.
  std::optional<ReceiveBuffer> receiveBuffer() const;
  // Frames that the kernel dropped since the last call.
  std::uint32_t takeDrops();

 Q_SIGNALS:
  void connected();
  // Could not be opened, or went away.
  void failed(deckpipe::LinkFault fault, const QString& reason);
  // A fault that leaves it connected.
  void reported(const QString& reason);
  void framesReceived();

 private:
  std::optional<LinkObstacle> make();
  std::optional<LinkObstacle> setBitRate();
  std::optional<LinkObstacle> connectDevice();
  QAbstractSocket* tcpSocket() const;
  void cameUp();
  void stateChanged();
  void errorOccurred();
  void socketFailed();

  const LinkSettings& m_settings;
  QTimer m_again;
  QCanBusDevice* m_device = nullptr;
  bool m_isUp = false;
  bool m_writing = false;
  QString m_writeError;
  int m_writeErrno = 0;
  QSocketNotifier* m_notifier = nullptr;  // of socketcan's socket
  int m_descriptor = -1;
  std::uint32_t m_drops = 0;
};

// QCanBusFrame <-> Frame, the only place where one becomes the other. CanLink calls it for every frame.
// Flags stay 0; CanLink sets them, as it knows whose frame it is. CAN FD frames, unknown kinds and identifiers out of
// range are refused with their reason. A stamp of exactly zero is what plugins leave when
// the driver gave none, and becomes kNoStamp.
Result<Frame, NotKept> fromCanBusFrame(const QCanBusFrame& frame, Channel channel);

// Data and remote frames; a remote frame carries its length as that many zero bytes, as the plugins want it.
// Error frames are not for sending (see CanLink::write), but convert faithfully.
QCanBusFrame toCanBusFrame(const Frame& frame);

}  // namespace deckpipe
