// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_parts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "model/device_details.h"
#include "model/page_sources.h"
#include "protocol/gateway.h"
#include "state/current.h"
#include "text/catalogue_text.h"
#include "text/device_text.h"
#include "text/j1939_text.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

struct Facts {
  Q_DECLARE_TR_FUNCTIONS(Facts)
};

// What a device answered, drawn by whether that still holds, and whether it was asked in vain since.
class Answers {
 public:
  Answers(const State& state, const Device& device)
      : m_state(state), m_device(device), m_now(state.cursor().time) {}

  // `answer` is a Timed or a Reported of the device. `ask`: the poll for it; nothing where Deckpipe has none.
  PageFact fact(const QString& label, const auto& answer, std::optional<Request> request,
                const QString& value, Severity tone = Severity::Plain) const {
    const QString again = request ? askedAgainText(m_state, m_device, *request, m_now) : QString();
    if (!answer.isKnown())
      return {label,
              noAnswerText(m_state, m_device, request, m_now),
              again.isEmpty() ? Severity::Unknown : Severity::Warning,
              {}};
    const AnswerAge age = ageOfAnswer(m_state, m_device, answer.at);
    if (age != AnswerAge::Current) {
      const QString old = Facts::tr("%1\nasked %2, %3", "an old answer, its age, why it is old")
                              .arg(value, agoText(m_now - answer.at), answerAgeText(age));
      return {label, withLine(old, again), Severity::Unknown, {}};
    }
    return {label, withLine(value, again), again.isEmpty() ? tone : Severity::Warning,
            ageAt(answer.at, m_now)};
  }

 private:
  static QString withLine(const QString& value, const QString& line) {
    return line.isEmpty() ? value : value + QLatin1Char('\n') + line;
  }

  const State& m_state;
  const Device& m_device;
  Instant m_now;
};

PageFact plain(const QString& label, const QString& value, Severity tone = Severity::Plain) {
  return {label, value, tone, {}};
}

// Controllers want a joystick message at least so often (CAN Messaging manual, Appendix B).
constexpr Duration kLongestPeriod = 100ms;

QString countText(std::uint32_t n) { return QLocale().toString(n); }

QString framesText(std::uint32_t all, Instant heard, const FrameRate& rate, Instant now) {
  if (!ageAt(heard, now)) return countText(all);
  return Facts::tr("%1, now %2 a second", "a count and a rate")
      .arg(countText(all), countText(rate.at(now, heard)));
}

QString heartbeatText(std::uint8_t state) {
  for (const ValueName& word : gateway::kHeartbeatStates) {
    if (word.value == state) return wordText(word.word);
  }
  return Facts::tr("unknown state %1 hex").arg(hexText(state));
}

}  // namespace

PageFactGroup faultsOf(const State& state, const Device& d) {
  PageFactGroup group{pageGroupKey(PageGroup::Faults), Facts::tr("Faults"), {}};
  const Answers answers(state, d);
  const FaultStatus faults = d.faults().value();
  const QStringList lines = faultLines(faults.map);
  group.facts.push_back(answers.fact(Facts::tr("Fault bits"), d.faults(), Request::Fault,
                                     lines.isEmpty() ? Facts::tr("none set") : lines.join(QLatin1Char('\n')),
                                     lines.isEmpty() ? Severity::Fine : Severity::Fault));
  const auto errorOf = [](unsigned code) { return code == 0 ? Facts::tr("none") : pcodeErrorText(code); };
  const auto toneOfError = [](unsigned code) { return code == 0 ? Severity::Fine : Severity::Fault; };
  if (d.kind == Device::Kind::Node) {
    const unsigned code = d.operationalErrorCode.value;
    group.facts.push_back(answers.fact(Facts::tr("Operational error"), d.operationalErrorCode, {},
                                       errorOf(code), toneOfError(code)));
    return group;
  }
  const QString label = Facts::tr("pCode error");
  if (d.faults().isKnown() && !faults.pcodeError) {
    group.facts.push_back(
        plain(label, Facts::tr("not in the short answer of older firmware"), Severity::Unknown));
  } else {
    const unsigned code = faults.pcodeError.value_or(0);
    group.facts.push_back(answers.fact(label, d.faults(), Request::Fault, errorOf(code), toneOfError(code)));
  }
  return group;
}

