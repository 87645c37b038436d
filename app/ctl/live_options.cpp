// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_options.h"

#include <QSysInfo>
#include <cstdio>
#include <limits>

#include "link/adapters.h"
#include "protocol/address_book.h"
#include "protocol/name.h"

namespace deckpipe::ctl {
namespace {

// The same on every run of this machine, and most likely another on the next one: two consoles of one NAME
// cannot be on one bus.
std::uint32_t identityOfMachine() {
  std::uint32_t hash = 2'166'136'261u;  // FNV-1a
  for (const char c : QByteArray("deckpipectl ") + QSysInfo::machineUniqueId())
    hash = (hash ^ static_cast<std::uint8_t>(c)) * 16'777'619u;
  return (hash ^ hash >> 21) & kLargestIdentity;
}

// addressUse() in words.
QString ownAddressRule() {
  const auto next = [](Address a, int by) { return addressText({static_cast<std::uint8_t>(a.value + by)}); };
  return QStringLiteral(
             "%1 to %2 can be had; %3 to %4 are joysticks' addresses, which monitors obey, and %5 to %6 are "
             "monitors' own: both are refused; others below %5 belong to devices and are had with a warning")
      .arg(next(kLastDynamic, 1), next(kNullAddress, -1), addressText(kFirstJoystick),
           addressText(kLastJoystick), addressText(kFirstDynamic), addressText(kLastDynamic));
}

}  // namespace

std::vector<Arguments::Option> liveOptions() {
  const std::string own = addressText(ClaimSettings{}.preferred).toStdString();
  return {{"plugin", "Qt CAN bus plugin; socketcan by default.", "PLUGIN", "socketcan"},
          {"interface", "Interface of the plugin, e.g. can0.", "NAME"},
          bitRateOption(),
          {"unlock", "Allow sending. Without it nothing is ever sent."},
          {"identity", "Identity number of our NAME, 0 to 2097151; by default this machine's own.", "N",
           std::to_string(identityOfMachine())},
          {"own-address",
           "Address to claim if it is free, in hex; " + own + " by default. " +
               ownAddressRule().toStdString() + '.',
           "HEX", own},
          {"drive", "A Copley drive is at this address, in hex; it is never asked what Akron's are.", "HEX"}};
}

LiveSettings liveSettings(Arguments& arguments, bool sends) {
  LiveSettings settings;
  settings.link.plugin = arguments.text("plugin");
  settings.link.interfaceName = arguments.text("interface");
  settings.link.bitRate = bitRate(arguments);
  settings.claim.identityNumber =
      static_cast<std::uint32_t>(arguments.number("identity", 0, kLargestIdentity));
  settings.claim.preferred = arguments.address("own-address");
  switch (addressUse(settings.claim.preferred)) {
    case AddressUse::Refused:
      arguments.bad(QStringLiteral("--own-address %1 is refused: %2")
                        .arg(arguments.text("own-address"), ownAddressRule()));
      break;
    case AddressUse::Warn:
      std::fprintf(
          stderr,
          "deckpipectl: warning: --own-address %s: fixed addresses below 80 belong to devices, and one of "
          "them may be on this bus\n",
          qPrintable(addressText(settings.claim.preferred)));
      break;
    case AddressUse::Ok: break;
  }
  for (const QString& text : arguments.texts("drive")) {
    const auto drive = parseAddress(text);
    if (!drive) arguments.bad(QStringLiteral("--drive wants an address in hex, 00 to FD"));
    settings.drives.push_back(drive.value_or(kNullAddress));
  }
  settings.unlock = arguments.has("unlock");
  if (const auto trouble = pluginTrouble(settings.link)) arguments.bad(*trouble);
  if (sends && !settings.unlock)
    arguments.bad(QStringLiteral("this sends, and sending is locked; --unlock is the word for it"));
  return settings;
}

Arguments::Option bitRateOption() {
  return {"bitrate", "Bit rate to ask for; 250000 by default, 0 as it is.", "BITS", "250000"};
}

int bitRate(Arguments& arguments) {
  return static_cast<int>(arguments.number("bitrate", 0, std::numeric_limits<int>::max()));
}

QString DeviceName::text() const {
  if (pin) return QString::fromLatin1(pin->text().data(), static_cast<qsizetype>(pin->text().size()));
  if (address) return QStringLiteral("address ") + addressText(*address);
  return QStringLiteral("everyone");
}

std::vector<Arguments::Option> deviceOptions(bool withAll) {
  std::vector<Arguments::Option> options{{"pin", "The device with this PIN, wherever its address is.", "PIN"},
                                         {"address", "The device at this address, in hex.", "HEX"}};
  if (withAll) options.push_back({"all", "Every device heard within two seconds."});
  return options;
}

DeviceName deviceName(Arguments& arguments, bool withAll) {
  const bool hasPin = arguments.has("pin"), hasAddress = arguments.has("address");
  if (hasPin + hasAddress + (withAll && arguments.has("all")) != 1)
    arguments.bad(withAll ? QStringLiteral("one of --pin, --address and --all is wanted")
                          : QStringLiteral("one of --pin and --address is wanted"));
  DeviceName name;
  if (hasPin) {
    name.pin = Pin::parse(arguments.text("pin").toStdString());
    if (!name.pin)
      arguments.bad(QStringLiteral("--pin '%1' is not a PIN of 15 characters").arg(arguments.text("pin")));
  }
  if (hasAddress) name.address = arguments.address("address");
  return name;
}

std::optional<QString> pluginTrouble(const LinkSettings& link) {
  if (const QStringList plugins = installedPlugins(); !plugins.contains(link.plugin))
    return QStringLiteral("no such plugin: '%1'; installed are %2")
        .arg(link.plugin, plugins.join(QStringLiteral(", ")));
  if (link.interfaceName.isEmpty()) return QStringLiteral("an --interface is wanted");
  return {};
}

}  // namespace deckpipe::ctl
