// SPDX-License-Identifier: GPL-3.0-or-later
#include "status_text.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/overload.h"
#include "log/link_gaps.h"
#include "model/field_text.h"
#include "text/age_text.h"
#include "text/device_text.h"
#include "text/elapsed_text.h"
#include "text/service_text.h"

namespace deckpipe {
namespace {

struct StatusText {
  Q_DECLARE_TR_FUNCTIONS(StatusText)
};

using From = SourceStatus::Kind;
using Progress = SourceStatus::Progress;

constexpr int kJ1939BitRate = 250'000;

int forPlural(std::uint64_t number) {
  return static_cast<int>(std::min<std::uint64_t>(number, std::numeric_limits<int>::max()));
}

QString sourceName(const SourceStatus& source) {
  if (source.simulated) return StatusText::tr("Simulated truck");
  if (source.kind == From::File) return QFileInfo(source.name).fileName();
  return source.interfaceName;
}

// Where the frames come from, with its rate.
QString sourceTitle(const SourceStatus& source) {
  if (source.kind != From::Link || source.bitRate == 0) return sourceName(source);
  return StatusText::tr("%1 · %2 kbit/s").arg(sourceName(source)).arg(source.bitRate / 1000);
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
  return rates.basis == BusRates::Basis::NoTimes
             ? StatusText::tr("Without times neither load nor rate is known.")
             : StatusText::tr("Too little of the log lies before the cursor to tell load and rate.");
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

bool isReadWhole(const SourceStatus& source) {
  const ReadSummary& read = source.read;
  return read.isWhole() && !read.isOpenEnded && source.progress != Progress::Failed;
}

struct LinkOutages {
  bool isDown = false;  // now
  int count = 0;        // that are over
  Duration length{};    // of all that are over
};

// A link that goes down at the end of a file is the file's end, no hole in it.
LinkOutages outagesOf(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  LinkOutages outages{.isDown = source.kind == From::Link && source.progress == Progress::Lost};
  for (const LinkGap& gap : linkGaps(snapshot.view.document->notes.all())) {
    if (gap.isOpen()) {
      outages.isDown = source.kind == From::Link;
    } else {
      ++outages.count;
      outages.length += gap.end - gap.begin;
    }
  }
  return outages;
}

}  // namespace

QString sourceErrorText(const SourceError& error) {
  return std::visit(
      Overload{[](std::monostate) { return QString(); }, [](const ReadError& e) { return readErrorWords(e); },
               [](const LinkError& e) { return QString::fromStdString(e.detail); },
               [](const StoreFull&) {
                 return StatusText::tr("No room for more frames, neither in memory nor on disk.");
               }},
      error);
}

QString frameCountText(std::uint64_t frames) {
  return StatusText::tr("%Ln frames", nullptr, forPlural(frames));
}

QString loadWords(long percent) { return StatusText::tr("Load %1 %").arg(percent); }

QString rateWords(long frames) { return StatusText::tr("%L1 frames/s").arg(frames); }

QString errorWords(std::uint64_t errors) {
  return StatusText::tr("%Ln error frames", nullptr, forPlural(errors));
}

QString recordingWords(bool isRunning, const QString& length, std::uint64_t frames) {
  return (isRunning ? StatusText::tr("Recording %1 · %2") : StatusText::tr("Recorded %1 · %2"))
      .arg(length, frameCountText(frames));
}

int loadBitRate(const SourceStatus& source) { return source.bitRate != 0 ? source.bitRate : kJ1939BitRate; }

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
  const int bitRate = loadBitRate(snapshot.source);
  const auto percent = std::lround(loadPercent(rates, bitRate));
  StatusFact fact;
  fact.text = rates.isKnown() ? loadWords(percent) : StatusText::tr("Load –");
  QStringList story{StatusText::tr("How much of the bus was taken in the last second, of %1 kbit/s.\n"
                                   "Reckoned from the frames; stuff bits are estimated.")
                        .arg(bitRate / 1000)};
  if (!rates.isKnown()) story += whyNoRates(rates);
  if (snapshot.source.bitRate == 0)
    story += StatusText::tr("The log does not say its bit rate: this takes it for J1939.");
  if (const auto& document = snapshot.view.document; document && document->frames.channelCount() > 1) {
    for (std::uint8_t i = 0; i < std::min<std::size_t>(document->frames.channelCount(), kMaxChannels); ++i) {
      story += StatusText::tr("%1: %2 %")
                   .arg(toQString(document->frames.channelName(i)))
                   .arg(std::lround(100 * rates.bitsASecond[i] / bitRate));
    }
  }
  fact.story = story.join(QLatin1Char('\n'));
  // Above this, periodic messages begin to wait for one another.
  if (percent >= 80) fact.tone = Severity::Warning;
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
  if (services.notTaken > 0)
    story += StatusText::tr("%Ln frames were not taken by the adapter: they were not sent.", nullptr,
                            forPlural(services.notTaken));
  if (!services.echoes)
    story += StatusText::tr("This adapter does not tell whether what it takes reaches the bus.");
  fact.story = story.join(QLatin1Char('\n'));
  return fact;
}

StatusFact lockFact(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  if (snapshot.services->isEnding) {
    return {Severity::Busy, StatusText::tr("Locking …"),
            StatusText::tr("What must still be said at the end is being said; one second at most.")};
  }
  if (!snapshot.services->locked) {
    return {
        Severity::Warning, StatusText::tr("Unlocked, %1").arg(claimText(snapshot.services->claim)),
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

QString recordingFaultText(const JournalStatus& recording) {
  const QString why = QString::fromStdString(recording.fault.detail);
  if (recording.path.empty()) return StatusText::tr("No file can be made for this recording: %1").arg(why);
  const QString path = QFile::decodeName(recording.path.c_str());
  if (recording.fault.kind == JournalFault::Kind::NoAnswer)
    return StatusText::tr("%1 cannot be written: the disk does not answer").arg(path);
  return StatusText::tr("%1 cannot be written: %2").arg(path, why);
}

StatusFact recordingFact(const Snapshot& snapshot) {
  const LogView& view = snapshot.view;
  const QString length = elapsedText(view.frameCount == 0 ? Duration(0) : view.end - view.begin);
  const QString shortLength = length.left(length.size() - 4);
  if (snapshot.source.kind == From::File) {
    const QString frames = frameCountText(view.frameCount);
    const bool hasTimes = view.frameCount == 0 || view.document->frames.hasTimes();
    if (snapshot.source.progress == Progress::Opening)
      return {Severity::Plain, frames, StatusText::tr("%1 have been read so far.").arg(frames)};
    return {Severity::Plain, frames,
            hasTimes ? StatusText::tr("The log holds %1 over %2.").arg(frames, shortLength)
                     : StatusText::tr("The log holds %1, without times.").arg(frames)};
  }
  const SourceStatus& source = snapshot.source;
  const bool isRunning = source.progress == Progress::Running && source.isRecorded();
  StatusFact fact;
  fact.text = recordingWords(isRunning, shortLength, view.frameCount);
  fact.glyph = isRunning ? Glyph::On : Glyph::Off;
  if (source.recording && source.recording->fault) {
    fact.tone = Severity::Fault;
    fact.glyph.reset();
    fact.text = source.recording->fault.kind == JournalFault::Kind::DiskFull
                    ? StatusText::tr("Not recorded: disk full")
                    : StatusText::tr("Not recorded");
    fact.story = StatusText::tr(
                     "%1\nWhat is received is kept in memory until another source is opened, and "
                     "written once the disk takes it; that is tried every 10 s.")
                     .arg(recordingFaultText(*source.recording));
  } else if (source.isRecorded()) {
    fact.story = StatusText::tr(
                     "Everything that is received is written to\n%1\n"
                     "File > Recordings lists it; File > Save log writes a copy of your own. "
                     "Pausing stops only what is shown.")
                     .arg(QFile::decodeName(source.recording->path.c_str()));
  } else {
    fact.story = StatusText::tr(
        "What is received is kept in memory until another source is opened;\n"
        "File > Save log writes it to a file. Pausing stops only what is shown.");
  }
  return fact;
}

StatusFact completenessFact(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  QStringList words, story;
  const auto miss = [&](const QString& what, const QString& why) {
    words += what;
    story += why;
  };
  if (source.kind == From::File && !isReadWhole(source))
    miss(StatusText::tr("Not whole"),
         StatusText::tr("Not all of the log could be read; what is missing is said below the strip."));
  if (std::holds_alternative<StoreFull>(source.error))
    miss(StatusText::tr("Store full"),
         StatusText::tr("What came after the last frame is missing here: there was no room for more."));
  const LinkOutages outages = outagesOf(snapshot);
  if (outages.isDown)
    miss(StatusText::tr("Link lost"),
         StatusText::tr("What is sent on the bus while the link is lost is missing here."));
  if (outages.count > 0)
    miss((outages.count == 1 ? StatusText::tr("1 gap of %1")
                             : StatusText::tr("%Ln gaps, %1 in all", nullptr, outages.count))
             .arg(briefAge(outages.length)),
         StatusText::tr("The link was down in between: what was sent on the bus then is missing here."));
  if (source.unreadable > 0)
    miss(StatusText::tr("%Ln unreadable lines", nullptr, forPlural(source.unreadable)),
         StatusText::tr("Lines that are no frames are left out; what they were is said below the strip."));
  if (source.notKept > 0)
    miss(StatusText::tr("%Ln frames missing", nullptr, forPlural(source.notKept)),
         source.kind == From::File
             ? StatusText::tr(
                   "They were lost while it was recorded, or are CAN FD or CAN XL, which are not held.")
             : StatusText::tr(
                   "Frames that came faster than they could be read, or are no classic CAN frames."));
  if (!words.isEmpty())
    return {Severity::Warning, words.join(QStringLiteral(", ")), story.join(QLatin1Char('\n'))};
  if (source.progress == Progress::Opening)
    return {Severity::Plain, StatusText::tr("Not complete yet"),
            StatusText::tr("Nothing is known to be missing in what has come so far.")};
  return {Severity::Fine, StatusText::tr("Complete"),
          source.kind == From::File ? StatusText::tr("Every line of the log was read and is held.")
                                    : StatusText::tr("No frame is known to be lost since the link came up.")};
}

}  // namespace deckpipe
