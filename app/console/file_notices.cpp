// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be said of a log that was read from a file, or that could not be.
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>
#include <vector>

#include "log/delta_times.h"
#include "log/log_format.h"
#include "log/time_grain.h"
#include "status_text.h"
#include "text/plural.h"
#include "words.h"

namespace deckpipe {
namespace {

constexpr Duration kClockBack = 1s;
constexpr std::size_t kPlacesShown = 5;

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

// The notice about a log's clock. Without times, ages, rates and load are not shown. Where the clock goes back, they
// are no measure.
Notice clockNotice(const LogDocument& log) {
  if (!log.frames.hasTimes()) {
    return {Severity::Warning, NoticeText::tr("This log has no times, only an order. Ages, rates, load and "
                                              "silence are not known and not shown.")};
  }
  if (timeGrainOf(log.frames) == TimeGrain::Seconds) {
    return {
        Severity::Warning,
        NoticeText::tr("The times of this log are good to the second only: gaps, time-outs and late messages "
                       "that take less are not told.")};
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

QString quotedFilters(const std::vector<std::string>& filters) {
  QStringList quoted;
  for (const std::string& filter : filters)
    quoted += NoticeText::tr("“%1”", "a filter").arg(QString::fromStdString(filter));
  return quoted.join(QStringLiteral(", "));
}

Notice filterNotice(const LogDocument& log) {
  const std::vector<std::string> filters = log.notes.filters();
  if (filters.empty()) return {};
  return {
      Severity::Warning,
      NoticeText::tr("This log was saved through the filter %1: what did not pass it is missing, so load, "
                     "silence, late messages and missing answers are not told.")
          .arg(quotedFilters(filters))};
}

QString reasonText(const SidecarFault& fault) {
  using Kind = SidecarFault::Kind;
  const QString detail = QString::fromStdString(fault.detail);
  switch (fault.kind) {
    case Kind::CannotRead:
      return NoticeText::tr("Deckpipe's file of notes is expected there, and it cannot be read: %1")
          .arg(detail);
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
  QStringList said{NoticeText::tr("This recording is damaged in %Ln places, the first at byte %1.", nullptr,
                                  forPlural(read.damage.places))
                       .arg(number(read.damage.firstAt)),
                   NoticeText::tr("%Ln bytes could not be read.", nullptr, forPlural(read.damage.bytes))};
  if (read.damage.frames > 0)
    said += NoticeText::tr("At least %Ln frames are missing.", nullptr, forPlural(read.damage.frames));
  if (read.damage.isOpen) said += NoticeText::tr("How many frames are missing at its end is not known.");
  if (read.cutBytes > 0) said += cutText(read.cutBytes);
  said += NoticeText::tr("What is whole was read; times across a damaged place are not to be trusted.");
  return {Severity::Warning, said.join(QLatin1Char(' '))};
}

QString lastLineText(LastLine line) {
  switch (line) {
    case LastLine::Whole: return {};
    case LastLine::Open: return NoticeText::tr("The last line of this log has no line end: it may be cut.");
    case LastLine::LeftOut:
      return NoticeText::tr(
          "The last line of this log has no line end, and its frame has fewer "
          "bytes than before: it is cut and was left out.");
  }
  return {};
}

Notice cutNotice(const ReadSummary& read) {
  return {Severity::Warning,
          cutText(read.cutBytes) + QLatin1Char(' ') + NoticeText::tr("What stands before them was read.")};
}

Notice emptyNotice(const Snapshot& snapshot) {
  if (snapshot.view.frameCount > 0) return {};
  return {Severity::Warning, NoticeText::tr("This log holds no frames.")};
}

Notice newerPartsNotice(const ReadSummary& read) {
  if (read.newerParts == 0) return {};
  return {Severity::Warning,
          NoticeText::tr("%Ln parts of this log are of a newer version of Deckpipe and were left out.",
                         nullptr, forPlural(read.newerParts))};
}

Notice openEndNotice(const ReadSummary& read) {
  if (read.goesOn)
    return {Severity::Warning,
            NoticeText::tr("This recording still goes on: what came since it was opened is not here.")};
  if (!read.isOpenEnded) return {};
  return {Severity::Warning, NoticeText::tr("This recording has no end: its last second may be missing.")};
}

Notice fractionNotice(const LogDocument& log) {
  const auto cut = log.skipped.content().count(Skipped::Fraction);
  if (cut == 0) return {};
  return {Severity::Warning, NoticeText::tr("%Ln times of this log are written with more than nine decimals: "
                                            "only their seconds are kept, so rates and ages are not to be "
                                            "trusted.",
                                            nullptr, forPlural(cut))};
}

// All that is to be said of a log that was read, the worst first: what can still be lost, what is missing, what is not
// to be trusted.
std::vector<Notice> noticesOfReadLog(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  const LogDocument& log = *snapshot.view.document;
  const ReadSummary& read = source.read;
  std::vector<Notice> said;
  const auto say = [&said](Notice notice) {
    if (!notice.text.isEmpty()) said.push_back(std::move(notice));
  };
  if (source.unkeptMarks)
    say({Severity::Warning,
         NoticeText::tr(
             "Marks of this log are in memory alone: %1. “Save log” under another name keeps them.")
             .arg(unkeptMarksText(*source.unkeptMarks))});
  // What else is said of times is not true before they are added up.
  const bool areDeltas = !source.addsUpTimes && hasDeltaTimes(log.frames);
  if (areDeltas)
    say({.tone = Severity::Warning,
         .text = NoticeText::tr("The times of this log look like differences, each to the frame before."),
         .action = Notice::Action::AddUpTimes});
  if (read.damage.places > 0) {
    say(damageNotice(read));
  } else if (read.cutBytes > 0) {
    say(cutNotice(read));
  }
  if (source.unreadable > 0) say(unreadable(snapshot));
  if (read.lastLine == LastLine::LeftOut) say({Severity::Warning, lastLineText(read.lastLine)});
  say(emptyNotice(snapshot));
  if (const MissingFrames missing = missingFrames(log); !missing.text.isEmpty())
    say({Severity::Warning, missing.text});
  say(newerPartsNotice(read));
  if (read.sidecarFault) say(sidecarNotice(*read.sidecarFault));
  say(openEndNotice(read));
  say(filterNotice(log));
  say(fractionNotice(log));
  if (!areDeltas && snapshot.view.frameCount > 0) say(clockNotice(log));
  if (read.lastLine == LastLine::Open) say({Severity::Plain, lastLineText(read.lastLine)});
  return said;
}

}  // namespace

QString unreadableText(const QString& path, const SourceError& why) {
  const QString text =
      NoticeText::tr("%1 cannot be read: %2").arg(QFileInfo(path).fileName(), sourceErrorText(why));
  const auto* error = std::get_if<ReadError>(&why);
  if (error == nullptr || error->kind != ReadError::Kind::UnknownFormat) return text;
  return NoticeText::tr("%1. Deckpipe reads: %2.", "after a reason; names of formats")
      .arg(text, QString::fromStdString(formatNames(LogUse::Read)));
}

Notice fileNotice(const Snapshot& snapshot) {
  const SourceStatus& source = snapshot.source;
  if (source.progress == Progress::Failed)
    return {Severity::Fault, unreadableText(source.name, source.error)};
  if (source.progress != Progress::Done) return {};
  // One line each. The first way out is offered.
  Notice all;
  for (const Notice& notice : noticesOfReadLog(snapshot)) {
    if (all.text.isEmpty()) all.tone = notice.tone;
    all.text += (all.text.isEmpty() ? QString() : QStringLiteral("\n")) + notice.text;
    if (all.action != Notice::Action::None) continue;
    all.action = notice.action;
    all.details = notice.details;
  }
  return all;
}

}  // namespace deckpipe
