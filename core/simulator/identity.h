// SPDX-License-Identifier: GPL-3.0-or-later
// Who a device of the simulator is: NAME, PIN and the versions it answers polls with (messages 60928, FF,
// 03, 04, 05 of the CAN Messaging manual).
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/encode.h"
#include "protocol/lists.h"
#include "protocol/typed.h"

namespace deckpipe::simulator {

struct Identity {
  Name name;
  std::string model;       // as the manual calls it, for people on the pipe
  std::optional<Pin> pin;  // nothing: the device cannot announce itself (6039)
  FirmwareVersions firmware{0x010B, 0x0204, 0x0206};
  PcodeVersion pcode;
  ConfigVersion config;
};

// A NAME of Akron's as the manual's example has it: function 66, industry group 1, arbitrary address capable.
Name akronName(std::uint32_t identityNumber);
// With the NAME that belongs to this PIN. `pin` must be a PIN.
Identity identityOf(std::string_view pin, PcodeVersion pcode, ConfigVersion config);

// The data of a message whose values are ours, so that failing to encode is a bug of ours.
Encoded encoded(MessageId id, std::initializer_list<FieldValue> values = {});

Frame nameFrame(Name name, Address source);
Frame announcementFrame(const Pin& pin, Address source);

}  // namespace deckpipe::simulator
