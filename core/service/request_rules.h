// SPDX-License-Identifier: GPL-3.0-or-later
// What the services need to ask an Akron device something: how it is asked (control/ask.h) and with which
// messages (the catalogue), in one row; and who takes it.
#pragma once

#include <array>
#include <vector>

#include "control/request.h"
#include "control/status.h"
#include "protocol/lists.h"
#include "service/service.h"

namespace deckpipe {

struct RequestRule {
  MessageId request = MessageId::Count;
  std::array<MessageId, kMaxAnswers> answers{};  // all of them make the answer; Count = none
  Duration patience{};                           // of one try
  unsigned tries = 1;
};

inline constexpr MessageId kNoAnswer = MessageId::Count;
inline constexpr EnumArray<Request, RequestRule> kRequestRules = [] {
  EnumArray<Request, RequestRule> rules;
  for (const Request request : kAllOf<Request>)
    rules[request] = {requestOf(request), answersOf(request), kRequestFacts[request].patience,
                      kRequestFacts[request].tries};
  return rules;
}();

// All answers that a rule wants, as bits.
constexpr unsigned wholeAnswer(const RequestRule& rule) { return rule.answers[1] == kNoAnswer ? 1u : 3u; }

constexpr const RequestRule& ruleOf(Request request) { return kRequestRules[request]; }

// What may be asked of a device by its type; of one without a PIN only what all take is known. Nothing of one
// that the person said is a Copley drive, nor of another maker's: their messages look the same. Behind a gap nothing of
// one that was not heard anew, nor where another maker's was, until it is heard who is there now.
RequestSet requestsTakenBy(const Live& live, const Device& device);
// Everyone on this channel that takes something, in order of first appearance.
std::vector<DeviceKey> requestTargets(const Live& live);
// The entry of a device in the whole, made where there was none.
DeviceServices& statusOf(const Live& live, const DeviceKey& device, ServiceStatus& in);

}  // namespace deckpipe
