// SPDX-License-Identifier: GPL-3.0-or-later
#include "notice_of.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <limits>

#include "log/delta_times.h"
#include "log/log_format.h"
#include "model/device_rows.h"
#include "status_text.h"
#include "text/device_text.h"
#include "text/elapsed_text.h"

namespace deckpipe {
namespace {

struct NoticeText {
  Q_DECLARE_TR_FUNCTIONS(NoticeText)
};

using From = SourceStatus::Kind;
using Progress = SourceStatus::Progress;

// Shorter silences are no riddle: devices start, people plug in.
constexpr Duration kSilence = 3s;
constexpr Duration kClockBack = 1s;
constexpr std::size_t kPlacesShown = 5;
constexpr int kJ1939BitRate = 250'000;

QString reasonText(Skipped reason) {
  switch (reason) {
    case Skipped::CanFd: return NoticeText::tr("CAN FD frame, not held");
    case Skipped::CanXl: return NoticeText::tr("CAN XL frame, not held");
    case Skipped::RecorderDropped: return NoticeText::tr("the recorder lost frames here");
    case Skipped::Fraction: return NoticeText::tr("fraction of a time, as it has more than nine digits");
    case Skipped::Layout: return NoticeText::tr("not a line of a known form");
    case Skipped::Binary: return NoticeText::tr("control characters");
    case Skipped::LineTooLong: return NoticeText::tr("line too long");
    case Skipped::Time: return NoticeText::tr("unreadable time");
    case Skipped::TimeRange: return NoticeText::tr("time out of range");
    case Skipped::Interface: return NoticeText::tr("unreadable interface name");
    case Skipped::Identifier: return NoticeText::tr("unreadable identifier");
    case Skipped::Data: return NoticeText::tr("unreadable data");
    case Skipped::DataTooLong: return NoticeText::tr("more than 8 data bytes");
    case Skipped::LengthMismatch: return NoticeText::tr("data bytes and length differ");
  }
  return {};
}

int forPlural(std::uint64_t number) {
  return static_cast<int>(std::min<std::uint64_t>(number, std::numeric_limits<int>::max()));
}

Notice unreadable(const Snapshot& snapshot) {
  const SkippedPlaces skipped = snapshot.view.document->skipped.content();
  QStringList shown, all;
  for (const SkippedPlace& place : skipped.places()) {
    if (!isUnreadable(place.reason)) continue;
    all += NoticeText::tr("line %1: %2").arg(place.place).arg(reasonText(place.reason));
    if (shown.size() < static_cast<qsizetype>(kPlacesShown)) shown.append(all.last());
  }
  if (all.size() > shown.size()) shown += QStringLiteral("…");
  const int count = forPlural(snapshot.source.unreadable);
  Notice notice{Severity::Warning};
  notice.text = NoticeText::tr("%Ln lines of this log could not be read and are left out: %1", nullptr, count)
                    .arg(shown.join(QStringLiteral("; ")));
  notice.action = Notice::Action::CopyDetails;
  notice.details = all.join(QLatin1Char('\n'));
  return notice;
}

// Where a log's clock does not run, ages, rates and load are no measure.
Notice clockNotice(const LogDocument& log) {
  if (!log.frames.hasTimes()) {
    return {Severity::Warning, NoticeText::tr("This log has no times, only an order: what is shown of ages, "
                                              "rates, load and silence means nothing.")};
  }
  // Small steps back are usual where a log has several interfaces, and a leap ahead is a pause.
  const auto& jumps = log.frames.jumps();
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    const std::uint64_t at = jumps[i];
    if (at >= log.frames.count() || !log.frames[at].hasStamp()) continue;
    if (log.frames.timeAt(at) - Instant{log.frames[at].stamp} < kClockBack) continue;
    return {Severity::Warning,
            NoticeText::tr("The clock of this log goes back at frame %1: ages, rates and load from there on "
                           "are not to be trusted. The places are marked in the trace.")
                .arg(QLocale().toString(static_cast<qulonglong>(at + 1)))};
  }
  return {};
}

QString reasonText(const SidecarFault& fault) {
  using Kind = SidecarFault::Kind;
  const QString detail = QString::fromStdString(fault.detail);
  switch (fault.kind) {
    case Kind::CannotRead: return NoticeText::tr("it cannot be read: %1").arg(detail);
    case Kind::NoSidecar: return NoticeText::tr("it does not begin with “Deckpipe notes 1”");
    case Kind::NewerVersion: return NoticeText::tr("a newer version of Deckpipe wrote it");
    case Kind::BadLine: return NoticeText::tr("that line is none that Deckpipe writes");
    case Kind::Cut: return NoticeText::tr("its end is missing");
    case Kind::Changed: return NoticeText::tr("it was changed since Deckpipe wrote it");
    case Kind::OtherCount:
      return NoticeText::tr("it is of a log with another number of frames (%1)").arg(detail);
    case Kind::OtherFrame: return NoticeText::tr("it is of a log with another frame there: %1").arg(detail);
  }
  return {};
}

Notice sidecarNotice(const SidecarFault& fault) {
  QString where = QFileInfo(QFile::decodeName(fault.path.c_str())).fileName();
  if (fault.line > 0) where = NoticeText::tr("%1, line %2", "file").arg(where).arg(fault.line);
  return {
      Severity::Warning,
      NoticeText::tr("The marks, notes and labels beside this log are left out (%1): %2.", "place, reason")
          .arg(where, reasonText(fault))};
}

QString cutText(std::uint64_t bytes) {
  return NoticeText::tr("The end of this recording is not whole: its last %Ln bytes could not be read.",
                        nullptr, forPlural(bytes));
}

Notice damageNotice(const ReadSummary& read) {
  const auto number = [](std::uint64_t n) { return QLocale().toString(static_cast<qulonglong>(n)); };
  QStringList said{
      NoticeText::tr("This recording is damaged in %Ln places, the first at byte %1; %2 bytes could not "
                     "be read.",
                     nullptr, forPlural(read.damage.places))
          .arg(number(read.damage.firstAt), number(read.damage.bytes))};
  if (read.damage.frames > 0)
    said += NoticeText::tr("At least %Ln frames are missing.", nullptr, forPlural(read.damage.frames));
  if (read.cutBytes > 0) said += cutText(read.cutBytes);
  said += NoticeText::tr("Everything else is here; times across a damaged place are not to be trusted.");
  return {Severity::Warning, said.join(QLatin1Char(' '))};
}

// What is missing of a log that was read.
Notice readingNotice(const ReadSummary& read) {
  if (read.sidecarFault) return sidecarNotice(*read.sidecarFault);
  if (read.damage.places > 0) return damageNotice(read);
  if (read.cutBytes > 0)
    return {Severity::Warning,
            cutText(read.cutBytes) + QLatin1Char(' ') + NoticeText::tr("Everything before them is here.")};
  if (read.newerParts > 0)
    return {Severity::Warning,
            NoticeText::tr("%Ln parts of this log are of a newer version of Deckpipe and were left out.",
                           nullptr, forPlural(read.newerParts))};
  if (read.isOpenEnded)
    return {Severity::Warning,
            NoticeText::tr("This recording has no end: it still goes on, or its end was lost.")};
  return {};
}

QString unreadableText(const QString& path, const SourceError& why) {
  const QString text =
      NoticeText::tr("%1 cannot be read: %2").arg(QFileInfo(path).fileName(), sourceErrorText(why));
  const auto* error = std::get_if<ReadError>(&why);
  if (error == nullptr || error->kind != ReadError::Kind::UnknownFormat) return text;
  return NoticeText::tr("%1. Deckpipe reads: %2.", "after a reason; names of formats")
      .arg(text, QString::fromStdString(formatNames(LogUse::Read)));
}

// Another log was to be opened; what was open stays.
Notice notOpenedNotice(const NotOpened& log) {
  if (log.error) return {Severity::Fault, unreadableText(log.path, *log.error)};
  if (log.isInView)
    return {Severity::Plain, NoticeText::tr("%1 is the recording that is in view here; it goes on.")
                                 .arg(QFileInfo(log.path).fileName())};
  return {Severity::Warning,
          NoticeText::tr("%1 holds no frames and was not opened.").arg(QFileInfo(log.path).fileName())};
}

Notice leftRecordingNotice(const JournalStatus& recording) {
  if (recording.fault)
    return {
        Severity::Fault,
        NoticeText::tr("The link was left. %1. What is not written yet stays in memory and is tried again "
                       "every 10 s, until Deckpipe is quit.")
            .arg(recordingFaultText(recording))};
  const QString path = QFile::decodeName(recording.path.c_str());
  return {.tone = Severity::Plain,
          .text = NoticeText::tr("The link was left. What it received is kept under Recordings: %1.")
                      .arg(QFileInfo(path).fileName()),
          .action = Notice::Action::ShowRecordings};
}

Notice fileNotice(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  if (source.progress == Progress::Failed)
    return {Severity::Fault, unreadableText(source.name, source.error)};
  if (source.progress != Progress::Done) return {};
  if (source.unkeptMarks)
    return {Severity::Warning,
            NoticeText::tr("Marks of this log are in memory alone: %1. “Save log” keeps them.")
                .arg(*source.unkeptMarks)};
  // Before the rest, as nothing else that is said of times is true before they are added up.
  if (!source.addsUpTimes && hasDeltaTimes(snapshot.view.document->frames)) {
    return {
        .tone = Severity::Warning,
        .text = NoticeText::tr("The times of this log look like differences, each to the frame before, as "
                               "candump -t d prints them."),
        .action = Notice::Action::AddUpTimes};
  }
  if (source.unreadable > 0) return unreadable(snapshot);
  if (Notice notice = readingNotice(source.read); !notice.text.isEmpty()) return notice;
  if (snapshot.view.frameCount == 0) return {Severity::Warning, NoticeText::tr("This log holds no frames.")};
  if (const auto cut = snapshot.view.document->skipped.content().count(Skipped::Fraction); cut > 0)
    return {Severity::Warning,
            NoticeText::tr("%Ln times of this log are written with more than nine decimals: "
                           "only their seconds are kept, so rates and ages are not to be "
                           "trusted.",
                           nullptr, forPlural(cut))};
  if (source.notKept > 0) {
    return {Severity::Warning, NoticeText::tr("%Ln frames of this log are missing here: they were lost "
                                              "while it was recorded, or are CAN FD or CAN XL, which are "
                                              "not held.",
                                              nullptr, forPlural(source.notKept))};
  }
  return clockNotice(*snapshot.view.document);
}

// When the link of a live log came up last.
Instant upSince(const LogDocument& log) {
  Instant since = kNotYet;
  for (const Note& note : log.notes.all()) {
    if (std::holds_alternative<note::LinkUp>(note.value)) since = note.time;
  }
  return since;
}

Instant lastFrame(const State& state) {
  Instant last = kNotYet;
  for (std::uint8_t i = 0; i < kMaxChannels; ++i) last = std::max(last, state.channel({i}).lastFrame);
  return last;
}

Notice failedLink(const SourceStatus& source) {
  Notice notice{Severity::Fault};
  const QString name = source.interfaceName;
  const QString reason = sourceErrorText(source.error);
  if (std::holds_alternative<StoreFull>(source.error)) {
    notice.text = NoticeText::tr(
                      "Nothing more of %1 is recorded: there is no room for more frames, neither in "
                      "memory nor on disk.")
                      .arg(name);
    notice.action = Notice::Action::Reconnect;
    return notice;
  }
  const auto* error = std::get_if<LinkError>(&source.error);
  switch (error != nullptr ? error->fault : LinkFault::None) {
    case LinkFault::NoPlugin:
      notice.text = NoticeText::tr("The adapter plugin “%1” cannot be used: %2").arg(source.plugin, reason);
      break;
    case LinkFault::NoInterface:
      notice.text =
          NoticeText::tr("There is no interface %1. Is the adapter plugged in and its driver loaded?")
              .arg(name);
      if (source.plugin == QLatin1String("socketcan"))
        notice.command = QStringLiteral("ip -details link show type can");
      break;
    case LinkFault::InterfaceDown:
      notice.text = NoticeText::tr(
                        "%1 is there but not set up. Set its bit rate and bring it up, listen-only for "
                        "the first look:")
                        .arg(name);
      notice.command = setUpCommand(name, source.bitRate, true);
      break;
    case LinkFault::WrongBitRate:
      notice.text = NoticeText::tr("%1 is set to another bit rate (%2). To change it:").arg(name, reason);
      notice.command =
          QStringLiteral("sudo ip link set %1 down; ").arg(name) + setUpCommand(name, kJ1939BitRate, true);
      break;
    case LinkFault::BitRateRefused:
      notice.text = NoticeText::tr("%1 does not take this bit rate: %2").arg(name, reason);
      break;
    case LinkFault::NoAnswer:
      notice.text =
          NoticeText::tr("%1 does not answer. Is the adapter plugged in, and used by no other program?")
              .arg(name);
      break;
    case LinkFault::None:
    case LinkFault::Gone:
    case LinkFault::Other: notice.text = NoticeText::tr("%1 cannot be opened: %2").arg(name, reason); break;
  }
  notice.action = Notice::Action::Reconnect;
  return notice;
}

// Traffic that is not what Deckpipe reads.
Notice trafficNotice(const Snapshot& snapshot, const BusRates& rates) {
  const auto rows = deviceRows(*snapshot.view.state);
  const bool hasOurs = std::any_of(rows.begin(), rows.end(), [](const DeviceRow& row) {
    return row.group != DeviceGroup::OtherNodes && row.group != DeviceGroup::CanopenNodes;
  });
  if (hasOurs || rates.extended + rates.standard == 0) return {};
  if (rates.extended == 0) {
    return {
        Severity::Warning,
        NoticeText::tr("Only 11-bit identifiers are heard: this looks like CANopen or another network, not "
                       "the monitors' own J1939 bus. The 6051 CAN Gateway speaks CANopen, by default at "
                       "125 kbit/s; its monitors appear once they are heard.")};
  }
  return {Severity::Warning,
          NoticeText::tr("There is traffic, but no Akron device in it so far: other makers share this bus. "
                         "Is the monitor's controller powered, and on this bus?")};
}

// A person wanted to send where nothing can be sent.
Notice listenOnlyNotice(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  if (!source.isListenOnly || snapshot.services->refusal != Refusal::ListenOnly) return {};
  Notice notice{
      Severity::Warning,
      NoticeText::tr("Sending stays locked: %1 is in listen-only mode and cannot send. To send, set "
                     "it up without:")
          .arg(source.interfaceName)};
  notice.command = QStringLiteral("sudo ip link set %1 down; ").arg(source.interfaceName) +
                   setUpCommand(source.interfaceName, source.bitRate, false);
  return notice;
}

Notice runningLink(const Snapshot& snapshot, const BusRates& rates) {
  const SourceStatus& source = snapshot.source;
  const LogView& view = snapshot.view;
  if (source.controller == ControllerState::BusOff) {
    Notice notice{Severity::Fault,
                  NoticeText::tr("The adapter left the bus after too many errors (bus-off): check bit rate, "
                                 "termination and cable, then start it again:")};
    notice.command = QStringLiteral("sudo ip link set %1 type can restart").arg(source.interfaceName);
    return notice;
  }
  if (Notice notice = listenOnlyNotice(snapshot); !notice.text.isEmpty()) return notice;
  const Instant heard = std::max(lastFrame(*view.state), upSince(*view.document));
  if (view.atEnd && heard != kNotYet && view.cursor.time - heard >= kSilence) {
    return {Severity::Warning,
            NoticeText::tr(
                "Connected, but nothing heard for %Ln seconds. Check in this order: is the truck's CAN "
                "powered; is the bit rate right (J1939 250 kbit/s, gateway 125); 60 ohms between CAN-H "
                "and CAN-L; CAN-H and CAN-L not swapped.",
                nullptr, static_cast<int>((view.cursor.time - heard) / 1s))};
  }
  if (view.atEnd) return trafficNotice(snapshot, rates);
  return {};
}

Notice linkNotice(const Snapshot& snapshot, const BusRates& rates) {
  const SourceStatus& source = snapshot.source;
  switch (source.progress) {
    case Progress::Opening:
      return {Severity::Busy,
              NoticeText::tr("Connecting to %1 …")
                  .arg(source.simulated ? NoticeText::tr("the simulated truck") : source.name)};
    case Progress::Failed: return failedLink(source);
    case Progress::Lost: {
      const QString reason = sourceErrorText(source.error);
      Notice notice{
          Severity::Fault,
          reason.isEmpty()
              ? NoticeText::tr("The link to %1 is lost. What was received is kept.").arg(source.interfaceName)
              : NoticeText::tr("The link to %1 is lost: %2. What was received is kept.")
                    .arg(source.interfaceName, reason)};
      notice.action = Notice::Action::Reconnect;
      return notice;
    }
    case Progress::Running: return runningLink(snapshot, rates);
    case Progress::Idle:
    case Progress::Done: break;
  }
  return {};
}

// The past of a log that grows must not be taken for the present.
Notice pastNotice(const Snapshot& snapshot) {
  const LogView& view = snapshot.view;
  if (snapshot.source.kind != From::Link || view.atEnd || view.frameCount == 0) return {};
  Notice notice{Severity::Warning};
  const QString behind = elapsedText(view.end - view.cursor.time);
  notice.text = (snapshot.playing ? NoticeText::tr("Playing what was received %1 ago. Reception goes on.")
                                  : NoticeText::tr("Paused: this is how it was %1 ago. Reception goes on."))
                    .arg(behind.left(behind.size() - 4));
  notice.action = Notice::Action::GoToEnd;
  return notice;
}

// What was wanted, confirmed perhaps, came to nothing.
Notice unsentNotice(Refusal why) {
  Notice notice{Severity::Warning};
  switch (why) {
    case Refusal::None: return {};
    case Refusal::NotLive:
      notice.text = NoticeText::tr(
          "Nothing was sent: the view stands in the past, where nothing can be begun. "
          "Go to the end and ask again.");
      notice.action = Notice::Action::GoToEnd;
      break;
    case Refusal::LogFull:
      notice.text = NoticeText::tr(
          "Nothing was sent: there is no room for more frames, neither in memory nor "
          "on disk, and what is not recorded is not sent.");
      break;
    default: notice.text = NoticeText::tr("Nothing was sent: there is no link any more."); break;
  }
  return notice;
}

// The notice about the log or link that is open.
Notice sourceNotice(const Snapshot& snapshot, const BusRates& rates) {
  if (!snapshot.view.document) return {};
  if (snapshot.source.kind == From::File) return fileNotice(snapshot);
  Notice notice = linkNotice(snapshot, rates);
  if (notice.tone != Severity::Fault || notice.text.isEmpty()) {
    if (const auto& recording = snapshot.source.recording; recording && recording->fault)
      return {
          Severity::Fault,
          NoticeText::tr("%1. What is received is kept in memory only.").arg(recordingFaultText(*recording))};
    if (Notice past = pastNotice(snapshot); !past.text.isEmpty()) return past;
  }
  return notice;
}

}  // namespace