PageFactGroup versionsOf(const State& state, const Device& d) {
  PageFactGroup group{pageGroupKey(PageGroup::Versions), Facts::tr("Versions"), {}};
  const Answers answers(state, d);
  if (d.kind == Device::Kind::Node) {
    group.facts.push_back(
        answers.fact(Facts::tr("Part number"), d.partNumber, {}, partText(d.partNumber.value)));
    return group;
  }
  const FirmwareVersions f = d.firmware().value();
  group.facts.push_back(
      answers.fact(Facts::tr("Firmware"), d.firmware(), Request::Firmware,
                   Facts::tr("system %1, bootloader %2, fixed boot %3")
                       .arg(versionText(f.system), versionText(f.bootloader), versionText(f.fixedBoot))));
  const PcodeVersion p = d.pcode().value();
  group.facts.push_back(
      answers.fact(Facts::tr("pCode"), d.pcode(), Request::Pcode,
                   Facts::tr("version %1\nstyle %2\nsubtype %3")
                       .arg(versionText(p.version), styleText(p.style), subtypeText(p.subtype))));
  const ConfigVersion c = d.config().value();
  group.facts.push_back(
      answers.fact(Facts::tr("Configuration"), d.config(), Request::Config,
                   Facts::tr("version %1\npart %2").arg(versionText(c.version), partText(c.type))));
  return group;
}

PageFactGroup nodeOf(const State& bus, const Device& d) {
  const Instant now = bus.cursor().time;
  PageFactGroup group{pageGroupKey(PageGroup::Node), Facts::tr("CANopen node"), {}};
  PageFact state = plain(Facts::tr("NMT state"), heartbeatText(d.heartbeat().value()));
  const bool isOperational = d.heartbeat().value() == gateway::kOperational;
  if (!d.heartbeat().isKnown()) {
    state.value = Facts::tr("no heartbeat heard");
    state.tone = Severity::Unknown;
  } else if (isCutOff(bus, d.channel, d.heartbeat().at)) {
    state.value = Facts::tr("%1, before the link went down").arg(state.value);
    state.tone = Severity::Unknown;
  } else if (d.isStale(MessageId::Heartbeat)) {
    state.value = (bus.isFiltered() ? Facts::tr("%1, the last in this log, which was saved through a filter")
                                    : Facts::tr("%1, overdue"))
                      .arg(state.value);
    state.tone = Severity::Unknown;
  } else {
    state.tone = isOperational ? Severity::Fine : Severity::Warning;
  }
  state.age = ageAt(d.heartbeat().at, now);
  group.facts = {state, plain(Facts::tr("Frames"), framesText(d.frames, d.lastHeard, d.rate, now))};
  if (d.malformed != 0)
    group.facts.push_back(plain(Facts::tr("Of a wrong length"), countText(d.malformed), Severity::Warning));
  return group;
}

PageFactGroup joystickOf(const State& state, Channel channel, const Joystick& stick) {
  const Instant now = state.cursor().time;
  PageFactGroup group{pageGroupKey(PageGroup::Joystick), Facts::tr("Joystick messages"), {}};
  auto& facts = group.facts;
  facts.push_back(plain(Facts::tr("Source"), addressText(stick.source)));
  facts.push_back(stick.priority()
                      ? plain(Facts::tr("Priority"), priorityText(*stick.priority()))
                      : plain(Facts::tr("Priority"), Facts::tr("none: monitors listen to 33 to 38 hex"),
                              Severity::Warning));
  if (!stick.isUnderstood()) {
    facts.push_back(plain(Facts::tr("Sending"),
                          Facts::tr("messages of a wrong length only; monitors take no input from them"),
                          Severity::Warning));
    return group;
  }
  // Without times nothing is known of its rhythm.
  if (!ageAt(std::max(stick.basic.at, stick.extended.at), now)) return group;
  if (isLinkDown(state, channel)) {
    facts.push_back({Facts::tr("Sending"), Facts::tr("not known, the link is down"), Severity::Unknown,
                     ageAt(stick.basic.at, now)});
  } else if (state.isFiltered()) {
    facts.push_back({Facts::tr("Sending"), Facts::tr("not known, the log was saved through a filter"),
                     Severity::Unknown, ageAt(stick.basic.at, now)});
    return group;
  } else if (state.channel(channel).isBeforeGap(std::max(stick.basic.at, stick.extended.at))) {
    facts.push_back({Facts::tr("Sending"), Facts::tr("not heard since the link came back"), Severity::Unknown,
                     ageAt(stick.basic.at, now)});
  } else if (stick.timedOut) {
    facts.push_back({Facts::tr("Sending"), Facts::tr("stopped; monitors forgot its input"), Severity::Unknown,
                     ageAt(stick.basic.at, now)});
  } else {
    facts.push_back(plain(Facts::tr("Sending"), stick.isActive()
                                                    ? Facts::tr("every %1").arg(periodText(stick.period))
                                                    : Facts::tr("extended messages only")));
  }
  const bool isLate = stick.worstGap > kLongestPeriod;
  facts.push_back(plain(
      Facts::tr("Worst gap"),
      isLate ? Facts::tr("%1, more than 100 ms").arg(periodText(stick.worstGap)) : periodText(stick.worstGap),
      isLate ? Severity::Warning : Severity::Plain));
  facts.push_back(plain(Facts::tr("Time-outs"), countText(stick.timeouts),
                        stick.timeouts != 0 ? Severity::Warning : Severity::Plain));
  return group;
}

