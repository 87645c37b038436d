// SPDX-License-Identifier: GPL-3.0-or-later
// The plugin's protocol, one line each: "connect:can0", "disconnect:can0", and to us a frame as
// "can0:<identifier>#<flags>#<data>", from us the same without the channel. Flag L is local echo.
#include "link/virtual_bus.h"

#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>
#include <QVariant>
#include <algorithm>
#include <array>
#include <utility>

namespace deckpipe {
namespace {

constexpr char kLocalEcho = 'L';
constexpr qsizetype kLongestLine = 256;           // a CAN FD frame is 155
constexpr qint64 kMaxUnread = 8 * 1'024 * 1'024;  // a client that does not read is let go

// Its number after `prefix`, -1 where it is no channel of ours.
int channelOf(QByteArrayView text) {
  for (int i = 0; i < VirtualBus::kChannels; ++i) {
    if (text == "can" + QByteArray::number(i)) return i;
  }
  return -1;
}

}  // namespace

struct VirtualBus::Client {
  QTcpSocket* socket = nullptr;
  std::array<bool, kChannels> on{};
  QByteArray unread;  // the begin of a line
  QByteArray out;     // for one write a batch
};

VirtualBus::VirtualBus(QObject* parent) : QObject(parent) {}

VirtualBus::~VirtualBus() {
  for (const auto& client : m_clients) client->socket->disconnect(this);
}

bool VirtualBus::start() {
  stop();
  m_server = std::make_unique<QTcpServer>();
  connect(m_server.get(), &QTcpServer::newConnection, this, &VirtualBus::accept);
  return m_server->listen(QHostAddress::LocalHost, 0);
}

void VirtualBus::stop() {
  if (!m_server) return;
  for (const auto& client : std::exchange(m_clients, {})) {
    client->socket->disconnect(this);
    client->socket->flush();
  }
  m_server.reset();  // and with it the sockets, its children
  announce();
}

QString VirtualBus::errorString() const { return m_server ? m_server->errorString() : QString(); }

QString VirtualBus::interfaceName(int channel) const {
  if (!m_server || !m_server->isListening()) return {};
  return QStringLiteral("tcp://127.0.0.1:%1/can%2?echo").arg(m_server->serverPort()).arg(channel);
}

int VirtualBus::clients(int channel) const {
  if (channel < 0 || channel >= kChannels) return 0;
  const auto isOn = [&](const auto& client) { return client->on[static_cast<std::size_t>(channel)]; };
  return static_cast<int>(std::count_if(m_clients.begin(), m_clients.end(), isOn));
}

void VirtualBus::accept() {
  while (QTcpSocket* socket = m_server->nextPendingConnection()) {
    Client& client = *m_clients.emplace_back(std::make_unique<Client>());
    client.socket = socket;
    // Small frames each way would otherwise wait for each other's delayed acknowledgements, up to 40 ms.
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    connect(socket, &QTcpSocket::readyRead, this, [this, &client] { read(client); });
    connect(socket, &QTcpSocket::disconnected, this, [this, &client] { remove(client); });
  }
}

void VirtualBus::read(Client& client) {
  client.unread += client.socket->readAll();
  qsizetype from = 0;
  bool keep = true;
  for (qsizetype end; keep && (end = client.unread.indexOf('\n', from)) >= 0; from = end + 1) {
    keep = handleLine(client, QByteArrayView(client.unread).sliced(from, end - from).trimmed());
  }
  client.unread.remove(0, from);
  for (const auto& other : m_clients) {
    if (!other->out.isEmpty()) other->socket->write(std::exchange(other->out, {}));
  }
  // Each of these may remove a client, `client` too, so they come last and one at a time.
  if (client.unread.size() > kLongestLine) {
    ++m_refusedLines;
    client.socket->abort();
  } else if (!keep) {
    client.socket->disconnectFromHost();
  }
  const auto full = std::find_if(m_clients.begin(), m_clients.end(),
                                 [](const auto& c) { return c->socket->bytesToWrite() > kMaxUnread; });
  if (full != m_clients.end()) (*full)->socket->abort();
}

// False when the client takes its leave.
bool VirtualBus::handleLine(Client& client, QByteArrayView line) {
  const qsizetype colon = line.indexOf(':');
  const QByteArrayView head = line.first(std::max<qsizetype>(colon, 0));
  const QByteArrayView rest = line.sliced(colon + 1);
  const bool joins = head == QByteArrayView("connect");
  const bool leaves = head == QByteArrayView("disconnect");
  const int channel = channelOf(joins || leaves ? rest : head);
  if (channel < 0) {
    ++m_refusedLines;
    return true;
  }
  if (joins || leaves) {
    client.on[static_cast<std::size_t>(channel)] = joins;
    announce();
    return joins;
  }
  forward(client, channel, rest);
  return true;
}

void VirtualBus::forward(const Client& from, int channel, QByteArrayView frame) {
  const qsizetype first = frame.indexOf('#');
  const qsizetype second = first < 0 ? -1 : frame.indexOf('#', first + 1);
  // The plugin takes for granted that there are three parts, so nothing else may be passed on.
  if (second < 0 || frame.sliced(second + 1).contains('#') || frame.size() > kLongestLine) {
    ++m_refusedLines;
    return;
  }
  QByteArray flags = frame.sliced(first + 1, second - first - 1).toByteArray();
  flags.replace(kLocalEcho, "");
  const QByteArray identifier = frame.first(first + 1).toByteArray();
  const QByteArray data = frame.sliced(second).toByteArray() + '\n';
  for (const auto& to : m_clients) {
    if (!to->on[static_cast<std::size_t>(channel)]) continue;
    to->out += identifier + flags;
    if (to.get() == &from) to->out += kLocalEcho;
    to->out += data;
  }
}

void VirtualBus::remove(Client& client) {
  client.socket->disconnect(this);
  client.socket->deleteLater();
  std::erase_if(m_clients, [&](const auto& c) { return c.get() == &client; });
  announce();
}

// Queued: who hears it may stop the bus, and we may be in the middle of a client's lines.
void VirtualBus::announce() {
  QMetaObject::invokeMethod(this, &VirtualBus::clientsChanged, Qt::QueuedConnection);
}

}  // namespace deckpipe
