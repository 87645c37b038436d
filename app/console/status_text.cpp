// SPDX-License-Identifier: GPL-3.0-or-later
#include "status_text.h"

#include <QFileInfo>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "base/overload.h"
#include "model/field_text.h"
#include "text/device_text.h"
#include "text/plural.h"
#include "text/service_text.h"
#include "words.h"

namespace deckpipe {
namespace {

QString sourceName(const SourceStatus& source) {
  if (source.simulated) return StatusText::tr("Simulated truck");
  if (source.kind == From::File) return QFileInfo(source.name).fileName();
  return source.interfaceName;
}

QString deviceName(const DeviceKey& device) {
  return device.kind == DeviceKey::Kind::Pin ? pinText(device.pin)
                                             : StatusText::tr("address %1").arg(addressText(device.address));
}

QString controllerText(ControllerState state) {
  switch (state) {
    case ControllerState::ErrorActive: return StatusText::tr("The CAN controller is well (error active).");
    case ControllerState::ErrorWarning:
      return StatusText::tr("The CAN controller sees many errors (warning).");
    case ControllerState::ErrorPassive:
      return StatusText::tr("The CAN controller sees too many errors (passive).");
    case ControllerState::BusOff: return StatusText::tr("The CAN controller has left the bus (bus-off).");
    case ControllerState::Stopped: return StatusText::tr("The CAN controller is stopped.");
    case ControllerState::Sleeping: return StatusText::tr("The CAN controller is asleep.");
    case ControllerState::Unknown: break;
  }
  return {};
}

QString linkState(const SourceStatus& source) {
  switch (source.progress) {
    case Progress::Opening: return StatusText::tr("connecting");
    case Progress::Running:
      if (source.controller == ControllerState::BusOff) return StatusText::tr("bus-off");
      if (source.controller == ControllerState::ErrorPassive) return StatusText::tr("many errors");
      return source.isListenOnly ? StatusText::tr("connected, listen-only") : StatusText::tr("connected");
    case Progress::Lost: return StatusText::tr("link lost");
    case Progress::Failed: return StatusText::tr("not connected");
    case Progress::Idle:
    case Progress::Done: break;
  }
  return {};
}

QString fileState(const SourceStatus& source) {
  switch (source.progress) {
    case Progress::Opening:
      return StatusText::tr("reading, %1 %").arg(static_cast<int>(source.fraction * 100));
    case Progress::Failed: return StatusText::tr("cannot be read");
    default: return {};
  }
}

QString readErrorWords(const ReadError& error) {
  const auto withDetail = [&error](QString text) {
    if (!error.format.empty()) text += StatusText::tr(" (%1)").arg(QString::fromStdString(error.format));
    return error.detail.empty() ? text
                                : StatusText::tr("%1: %2").arg(text, QString::fromStdString(error.detail));
  };
  switch (error.kind) {
    case ReadError::Kind::CannotOpen: return withDetail(StatusText::tr("cannot be opened"));
    case ReadError::Kind::CannotRead: return withDetail(StatusText::tr("cannot be read further"));
    case ReadError::Kind::UnknownFormat:
      return error.format.empty() ? StatusText::tr("not a log of a known format")
                                  : StatusText::tr("it seems to be %1, which cannot be read")
                                        .arg(QString::fromStdString(error.format));
    case ReadError::Kind::NewerVersion: return StatusText::tr("written by a newer version of Deckpipe");
    case ReadError::Kind::NoPipe:
      return StatusText::tr("a log of this format is read from a file only, not from a pipe");
    case ReadError::Kind::Damaged:
      return StatusText::tr("its beginning is damaged, and no part behind it is whole");
    case ReadError::Kind::StoreFull:
      return StatusText::tr("no room for more frames, neither in memory nor on disk");
  }
  return {};
}

// Says why BusRates are not known.
QString whyNoRates(const BusRates& rates) {
  switch (rates.basis) {
    case BusRates::Basis::NoTimes: return StatusText::tr("Without times neither load nor rate is known.");
    case BusRates::Basis::Coarse:
      return StatusText::tr(
          "The times of this log are good to the second only: load and rate of a second "
          "are not known.");
    case BusRates::Basis::Filtered:
      return StatusText::tr("This log was saved through a filter: what else was on the bus is not known.");
    case BusRates::Basis::TooShort:
    case BusRates::Basis::Times: break;
  }
  return StatusText::tr("Too little of the log lies before the cursor to tell load and rate.");
}

Severity sourceTone(const SourceStatus& source) {
  switch (source.progress) {
    case Progress::Idle: return Severity::Unknown;
    case Progress::Opening: return Severity::Busy;
    case Progress::Running:
      if (source.controller == ControllerState::BusOff) return Severity::Fault;
      return source.controller == ControllerState::ErrorPassive ? Severity::Warning : Severity::Fine;
    case Progress::Done: return Severity::Fine;
    case Progress::Lost:
    case Progress::Failed: return Severity::Fault;
  }
  return Severity::Unknown;
}

QString linkErrorWords(const LinkError& error) {
  const QString detail = QString::fromStdString(error.detail);
  if (error.bitRate == 0) return linkFaultText(error.fault, detail);
  const QString fault = StatusText::tr("the interface runs at %1 kbit/s").arg(error.bitRate / 1000.0);
  return detail.isEmpty() ? fault : QStringLiteral("%1 (%2)").arg(fault, detail);
}

}  // namespace

QString sourceTitle(const SourceStatus& source) {
  if (source.kind != From::Link || source.bitRate == 0) return sourceName(source);
  return StatusText::tr("%1 · %2 kbit/s").arg(sourceName(source)).arg(source.bitRate / 1000);
}

QString sourceErrorText(const SourceError& error) {
  return std::visit(
      Overload{[](std::monostate) { return QString(); }, [](const ReadError& e) { return readErrorWords(e); },
               [](const LinkError& e) { return linkErrorWords(e); },
               [](const StoreFull&) {
                 return StatusText::tr("No room for more frames, neither in memory nor on disk.");
               }},
      error);
}

QString unkeptMarksText(const UnkeptMarks& marks) {
  switch (marks.why) {
    case UnkeptMarks::Why::LogIsBeingRead: return StatusText::tr("the log is still being read");
    case UnkeptMarks::Why::LogIsCut: return StatusText::tr("the log could not be read to its end");
    case UnkeptMarks::Why::IsARecording:
      return StatusText::tr("nothing is added to a recording that is opened");
    case UnkeptMarks::Why::SidecarUnusable:
      return StatusText::tr("the file of notes beside the log could not be used, and is not replaced");
    case UnkeptMarks::Why::SidecarNewer:
      return StatusText::tr("the file of notes beside the log is of a newer version, and is not replaced");
    case UnkeptMarks::Why::SidecarChanged:
      return StatusText::tr("the file of notes beside the log was changed meanwhile, and is not replaced");
    case UnkeptMarks::Why::NoAnswer: return StatusText::tr("the disk does not answer");
    case UnkeptMarks::Why::CannotWrite: return marks.detail;
  }
  return {};
}

QString loadWords(long percent) { return StatusText::tr("Load %1 %").arg(percent); }

QString rateWords(long frames) { return StatusText::tr("%L1 frames/s").arg(frames); }

QString errorWords(std::uint64_t errors) {
  return StatusText::tr("%Ln error frames", nullptr, forPlural(errors));
}

QString unlockedWords(const ClaimStatus& claim) {
  return StatusText::tr("Unlocked, %1").arg(claimText(claim));
}

StatusFact sourceFact(const SourceStatus& source) {
  if (source.kind == From::Nothing)
    return {Severity::Unknown, StatusText::tr("Nothing open"), StatusText::tr("No bus and no log is open.")};
  const QString state = source.kind == From::File ? fileState(source) : linkState(source);
  StatusFact fact{sourceTone(source), sourceTitle(source)};
  if (!state.isEmpty()) fact.text = StatusText::tr("%1 – %2").arg(fact.text, state);
  QStringList story{fact.text};
  if (source.kind == From::File) story += source.name;
  if (source.kind == From::Link) {
    story += source.simulated ? StatusText::tr("A simulated truck, reached through a CAN adapter of Qt's.")
                              : StatusText::tr("Adapter: %1").arg(source.name);
    if (source.isListenOnly)
      story += StatusText::tr("Listen-only: the controller neither sends nor acknowledges.");
    if (const QString controller = controllerText(source.controller); !controller.isEmpty())
      story += controller;
  }
  if (const QString error = sourceErrorText(source.error); !error.isEmpty()) story += error;
  fact.story = story.join(QLatin1Char('\n'));
  return fact;
}

StatusFact loadFact(const Snapshot& snapshot, const BusRates& rates) {
  const State& state = *snapshot.view.state;
  const BusLoad busiest = busiestLoad(rates, state, snapshot.source.bitRate);
  const auto percent = std::lround(busiest.percent);
  const unsigned rate = busiest.bitRate / 1000;
  StatusFact fact;
  QStringList story{StatusText::tr("How much of the bus was taken in the last second, of %1 kbit/s.\n"
                                   "Reckoned from the frames; stuff bits are estimated.")
                        .arg(rate)};
  if (!rates.isKnown()) story += whyNoRates(rates);
  if (!busiest.isKnown()) {
    story += StatusText::tr("The log does not say its bit rate, and more was sent than %1 kbit/s allow.")
                 .arg(rate);
  } else if (busiest.isAssumed) {
    story += StatusText::tr("The log does not say its bit rate: this takes it for J1939.");
  }
  if (!rates.isKnown() || !busiest.isKnown()) {
    fact.text = StatusText::tr("Load –");
  } else {
    fact.text = busiest.isAssumed ? StatusText::tr("Load %1 % if %2 kbit/s").arg(percent).arg(rate)
                                  : loadWords(percent);
  }
  if (const auto& document = snapshot.view.document;
      rates.isKnown() && document && document->frames.channelCount() > 1) {
    for (std::uint8_t i = 0; i < std::min<std::size_t>(document->frames.channelCount(), kMaxChannels); ++i) {
      const BusLoad load = loadOf(rates, state, {i}, snapshot.source.bitRate);
      if (!load.isKnown()) continue;
      story += StatusText::tr("%1: %2 % of %3 kbit/s")
                   .arg(toQString(document->frames.channelName(i)))
                   .arg(std::lround(load.percent))
                   .arg(load.bitRate / 1000);
    }
  }
  fact.story = story.join(QLatin1Char('\n'));
  // Above this, periodic messages begin to wait for one another.
  if (percent >= 80 && busiest.isKnown()) fact.tone = Severity::Warning;
  return fact;
}

StatusFact rateFact(const BusRates& rates) {
  if (!rates.isKnown()) return {Severity::Plain, StatusText::tr("– frames/s"), whyNoRates(rates)};
  return {Severity::Plain, rateWords(std::lround(rates.framesASecond)),
          StatusText::tr("Frames in the last second before the cursor, of all buses.")};
}

StatusFact errorFact(const Snapshot& snapshot) {
  std::uint64_t errors = 0;
  for (std::uint8_t i = 0; i < kMaxChannels; ++i) errors += snapshot.view.state->channel({i}).errorFrames;
  return {
      errors == 0 ? Severity::Plain : Severity::Warning, errorWords(errors),
      StatusText::tr("Error frames that the adapter reported up to the cursor. A wrong bit rate, missing\n"
                     "termination or a bad cable make many. Not every adapter reports them.")};
}

namespace {

// The story of frames that waited when their link was left. Their fate cannot be learnt any more.
QStringList leftStory(const LeftWaiting& left) {
  QStringList story;
  for (const WaitingCommand& command : left.commands) {
    story += StatusText::tr("%1 of %2 was not on the bus when %3 was left.")
                 .arg(requestText(command.request), deviceName(command.device), left.interfaceName);
  }
  story += StatusText::tr(
               "%Ln frames were not on the bus when %1 was left. They may have gone out since or may\n"
               "still go out, unless the interface was taken down.",
               nullptr, forPlural(left.frames))
               .arg(left.interfaceName);
  return story;
}

}  // namespace

StatusFact sentFact(const Snapshot& snapshot) {
  const ServiceStatus& services = *snapshot.services;
  StatusFact fact;
  QStringList story;
  const int commands = forPlural(services.waitingCommands.size());
  for (const WaitingCommand& command : services.waitingCommands) {
    story += StatusText::tr("%1 of %2 was handed to the adapter and is not on the bus yet.")
                 .arg(requestText(command.request), deviceName(command.device));
  }
  if (commands > 0) {
    fact.tone = Severity::Fault;
    fact.text =
        commands == 1
            ? StatusText::tr("%1: not on the bus yet").arg(requestText(services.waitingCommands[0].request))
            : StatusText::tr("%Ln commands not on the bus yet", nullptr, commands);
  } else if (services.unconfirmed > 0) {
    fact.tone = Severity::Fault;
    fact.text = StatusText::tr("%Ln frames not on the bus yet", nullptr, forPlural(services.unconfirmed));
  } else if (snapshot.leftWaiting) {
    fact.tone = Severity::Fault;
    fact.text =
        StatusText::tr("%Ln frames may still go out", nullptr, forPlural(snapshot.leftWaiting->frames));
  } else if (services.notTaken > 0) {
    fact.tone = Severity::Warning;
    fact.text = StatusText::tr("%Ln frames not sent", nullptr, forPlural(services.notTaken));
  } else if (!services.echoes && !services.locked) {
    fact.tone = Severity::Unknown;
    fact.text = StatusText::tr("On the bus: cannot tell");
  } else {
    return {};
  }
  if (services.unconfirmed > 0) {
    story += StatusText::tr("%Ln frames were handed to the adapter and are not on the bus yet.", nullptr,
                            forPlural(services.unconfirmed));
    story += StatusText::tr(
        "What waits may still go out, after a lock too. Only taking the interface down\n"
        "takes it back.");
  }
  if (snapshot.leftWaiting) story += leftStory(*snapshot.leftWaiting);
  if (services.notTaken > 0)
    story += StatusText::tr("%Ln frames were not taken by the adapter: they were not sent.", nullptr,
                            forPlural(services.notTaken));
  if (!services.echoes)
    story += StatusText::tr("This adapter does not tell whether what it takes reaches the bus.");
  fact.story = story.join(QLatin1Char('\n'));
  return fact;
}

QString waitingText(std::uint64_t frames) {
  return StatusText::tr(
      "%Ln frames are not on the bus yet and may still go out; only taking the interface down "
      "takes them back.",
      nullptr, forPlural(frames));
}

StatusFact lockFact(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  if (snapshot.services->isEnding) {
    return {Severity::Busy, StatusText::tr("Locking …"),
            StatusText::tr("What must still be said at the end is being said; one second at most.")};
  }
  if (!snapshot.services->locked) {
    return {
        Severity::Warning, unlockedWords(snapshot.services->claim),
        StatusText::tr("Deckpipe may send on this bus: its address claim, and what is asked for by hand.")};
  }
  QString story =
      StatusText::tr("Deckpipe receives only: it sends nothing, no claim, no request, no command.");
  if (source.kind == From::Link && !source.simulated) {
    story += QLatin1Char('\n');
    story += source.isListenOnly
                 ? StatusText::tr("The adapter is in listen-only mode: it does not acknowledge either.")
                 : StatusText::tr(
                       "The adapter still acknowledges frames; at a wrong bit rate it disturbs the bus.\n"
                       "Only its own listen-only mode keeps it off the bus electrically.");
  }
  return {Severity::Plain, StatusText::tr("Transmit locked"), story, Glyph::Locked};
}

}  // namespace deckpipe
