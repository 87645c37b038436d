// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/poll_answers.h"

#include <algorithm>

namespace deckpipe::simulator {
namespace {

constexpr std::uint8_t kShortFaultLength = 5;

Encoded faultAnswer(const FaultReport& faults) {
  Encoded data = encoded(MessageId::FaultResponse, {{"faults", Value::numbers(faults.map)},
                                                    {"pcode_error", Value::integer(faults.pcodeError)}});
  if (faults.isShort) {
    data.length = kShortFaultLength;
    std::fill(data.data.begin() + kShortFaultLength, data.data.end(), std::uint8_t{0});
  }
  return data;
}

}  // namespace

std::optional<PollAnswer> pollAnswer(std::uint8_t type, const Identity& identity, const FaultReport& faults) {
  const auto isPoll = [&](MessageId poll) { return type == typeOf(poll); };
  if (isPoll(MessageId::FaultPoll)) return PollAnswer{MessageId::FaultResponse, faultAnswer(faults)};
  if (isPoll(MessageId::FirmwarePoll)) {
    const FirmwareVersions& v = identity.firmware;
    return PollAnswer{MessageId::FirmwareResponse,
                      encoded(MessageId::FirmwareResponse, {{"fixed_boot", versionValue(v.fixedBoot)},
                                                            {"bootloader", versionValue(v.bootloader)},
                                                            {"system", versionValue(v.system)}})};
  }
  if (isPoll(MessageId::PcodePoll)) {
    const PcodeVersion& v = identity.pcode;
    return PollAnswer{MessageId::PcodeResponse,
                      encoded(MessageId::PcodeResponse, {{"style", Value::integer(v.style)},
                                                         {"subtype", Value::integer(v.subtype)},
                                                         {"version", versionValue(v.version)}})};
  }
  if (isPoll(MessageId::ConfigPoll)) {
    const ConfigVersion& v = identity.config;
    return PollAnswer{MessageId::ConfigResponse,
                      encoded(MessageId::ConfigResponse, {{"config_type", Value::integer(v.type)},
                                                          {"version", versionValue(v.version)}})};
  }
  return {};
}

}  // namespace deckpipe::simulator
