// SPDX-License-Identifier: GPL-3.0-or-later
// The options that every subcommand on a live interface has: where to connect, who to be there, and the one
// word that allows sending. And those that name a device.
#pragma once

#include <QCommandLineParser>
#include <optional>
#include <vector>

#include "base/ids.h"
#include "link/can_link.h"
#include "service/claim_service.h"

namespace deckpipe::ctl {

struct LiveSettings {
  LinkSettings link;
  ClaimSettings claim;
  std::vector<Address> drives;
  bool unlock = false;
};

class LiveOptions {
 public:
  explicit LiveOptions(QCommandLineParser& parser);
  // Nothing where they are unusable, which has been said then. `sends`: it cannot do without --unlock.
  std::optional<LiveSettings> read(const QString& command, bool sends) const;

 private:
  QCommandLineParser& m_parser;
  QCommandLineOption m_plugin, m_interface, m_bitRate, m_unlock, m_identity, m_ownAddress, m_drive;
};

// Exactly one of them, or everyone.
struct DeviceName {
  std::optional<Pin> pin;
  std::optional<Address> address;
  // "1032AE100801035", "address 80"
  QString text() const;
};

class DeviceOptions {
 public:
  // `all`: --all is one of them.
  DeviceOptions(QCommandLineParser& parser, bool all);
  // Nothing where they are unusable, which has been said then; empty for --all.
  std::optional<DeviceName> read(const QString& command) const;

 private:
  QCommandLineParser& m_parser;
  QCommandLineOption m_pin, m_address, m_all;
  bool m_withAll;
};

// Why there cannot be a link of these settings, as the end of a sentence; nothing if there may be one. It
// opens nothing, and it does not look for the interface.
std::optional<QString> pluginTrouble(const LinkSettings& link);

// A number of seconds above 0; nothing where it is none.
std::optional<double> parseSeconds(const QString& text);

}  // namespace deckpipe::ctl
