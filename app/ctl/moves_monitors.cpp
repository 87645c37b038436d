// SPDX-License-Identifier: GPL-3.0-or-later
#include "moves_monitors.h"

#include <QStringList>

#include "link/adapters.h"
#include "protocol/device_types.h"

namespace deckpipe::ctl {
namespace {

QString placeOf(const Stranger& stranger) {
  if (stranger.node.value != 0) return QStringLiteral("at node %1").arg(stranger.node.value);
  if (stranger.kind == Stranger::Kind::Akron && stranger.address == kNullAddress)
    return QStringLiteral("without an address");
  return QStringLiteral("at address ") + addressText(stranger.address);
}

QString whoIs(const Stranger& stranger) {
  switch (stranger.kind) {
    case Stranger::Kind::Joystick: return QStringLiteral("a joystick");
    case Stranger::Kind::OwnAddress: return QStringLiteral("somebody else");
    case Stranger::Kind::Akron: break;
  }
  if (stranger.pin.isNull()) return QStringLiteral("an Akron device");
  const std::string type(deviceTypeName(stranger.pin.deviceType()));
  return QStringLiteral("%1 (%2)").arg(
      QString::fromStdString(std::string(stranger.pin.text())),
      type.empty() ? QStringLiteral("an Akron device") : QString::fromStdString(type));
}

}  // namespace

Arguments::Option movesMonitorsOption() {
  return {"moves-monitors", "The word for an interface with real monitors: any but virtualcan's and a vcan."};
}

QString movesMonitorsMissing(const QString& interfaceName) {
  return QStringLiteral(
             "real monitors may be on %1, and every one that hears this moves; --moves-monitors is the word "
             "for "
             "it. It is not wanted for virtualcan, a vcan or a file")
      .arg(interfaceName);
}

bool mayHoldRealMonitors(const LinkSettings& link) {
  std::optional<CanInterface> facts;
  if (const auto read = readInterface(link.interfaceName.toStdString()); isSocketCan(link.plugin) && read)
    facts = read.value();
  return !isSimulatedBus(link, facts);
}

std::optional<QString> movesMonitorsTrouble(const Arguments& arguments, const LinkSettings& link) {
  std::optional<CanInterface> facts;
  if (isSocketCan(link.plugin)) {
    const auto read = readInterface(link.interfaceName.toStdString());
    if (!read || !read.value().isCan)
      return QStringLiteral("no such CAN interface: '%1'").arg(link.interfaceName);
    facts = read.value();
  }
  if (arguments.has("moves-monitors") || isSimulatedBus(link, facts)) return {};
  return movesMonitorsMissing(link.interfaceName);
}

QString strangersText(const std::vector<Stranger>& strangers) {
  QStringList heard;
  for (const Stranger& stranger : strangers) heard += whoIs(stranger) + QLatin1Char(' ') + placeOf(stranger);
  return heard.join(QStringLiteral("; "));
}

}  // namespace deckpipe::ctl
