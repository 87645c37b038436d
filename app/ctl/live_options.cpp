// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_options.h"

#include <QSysInfo>
#include <cstdio>

#include "arguments.h"
#include "link/plugins.h"
#include "protocol/address_use.h"
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

std::optional<Address> parseAddress(const QString& text) {
  bool ok = false;
  const uint value = text.toUInt(&ok, 16);
  if (!ok || value > 0xFD) return {};
  return Address{static_cast<std::uint8_t>(value)};
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

LiveOptions::LiveOptions(QCommandLineParser& parser)
    : m_parser(parser),
      m_plugin(QStringLiteral("plugin"), QStringLiteral("Qt CAN bus plugin; socketcan by default."),
               QStringLiteral("PLUGIN"), QStringLiteral("socketcan")),
      m_interface(QStringLiteral("interface"), QStringLiteral("Interface of the plugin, e.g. can0."),
                  QStringLiteral("NAME")),
      m_bitRate(QStringLiteral("bitrate"),
                QStringLiteral("Bit rate to ask for; 250000 by default, 0 as it is."), QStringLiteral("BITS"),
                QStringLiteral("250000")),
      m_unlock(QStringLiteral("unlock"), QStringLiteral("Allow sending. Without it nothing is ever sent.")),
      m_identity(QStringLiteral("identity"),
                 QStringLiteral("Identity number of our NAME, 0 to 2097151; by default this machine's own."),
                 QStringLiteral("N")),
      m_ownAddress(QStringLiteral("own-address"),
                   QStringLiteral("Address to claim if it is free, in hex; %1 by default. %2.")
                       .arg(addressText(ClaimSettings{}.preferred), ownAddressRule()),
                   QStringLiteral("HEX"), addressText(ClaimSettings{}.preferred)),
      m_drive(
          QStringLiteral("drive"),
          QStringLiteral("A Copley drive is at this address, in hex; it is never asked what Akron's are."),
          QStringLiteral("HEX")) {
  parser.addOptions({m_plugin, m_interface, m_bitRate, m_unlock, m_identity, m_ownAddress, m_drive});
}

std::optional<LiveSettings> LiveOptions::read(const QString& command, bool sends) const {
  const auto bad = [&](const QString& message) {
    badUsage(command + QStringLiteral(": ") + message);
    return std::nullopt;
  };
  LiveSettings settings;
  bool ok = false;
  settings.link.plugin = m_parser.value(m_plugin);
  settings.link.interfaceName = m_parser.value(m_interface);
  settings.link.bitRate = m_parser.value(m_bitRate).toInt(&ok);
  if (!ok || settings.link.bitRate < 0) return bad(QStringLiteral("--bitrate wants bits a second"));
  settings.claim.identityNumber = identityOfMachine();
  if (m_parser.isSet(m_identity)) {
    settings.claim.identityNumber = m_parser.value(m_identity).toUInt(&ok);
    if (!ok || settings.claim.identityNumber > kLargestIdentity)
      return bad(QStringLiteral("--identity wants a number from 0 to %1").arg(kLargestIdentity));
  }
  const auto preferred = parseAddress(m_parser.value(m_ownAddress));
  const AddressUse use = preferred ? addressUse(*preferred) : AddressUse::Refused;
  switch (use) {
    case AddressUse::Refused:
      return bad(QStringLiteral("--own-address %1 is refused: %2")
                     .arg(m_parser.value(m_ownAddress), ownAddressRule()));
    case AddressUse::Warn:
      std::fprintf(
          stderr,
          "deckpipectl: warning: --own-address %s: fixed addresses below 80 belong to devices, and one of "
          "them may be on this bus\n",
          qPrintable(addressText(*preferred)));
      break;
    case AddressUse::Ok: break;
  }
  settings.claim.preferred = *preferred;
  for (const QString& text : m_parser.values(m_drive)) {
    const auto drive = parseAddress(text);
    if (!drive) return bad(QStringLiteral("--drive wants an address in hex, 00 to FD"));
    settings.drives.push_back(*drive);
  }
  settings.unlock = m_parser.isSet(m_unlock);
  if (const auto trouble = pluginTrouble(settings.link)) return bad(*trouble);
  if (sends && !settings.unlock)
    return bad(QStringLiteral("this sends, and sending is locked; --unlock is the word for it"));
  return settings;
}

QString DeviceName::text() const {
  if (pin) return QString::fromLatin1(pin->text().data(), static_cast<qsizetype>(pin->text().size()));
  if (address) return QStringLiteral("address ") + addressText(*address);
  return QStringLiteral("everyone");
}

DeviceOptions::DeviceOptions(QCommandLineParser& parser, bool all)
    : m_parser(parser),
      m_pin(QStringLiteral("pin"), QStringLiteral("The device with this PIN, wherever its address is."),
            QStringLiteral("PIN")),
      m_address(QStringLiteral("address"), QStringLiteral("The device at this address, in hex."),
                QStringLiteral("HEX")),
      m_all(QStringLiteral("all"), QStringLiteral("Every device heard within two seconds.")),
      m_withAll(all) {
  parser.addOptions({m_pin, m_address});
  if (all) parser.addOption(m_all);
}

std::optional<DeviceName> DeviceOptions::read(const QString& command) const {
  const auto bad = [&](const QString& message) {
    badUsage(command + QStringLiteral(": ") + message);
    return std::nullopt;
  };
  const bool all = m_withAll && m_parser.isSet(m_all);
  if (m_parser.isSet(m_pin) + m_parser.isSet(m_address) + all != 1)
    return bad(m_withAll ? QStringLiteral("one of --pin, --address and --all is wanted")
                         : QStringLiteral("one of --pin and --address is wanted"));
  DeviceName name;
  if (m_parser.isSet(m_pin)) {
    name.pin = Pin::parse(m_parser.value(m_pin).toStdString());
    if (!name.pin)
      return bad(QStringLiteral("--pin '%1' is not a PIN of 15 characters").arg(m_parser.value(m_pin)));
  }
  if (m_parser.isSet(m_address)) {
    name.address = parseAddress(m_parser.value(m_address));
    if (!name.address) return bad(QStringLiteral("--address wants an address in hex, 00 to FD"));
  }
  return name;
}

std::optional<QString> pluginTrouble(const LinkSettings& link) {
  if (const QStringList plugins = installedPlugins(); !plugins.contains(link.plugin))
    return QStringLiteral("no such plugin: '%1'; installed are %2")
        .arg(link.plugin, plugins.join(QStringLiteral(", ")));
  if (link.interfaceName.isEmpty()) return QStringLiteral("an --interface is wanted");
  return {};
}

std::optional<double> parseSeconds(const QString& text) {
  bool ok = false;
  const double seconds = text.toDouble(&ok);
  return ok && seconds > 0 && seconds <= 1e6 ? std::optional(seconds) : std::nullopt;
}

}  // namespace deckpipe::ctl
