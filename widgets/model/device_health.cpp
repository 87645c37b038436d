// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_health.h"

#include <QCoreApplication>

#include "control/request.h"
#include "text/catalogue_text.h"
#include "text/device_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct HealthWords {
  Q_DECLARE_TR_FUNCTIONS(HealthWords)
};

static_assert(kUnansweredAfter ==
                  kRequestFacts[Request::Fault].patience * kRequestFacts[Request::Fault].tries,
              "a log calls a poll unanswered when the console that sent it would");

const QString kComma = QStringLiteral(", ");

QString axesText(const Axes& which) {
  QStringList axes;
  if (which.rotation) axes << HealthWords::tr("rotation");
  if (which.elevation) axes << HealthWords::tr("elevation");
  return axes.join(kComma);
}

QString namesOf(const EnumSet<MessageId>& messages) {
  QStringList names;
  messages.forEach([&](MessageId id) { names << messageName(id); });
  return names.join(kComma);
}

QString agoOf(Instant at, Instant now) {
  const std::optional<Duration> age = ageAt(at, now);
  return age ? agoText(*age) : HealthWords::tr("some time ago");
}

bool hasCode(const Health& health) { return health.faults.errorCode != 0; }

// "No faults, asked 93 s ago, silent since"
QString oldAnswerText(const Health& health, Instant now) {
  QString text = HealthWords::tr("%1, asked %2, %3", "what an old answer said, its age, why it is old")
                     .arg(faultSummary(health.oldFaults.map, health.oldFaults.errorCode),
                          agoOf(health.answered, now), answerAgeText(health.answer));
  return text.replace(0, 1, text.at(0).toUpper());
}

QString sharedText(const Health& health) {
  const QString address = addressText(health.sharedAddress);
  return health.isOnlyEqual ? HealthWords::tr("%1, or the log holds its frames twice").arg(address) : address;
}

QString whatOf(HealthCause cause, const Health& health, Instant now) {
  switch (cause) {
    case HealthCause::Silent:
      if (health.isSinceLinkUp)
        return HealthWords::tr("None of its periodic messages has come since the link came back %1")
            .arg(agoOf(health.since, now));
      return health.since == kNotYet
                 ? HealthWords::tr("None of its periodic messages has come")
                 : HealthWords::tr("Its periodic messages stopped %1").arg(agoOf(health.since, now));
    case HealthCause::Idle:
      if (health.isSinceLinkUp)
        return HealthWords::tr("Not heard since the link came back %1; it may not be on this bus")
            .arg(agoOf(health.since, now));
      return HealthWords::tr("Last heard %1; no periodic message is expected of it")
          .arg(agoOf(health.since, now));
    case HealthCause::LinkDown: return agoOf(health.since, now);
    case HealthCause::FaultsNotAnswered: return agoOf(health.asked, now);
    case HealthCause::TwoAtOneAddress: return sharedText(health);
    case HealthCause::FaultsNamed: return faultSummary(health.faults.map, health.faults.errorCode);
    case HealthCause::SensorError: return axesText(health.sensorError);
    case HealthCause::PositionInvalid: return axesText(health.invalid);
    case HealthCause::OperationalError:
      return hasCode(health) ? pcodeErrorText(health.faults.errorCode)
                             : HealthWords::tr("ask for its faults");
    case HealthCause::Late: return namesOf(health.late);
    case HealthCause::StatusNeverHeard: return namesOf(health.neverHeard);
    case HealthCause::FaultsOld: return oldAnswerText(health, now);
    default: return {};
  }
}

QString wordOf(HealthCause cause, const Health& health) {
  const bool isOfCode =
      cause == HealthCause::OperationalError || (cause == HealthCause::FaultsNamed && health.faults.map == 0);
  return isOfCode && hasCode(health) ? HealthWords::tr("error %1").arg(health.faults.errorCode)
                                     : healthWord(cause);
}

template <typename Take>
void eachCause(const Health& health, Take take) {
  for (const HealthCause cause : kAllOf<HealthCause>) {
    if (health.has(cause)) take(cause);
  }
}

}  // namespace

QString healthWord(const Health& health) {
  return health.isFine() ? healthWord(HealthCause::Count) : wordOf(health.worst(), health);
}

QStringList healthWords(const Health& health) {
  QStringList words;
  eachCause(health, [&](HealthCause cause) { words << wordOf(cause, health); });
  words.removeDuplicates();  // an error code stands for two causes
  if (words.isEmpty()) words << healthWord(HealthCause::Count);
  return words;
}

std::vector<HealthReason> healthReasons(const Health& health, Instant now) {
  std::vector<HealthReason> reasons;
  eachCause(health, [&](HealthCause cause) {
    reasons.push_back({cause, healthSentence(cause, whatOf(cause, health, now))});
  });
  return reasons;
}

QStringList healthSentences(const Health& health, Instant now) {
  QStringList sentences;
  for (const HealthReason& reason : healthReasons(health, now)) sentences << reason.text;
  return sentences;
}

QString faultSummary(std::uint32_t faults, unsigned errorCode) {
  QStringList parts = faultLines(faults);
  if (errorCode != 0) parts << pcodeErrorText(errorCode);
  return parts.isEmpty() ? HealthWords::tr("no faults") : parts.join(kComma);
}

QString noAnswerText(const State& state, const Device& device, std::optional<Request> request, Instant now) {
  if (state.isFiltered() && !(request && device.hasRefused(*request)))
    return HealthWords::tr("not in this log, which was saved through a filter");
  if (request && isUnanswered(device, *request, now))
    return HealthWords::tr("no answer, asked %1").arg(agoText(now - device.askedInVain(*request)));
  if (request && device.askedInVain(*request) != kNotYet) return HealthWords::tr("asked, no answer yet");
  if (request && device.hasRefused(*request))
    return HealthWords::tr("refused, or answered in a wrong length");
  return HealthWords::tr("never asked");
}

QString askedAgainText(const State& state, const Device& device, Request request, Instant now) {
  if (!state.isFiltered() && isUnanswered(device, request, now))
    return HealthWords::tr("asked again %1, no answer").arg(agoText(now - device.askedInVain(request)));
  const bool isOpen = device.askedInVain(request) != kNotYet;
  if (!isOpen && device.hasRefused(request))
    return HealthWords::tr("asked again: refused, or answered in a wrong length");
  return {};
}

QString answerAgeText(AnswerAge age) {
  switch (age) {
    case AnswerAge::Current: break;
    case AnswerAge::BeforeRestart: return HealthWords::tr("restarted since");
    case AnswerAge::BeforeSilence: return HealthWords::tr("silent since");
    case AnswerAge::BeforeLinkDown: return HealthWords::tr("link down since");
    case AnswerAge::BeforeGap: return HealthWords::tr("before the link went down");
  }
  return {};
}

}  // namespace deckpipe