PageFactGroup addressOf(const State& state, Channel channelId, Address address, const Device* device) {
  PageFactGroup group{pageGroupKey(PageGroup::Address), Facts::tr("Address and NAME"), {}};
  auto& facts = group.facts;
  const bool isLost = address == kNullAddress;
  facts.push_back(plain(Facts::tr("Address"),
                        device != nullptr ? addressNow(state, *device) : addressText(address),
                        isLost ? Severity::Warning : Severity::Plain));
  if (device != nullptr) {
    if (const QStringList before = addressesBefore(state, *device); !before.isEmpty())
      facts.push_back(plain(Facts::tr("Before"), before.join(QLatin1Char('\n'))));
  }
  if (isLost) return group;
  if (const QString use = reservedUse(address); !use.isEmpty())
    facts.push_back(plain(Facts::tr("Kept for"), use));
  if (const QString use = usualUse(address); !use.isEmpty())
    facts.push_back(plain(Facts::tr("By J1939"), Facts::tr("%1, which is no proof").arg(use)));
  if (state.channel(channelId).book.isDrive(address))
    facts.push_back(plain(Facts::tr("Taken for"), Facts::tr("a Copley drive, because a person said so")));
  const AddressBook& book = state.channel(channelId).book;
  const ClaimState claim = book.claim(address, state.cursor().time);
  const bool isOpen = claim == ClaimState::Contested || claim == ClaimState::CannotClaim;
  facts.push_back(
      plain(Facts::tr("Claim"), wordText(claimKey(claim)), isOpen ? Severity::Warning : Severity::Plain));
  if (const QString contests = contestText(book, address); !contests.isEmpty())
    facts.push_back(plain(Facts::tr("Contests"), contests, Severity::Warning));
  if (const Name name = book.lastHolder(address); !name.isNull())
    facts.push_back(plain(Facts::tr("NAME"), nameLines(name).join(QLatin1Char('\n'))));
  if (const Name former = book.formerHolder(address); !former.isNull()) {
    const QString was = nameLines(former).join(QLatin1Char('\n'));
    facts.push_back(plain(Facts::tr("NAME"), Facts::tr("%1\nbefore the link went down", "a NAME").arg(was),
                          Severity::Unknown));
  }
  const Node node = state.channel(channelId).nodes[address];
  const std::uint32_t frames = device != nullptr ? device->frames : node.frames;
  const std::uint32_t malformed = device != nullptr ? device->malformed : node.malformed;
  const Instant heard = device != nullptr ? device->lastHeard : node.lastHeard;
  const FrameRate& rate = device != nullptr ? device->rate : node.rate;
  facts.push_back(plain(Facts::tr("Frames"), framesText(frames, heard, rate, state.cursor().time)));
  if (malformed != 0)
    facts.push_back(plain(Facts::tr("Of a wrong length"), countText(malformed), Severity::Warning));
  return group;
}

}  // namespace deckpipe