Notice refusedAddressNotice(Address refused, Address used) {
  return {Severity::Warning,
          NoticeText::tr(
              "The preferred address %1 of the settings is a joystick's or a monitor's and is not used: on "
              "unlocking, %2 is claimed. Another can be chosen in the settings.")
              .arg(hexText(refused.value), hexText(used.value))};
}

QString setUpCommand(const QString& interfaceName, int bitRate, bool isListenOnly) {
  QString command = QStringLiteral("sudo ip link set %1 up type can bitrate %2")
                        .arg(interfaceName)
                        .arg(bitRate == 0 ? kJ1939BitRate : bitRate);
  command += isListenOnly ? QStringLiteral(" listen-only on") : QStringLiteral(" listen-only off");
  return command;
}

Notice noticeOf(const Snapshot& snapshot, const BusRates& rates) {
  if (Notice unsent = unsentNotice(snapshot.notSent); !unsent.text.isEmpty()) return unsent;
  if (snapshot.notOpened) return notOpenedNotice(*snapshot.notOpened);
  if (snapshot.isCatchingUp)
    return {.tone = Severity::Busy,
            .text = NoticeText::tr(
                "The log is being looked through: devices and dial do not show the place of the "
                "cursor yet.")};
  const Notice notice = sourceNotice(snapshot, rates);
  if (!notice.text.isEmpty() || !snapshot.leftRecording) return notice;
  return leftRecordingNotice(*snapshot.leftRecording);
}

}  // namespace deckpipe
