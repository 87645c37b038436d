// SPDX-License-Identifier: GPL-3.0-or-later
// How a device is (state/health.h), in words with what each cause speaks of: which fault, which axis, since
// when.
#pragma once

#include <QStringList>
#include <optional>

#include "state/health.h"
#include "text/health_text.h"

namespace deckpipe {

// The word of the worst cause: "disabled", "error 11"; "fine" where there is none.
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
