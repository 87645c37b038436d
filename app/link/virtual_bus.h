// SPDX-License-Identifier: GPL-3.0-or-later
// A private bus on loopback for Qt's `virtualcan` plugin: the demo, its simulator and the tests talk over
// it, so that the whole real path runs without hardware. Whoever starts the demo makes one, and gives
// interfaceName() to the links that are to meet on it.
//
// Why not let the plugin host it, as it does by itself:
// 1. The plugin hosts one server a process, on the first port used, for ever. A second bus is never hosted,
//    and its users stay 'connecting' without a word.
// 2. A port that somebody else listens on is joined silently. Here the system picks a free port, and it is
//    ours from then on: there is no moment at which another program could take it.
// 3. The plugin's server does not return frames to their sender, and the plugin's own copy of what it wrote
//    proves nothing. This server returns them, marked as local echo, when it has put them on the bus: with it
//    a link confirms its frames as SocketCAN does. "?echo" in the name tells CanLink; a plain Qt client
//    that joins sees its own frames come back.
// The plugin still tries to listen on our port first and gives up, which is harmless.
#pragma once

#include <QByteArray>
#include <QObject>
#include <memory>
#include <vector>

class QTcpServer;
class QTcpSocket;

namespace deckpipe {

class VirtualBus : public QObject {
  Q_OBJECT
 public:
  static constexpr int kChannels = 2;  // what the plugin knows: can0 and can1

  explicit VirtualBus(QObject* parent = nullptr);
  ~VirtualBus() override;

  // Takes a free port. False with errorString() where the system refuses.
  bool start();
  // Everybody on it loses the link.
  void stop();
  QString errorString() const;

  // For LinkSettings, e.g. "tcp://127.0.0.1:41234/can0?echo". Empty unless started.
  QString interfaceName(int channel) const;

  // How many are on that channel now. Frames written before the other end is on it reach nobody, as on a real
  // bus; who must not lose the first ones waits for clientsChanged().
  int clients(int channel) const;
  // Lines that were no frame and no command; their senders are no virtualcan plugin.
  int refusedLines() const { return m_refusedLines; }

 Q_SIGNALS:
  void clientsChanged();

 private:
  struct Client;

  void accept();
  void read(Client& client);
  bool handleLine(Client& client, QByteArrayView line);
  void forward(const Client& from, int channel, QByteArrayView frame);
  void remove(Client& client);
  void announce();

  std::unique_ptr<QTcpServer> m_server;
  std::vector<std::unique_ptr<Client>> m_clients;
  int m_refusedLines = 0;
};

}  // namespace deckpipe
