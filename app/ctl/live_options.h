// SPDX-License-Identifier: GPL-3.0-or-later
// The options that every subcommand on a live interface has: where to connect, who to be there, and the one
// word that allows sending. And those that name a device.
#pragma once

#include <optional>
#include <vector>

#include "arguments.h"
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

std::vector<Arguments::Option> liveOptions();
// `sends`: the subcommand cannot do without --unlock.
LiveSettings liveSettings(Arguments& arguments, bool sends);

// --bitrate: bits a second, 250000 by default; 0 leaves it as it is.
Arguments::Option bitRateOption();
int bitRate(Arguments& arguments);

// Exactly one of them, or everyone.
struct DeviceName {
  std::optional<Pin> pin;
  std::optional<Address> address;
  // "1032AE100801035", "address 80"
  QString text() const;
};

// `withAll`: --all is one of them, and gives an empty name.
std::vector<Arguments::Option> deviceOptions(bool withAll);
DeviceName deviceName(Arguments& arguments, bool withAll);

// Why there cannot be a link of these settings, as the end of a sentence; nothing if there may be one. It
// opens nothing, and it does not look for the interface.
std::optional<QString> pluginTrouble(const LinkSettings& link);

}  // namespace deckpipe::ctl
