// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_details.h"

#include <QCoreApplication>
#include <QStringList>

#include "control/request.h"
#include "model/device_rows.h"
#include "text/catalogue_text.h"
#include "text/device_text.h"
#include "text/j1939_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct Details {
  Q_DECLARE_TR_FUNCTIONS(Details)
};

}  // namespace

QString channelText(const LogView& view, Channel channel) {
  if (view.document == nullptr || view.document->frames.channelCount() < 2) return {};
  const std::string_view name = view.document->frames.channelName(channel.value);
  return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

QString addressNow(const State& state, const Device& d) {
  const std::optional<Duration> age = ageAt(d.addressSince, state.cursor().time);
  if (d.address == kNullAddress) {
    if (d.previousAddress() == kNullAddress) return Details::tr("none");
    const QString before = addressText(d.previousAddress());
    return age ? Details::tr("lost %1, it was %2").arg(agoText(*age), before)
               : Details::tr("lost, it was %1").arg(before);
  }
  const QString address = addressText(d.address);
  return age ? Details::tr("%1 for %2").arg(address, briefAge(*age)) : address;
}

QStringList addressesBefore(const State& state, const Device& d) {
  QStringList lines;
  int listed = 0;
  for (const FormerAddress& former : d.formerAddresses) {
    if (former.address == kNullAddress) continue;
    ++listed;
    // The one that it lost is said where the present one would stand.
    if (listed == 1 && d.address == kNullAddress) continue;
    const QString address = addressText(former.address);
    const std::optional<Duration> age = ageAt(former.until, state.cursor().time);
    lines << (age ? Details::tr("%1 until %2").arg(address, agoText(*age)) : address);
  }
  const int all = d.addressChanges + (d.address == kNullAddress ? 1 : 0);
  if (all > listed) lines << Details::tr("and %n earlier", nullptr, all - listed);
  return lines;
}

std::string_view claimKey(ClaimState claim) {
  switch (claim) {
    case ClaimState::NoClaim: return "no_claim";
    case ClaimState::Claiming: return "claiming";
    case ClaimState::Claimed: return "claimed";
    case ClaimState::Contested: return "contested";
    case ClaimState::CannotClaim: return "cannot_claim";
  }
  return {};
}

QString contestText(const AddressBook& book, Address address) {
  const int won = book.claimsWon(address), lost = book.claimsLost(address);
  if (won == 0 && lost == 0) return {};
  return Details::tr("%1 won, %2 lost").arg(won).arg(lost);
}

QString detailsText(const LogView& view, const DeviceKey& key, const DeviceLabels& labels) {
  if (view.state == nullptr) return {};
  const State& state = *view.state;
  const std::optional<DeviceRow> row = deviceRow(state, key);
  if (!row) return {};
  const Device* device = findDevice(state, key);
  QStringList lines{
      Details::tr("%1 – %2", "device and its type").arg(nameText(*row, labels), typeText(*row))};
  if (const QString former = formerText(*row, labels); !former.isEmpty())
    lines << Details::tr("PIN: %1").arg(former);
  if (const QString channel = channelText(view, row->channel); !channel.isEmpty())
    lines << Details::tr("Channel: %1").arg(channel);
  if (device != nullptr && device->kind != Device::Kind::Node) {
    lines << Details::tr("Address: %1").arg(addressNow(state, *device));
    for (const QString& before : addressesBefore(state, *device))
      lines << Details::tr("Before: %1").arg(before);
  }
  if (row->age) lines << Details::tr("Last heard: %1").arg(agoText(*row->age));
  for (const HealthReason& reason : healthReasons(row->health, state.cursor().time))
    lines << reason.text << QStringLiteral("    ") + healthAdvice(reason.cause);
  const ChannelState& channel = state.channel(row->channel);
  if (const Joystick* stick = channel.joysticks.find(row->address); stick != nullptr && stick->priority())
    lines << Details::tr("Joystick priority: %1").arg(priorityText(*stick->priority()));
  if (row->address == kNullAddress) return lines.join(QLatin1Char('\n'));

  if (const QString use = reservedUse(row->address); !use.isEmpty())
    lines << Details::tr("J1939 keeps this address for: %1").arg(use);
  if (const QString use = usualUse(row->address); !use.isEmpty())
    lines << Details::tr("By J1939 this address is %1, which is no proof").arg(use);
  if (const QString contests = contestText(channel.book, row->address); !contests.isEmpty())
    lines << Details::tr("Contests for the address: %1").arg(contests);
  lines << Details::tr("Claim: %1")
               .arg(wordText(claimKey(channel.book.claim(row->address, state.cursor().time))));
  const Name former = channel.book.formerHolder(row->address);
  if (!former.isNull()) lines << Details::tr("Before the link went down:");
  const Name name = former.isNull() ? channel.book.lastHolder(row->address) : former;
  if (!name.isNull()) {
    lines
        << Details::tr("NAME %1 hex").arg(QString::number(name.value, 16).toUpper().rightJustified(16, u'0'));
    for (const QString& line : nameLines(name)) lines << QStringLiteral("    ") + line;
  }
  return lines.join(QLatin1Char('\n'));
}

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

// "No faults, asked 93 s ago, restarted since". That it is silent a cause of its own says.
QString oldAnswerText(const Health& health, Instant now) {
  const bool isSaid = health.answer == AnswerAge::BeforeSilence && health.has(HealthCause::Silent);
  const QString said = faultSummary(health.oldFaults.map, health.oldFaults.errorCode);
  const QString ago = agoOf(health.answered, now);
  QString text = isSaid
                     ? HealthWords::tr("%1, asked %2", "what an old answer said, its age").arg(said, ago)
                     : HealthWords::tr("%1, asked %2, %3", "what an old answer said, its age, why it is old")
                           .arg(said, ago, answerAgeText(health.answer));
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
  // Beside any other cause it goes without saying that one is heard.
  const bool isHeardAlone = health.worst() == HealthCause::CannotBeAsked;
  eachCause(health, [&](HealthCause cause) {
    if (cause != HealthCause::CannotBeAsked || isHeardAlone) words << wordOf(cause, health);
  });
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
