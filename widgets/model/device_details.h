// SPDX-License-Identifier: GPL-3.0-or-later
// One device in words: how it is, and what a tooltip of the device table tells of it.
#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <string_view>

#include "base/ids.h"
#include "model/device_labels.h"
#include "state/health.h"
#include "state/log_view.h"
#include "text/health_text.h"

namespace deckpipe {

// "can0"; empty where the log has one channel only, for then there is nothing to tell apart.
QString channelText(const LogView& view, Channel channel);
// "80 hex for 12 s"; "lost 3 s ago, it was 80 hex"
QString addressNow(const State& state, const Device& device);
// The addresses before, the latest first: "81 hex until 12 s ago". Empty where there were none.
QStringList addressesBefore(const State& state, const Device& device);
// The key of the word for a claim (text/catalogue_text.h).
std::string_view claimKey(ClaimState claim);
// "2 won, 1 lost"; empty where there were none.
QString contestText(const AddressBook& book, Address address);

QString detailsText(const LogView& view, const DeviceKey& key, const DeviceLabels& labels = {});

// Of its health (state/health.h) the word of the worst cause: "disabled", "error 11"; "fine" where there is none.
QString healthWord(const Health& health);
// The words of all causes, the worst first; "fine" alone where there is none.
QStringList healthWords(const Health& health);
struct HealthReason {
  HealthCause cause = HealthCause::Count;
  QString text;  // a sentence
};
// All causes, the worst first; none of a device that is fine.
std::vector<HealthReason> healthReasons(const Health& health, Instant now);
QStringList healthSentences(const Health& health, Instant now);

// What a fault answer said: "no faults", "internal fuse, error 11".
QString faultSummary(std::uint32_t faults, unsigned errorCode);
// Why there is no answer of what was asked or not: "no answer, asked 2 s ago", "asked, no answer yet",
// "refused, or answered in a wrong length", "never asked". `ask` is nothing where Deckpipe has no poll for
// it.
QString noAnswerText(const State& state, const Device& device, std::optional<Request> request, Instant now);
// What came of the last asking where an earlier answer is shown; empty if that is the last one's, or is
// awaited.
QString askedAgainText(const State& state, const Device& device, Request request, Instant now);
// "restarted since", "silent since", "link down since", "before the link went down"; empty for an answer that still
// holds.
QString answerAgeText(AnswerAge age);

}  // namespace deckpipe
