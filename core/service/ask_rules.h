// SPDX-License-Identifier: GPL-3.0-or-later
// How each thing that can be asked of an Akron device is asked and answered, and who takes it. Source: CAN
// Messaging manual, message types 02-05, 21, 22, 41, 45, 46; deadlines are Deckpipe's own.
#pragma once

#include <array>
#include <vector>

#include "control/ask.h"
#include "control/status.h"
#include "protocol/catalogue.h"
#include "service/live.h"

namespace deckpipe {

struct AskRule {
  MessageId request;
  std::array<MessageId, 2> answers;  // all of them make the answer; Count = none
  Duration patience;                 // of one try
  unsigned tries;                    // commands are never repeated by themselves
  std::array<unsigned, 4> takenBy;   // PIN digits 1-4; all 0: every Akron device
};

inline constexpr MessageId kNoAnswer = MessageId::Count;
inline constexpr std::array<AskRule, kAsks> kAskRules{{
    {MessageId::FaultPoll, {MessageId::FaultResponse, kNoAnswer}, 500ms, 3, {}},
    {MessageId::FirmwarePoll, {MessageId::FirmwareResponse, kNoAnswer}, 500ms, 3, {}},
    {MessageId::PcodePoll, {MessageId::PcodeResponse, kNoAnswer}, 500ms, 3, {}},
    {MessageId::ConfigPoll, {MessageId::ConfigResponse, kNoAnswer}, 500ms, 3, {}},
    {MessageId::VistaPoll, {MessageId::VistaStatus, MessageId::VistaPosition}, 500ms, 3, {1032}},
    {MessageId::ZeroAxesRequest, {MessageId::ZeroAxesAck, kNoAnswer}, 1s, 1, {1032}},
    {MessageId::ResetRequest, {MessageId::AddressAnnouncement, kNoAnswer}, 10s, 1, {1032, 1040, 1042, 1052}},
    {MessageId::SetupModeRequest, {MessageId::SetupModeAck, kNoAnswer}, 1s, 1, {1032, 1040, 1042, 1052}},
}};

// All answers that a rule wants, as bits.
constexpr unsigned wholeAnswer(const AskRule& rule) { return rule.answers[1] == kNoAnswer ? 1u : 3u; }

constexpr const AskRule& ruleOf(Ask ask) { return kAskRules[static_cast<std::size_t>(ask)]; }

// What may be asked of a device by its type; of one without a PIN only what all take is known. Nothing of one
// that the person said is a Copley drive, whose messages look the same.
AskSet asksTakenBy(const Live& live, const Device& device);
// Everyone on this channel that takes something, in order of first appearance.
std::vector<DeviceKey> askableDevices(const Live& live);
// The entry of a device in the whole, made where there was none.
DeviceServices& statusOf(const Live& live, const DeviceKey& device, ServiceStatus& in);

}  // namespace deckpipe
