// SPDX-License-Identifier: GPL-3.0-or-later
#include "adapter_offers.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <utility>

#include "link/adapters.h"
#include "notice_of.h"

namespace deckpipe {
namespace {

struct Offers {
  Q_DECLARE_TR_FUNCTIONS(Offers)
};

const QString kSocketCan = QStringLiteral("socketcan");

QString rateText(std::uint32_t bitRate) { return Offers::tr("%1 kbit/s").arg(bitRate / 1000); }

QString makerLine(const Adapter& adapter) {
  QStringList parts{pluginTitle(adapter.plugin)};
  for (const QString& part : {adapter.description, adapter.alias, adapter.serialNumber}) {
    if (!part.isEmpty() && !parts.contains(part)) parts += part;
  }
  return parts.join(QStringLiteral(" · "));
}

// The loader names every place where it looked.
QString reasonOf(const QString& error) {
  static const QRegularExpression kNoLibrary(QStringLiteral("^Cannot load library ([^:\\s]+)"));
  const QRegularExpressionMatch match = kNoLibrary.match(error);
  return match.hasMatch()
             ? Offers::tr("its driver library (%1) is not installed; the adapter's maker offers it.")
                   .arg(match.captured(1))
             : error.simplified();
}

void describeInterface(AdapterOffer& offer, const Adapter& adapter, int bitRate, bool isHeard) {
  const QString& name = adapter.interfaceName;
  const bool isWrongRate =
      bitRate != 0 && adapter.bitRate != 0 && adapter.bitRate != static_cast<std::uint32_t>(bitRate);
  if (!adapter.isUp) {
    offer.tone = Severity::Warning;
    offer.state = Offers::tr("Not set up: the interface is down.");
    offer.problem = adapter.isVirtual
                        ? Offers::tr("Bring it up in a terminal:")
                        : Offers::tr(
                              "Set its bit rate and bring it up in a terminal; listen-only is safe for the "
                              "first look:");
    offer.command = adapter.isVirtual ? QStringLiteral("sudo ip link set %1 up").arg(name)
                                      : setUpCommand(name, bitRate, true);
    offer.canConnect = false;
    return;
  }
  QStringList state;
  state += adapter.bitRate != 0 ? Offers::tr("up at %1").arg(rateText(adapter.bitRate)) : Offers::tr("up");
  if (adapter.isListenOnly) state += Offers::tr("listen-only");
  if (adapter.isVirtual) state += Offers::tr("virtual");
  state += isHeard ? Offers::tr("frames are heard now") : Offers::tr("nothing heard now");
  offer.state = state.join(QStringLiteral(", "));
  offer.tone = isHeard ? Severity::Fine : Severity::Unknown;
  if (adapter.controller == ControllerState::BusOff) {
    offer.tone = Severity::Fault;
    offer.problem = Offers::tr(
        "Its controller left the bus after too many errors (bus-off). Check bit rate and "
        "termination, then:");
    offer.command = QStringLiteral("sudo ip link set %1 type can restart").arg(name);
  } else if (isWrongRate) {
    offer.tone = Severity::Warning;
    offer.problem = Offers::tr("It runs at another bit rate than the one chosen above. To change it:");
    offer.command =
        QStringLiteral("sudo ip link set %1 down; ").arg(name) + setUpCommand(name, bitRate, true);
    offer.canConnect = false;
  }
}

AdapterOffer offerOf(const Adapter& adapter, int bitRate, bool isHeard) {
  AdapterOffer offer;
  offer.plugin = adapter.plugin;
  offer.interfaceName = adapter.interfaceName;
  offer.title = adapter.interfaceName;
  offer.maker = makerLine(adapter);
  offer.isVirtual = adapter.isVirtual;
  if (adapter.plugin == kSocketCan) {
    describeInterface(offer, adapter, bitRate, isHeard);
  } else if (adapter.isVirtual) {
    offer.tone = Severity::Unknown;
    offer.state = Offers::tr("A virtual bus between programs on this computer; no truck is on it.");
  } else {
    offer.tone = Severity::Unknown;
    offer.state = Offers::tr("Its plugin lists it; whether it is plugged in is seen once it is connected.");
    if (bitRate == 0) {
      offer.problem = Offers::tr("Choose a bit rate above: this adapter does not keep one.");
      offer.canConnect = false;
    }
  }
  return offer;
}

}  // namespace

AdapterOffers offersOf(const AdapterList& list, int bitRate, bool isSearching,
                       const std::function<bool(const Adapter&)>& isHeard) {
  AdapterOffers offers;
  offers.isSearching = isSearching && list.plugins.isEmpty();
  for (const Adapter& adapter : list.adapters)
    offers.adapters.push_back(offerOf(adapter, bitRate, isHeard(adapter)));
  // Adapters that can be connected to stand first, virtual buses last.
  std::ranges::stable_sort(offers.adapters, {}, [](const AdapterOffer& offer) {
    return std::pair(offer.isVirtual, !offer.canConnect);
  });
  QStringList missing;
  bool hasSocketCan = false;
  bool hasInterface = false;
  for (const AdapterPlugin& plugin : list.plugins) {
    hasSocketCan = hasSocketCan || plugin.plugin == kSocketCan;
    if (!plugin.error.isEmpty()) missing += Offers::tr("%1: %2").arg(plugin.title, reasonOf(plugin.error));
  }
  for (const Adapter& adapter : list.adapters) hasInterface = hasInterface || adapter.plugin == kSocketCan;
  if (list.plugins.isEmpty() && !isSearching)
    missing += Offers::tr("Qt's CAN plugins are not installed (on Debian they come with libqt6serialbus6).");
  if (hasSocketCan && !hasInterface) {
    offers.nothing = Offers::tr(
        "Linux knows no CAN interface. Plug the adapter in; for most its driver is loaded "
        "by itself, for serial ones by slcand. This lists what there is:");
    offers.command = QStringLiteral("ip -details link show type can");
    missing.prepend(
        Offers::tr("SocketCAN: no CAN interface. Plug the adapter in; if it does not appear, its driver "
                   "is not loaded: look at the end of sudo dmesg."));
  }
  if (!missing.isEmpty()) {
    missing.prepend(Offers::tr("Not usable on this computer now:"));
    offers.missing = missing.join(QLatin1Char('\n'));
  }
  return offers;
}

}  // namespace deckpipe
