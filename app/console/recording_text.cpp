// SPDX-License-Identifier: GPL-3.0-or-later
// The facts about what is held: how much is recorded, and whether anything of it is missing.
#include <QFile>
#include <QStringList>
#include <algorithm>
#include <map>

#include "log/link_gaps.h"
#include "model/field_text.h"
#include "state/advance.h"
#include "status_text.h"
#include "text/plural.h"
#include "text/time_text.h"
#include "words.h"

namespace deckpipe {
namespace {

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
  for (const LinkGap& gap : linkGaps(snapshot.view.document->notes.of<note::LinkUp, note::LinkDown>())) {
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

QString frameCountText(std::uint64_t frames) {
  return StatusText::tr("%Ln frames", nullptr, forPlural(frames));
}

QString recordingWords(bool isRunning, const QString& length, std::uint64_t frames) {
  return (isRunning ? StatusText::tr("Recording %1 · %2") : StatusText::tr("Recorded %1 · %2"))
      .arg(length, frameCountText(frames));
}

QString givenUpText(const JournalFault& file) {
  const QString path = QFile::decodeName(file.detail.c_str());
  return file.kind == JournalFault::Kind::Removed
             ? StatusText::tr("%1 was removed while it was recorded").arg(path)
             : StatusText::tr("%1 was cut or changed by another program while it was recorded").arg(path);
}

QString recordingFaultText(const JournalStatus& recording) {
  if (recording.fault.kind == JournalFault::Kind::Removed ||
      recording.fault.kind == JournalFault::Kind::Changed)
    return givenUpText(recording.fault);
  const QString why = QString::fromStdString(recording.fault.detail);
  if (recording.path.empty()) return StatusText::tr("No file can be made for this recording: %1").arg(why);
  const QString path = QFile::decodeName(recording.path.c_str());
  if (recording.fault.kind == JournalFault::Kind::NoAnswer)
    return StatusText::tr("%1 cannot be written: the disk does not answer").arg(path);
  return StatusText::tr("%1 cannot be written: %2").arg(path, why);
}

StatusFact recordingFact(const Snapshot& snapshot) {
  const LogView& view = snapshot.view;
  const SourceStatus& source = snapshot.source;
  // The time of a live log goes on, also without a link.
  const bool isStill = source.kind == From::Link && source.progress != Progress::Running;
  const Instant end = isStill ? endOf(view.document->frames, view.document->notes).time : view.end;
  const QString length = elapsedText(view.frameCount == 0 ? Duration(0) : end - view.begin);
  const QString shortLength = length.left(length.size() - 4);
  if (source.kind == From::File) {
    const QString frames = frameCountText(view.frameCount);
    if (source.progress == Progress::Opening)
      return {Severity::Plain, frames, StatusText::tr("%1 have been read so far.").arg(frames)};
    if (view.frameCount == 0) return {Severity::Plain, frames, StatusText::tr("The log holds no frame.")};
    return {Severity::Plain, frames,
            view.hasTimes() ? StatusText::tr("The log holds %1 over %2.").arg(frames, shortLength)
                            : StatusText::tr("The log holds %1, without times.").arg(frames)};
  }
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
    if (source.recording->givenUp)
      fact.story += QLatin1Char('\n') + StatusText::tr("%1; all of it was written to this file.")
                                            .arg(givenUpText(source.recording->givenUp));
  } else {
    fact.story = StatusText::tr(
        "What is received is kept in memory until another source is opened;\n"
        "File > Save log writes it to a file. Pausing stops only what is shown.");
  }
  return fact;
}

// The notes tell of what a link left out, the skipped places of what a reader of the log's file did.
MissingFrames missingFrames(const LogDocument& log) {
  using Why = note::LeftOut::Why;
  const SkippedPlaces skipped = log.skipped.content();
  std::uint64_t lost = 0;
  std::map<Why, std::uint64_t> leftOut{{Why::CanFd, skipped.count(Skipped::CanFd)},
                                       {Why::CanXl, skipped.count(Skipped::CanXl)}};
  for (const Note& note : log.notes.of<note::Dropped, note::LeftOut>()) {
    if (const auto* dropped = std::get_if<note::Dropped>(&note.value)) lost += dropped->count;
    if (const auto* noted = std::get_if<note::LeftOut>(&note.value)) leftOut[noted->why] += noted->count;
  }
  const std::uint64_t places = skipped.count(Skipped::RecorderDropped) + leftOut[Why::RecorderLost];
  const std::uint64_t lines = leftOut[Why::Unreadable], notWhole = leftOut[Why::NotWhole];
  QStringList kinds;
  const auto add = [&kinds](std::uint64_t count, QString (*text)(int)) {
    if (count > 0) kinds += text(forPlural(count));
  };
  add(lost, [](int n) {
    return StatusText::tr("%Ln frames that were lost before they could be recorded", nullptr, n);
  });
  add(places,
      [](int n) { return StatusText::tr("what the recorder lost at %Ln places, as it says", nullptr, n); });
  add(leftOut[Why::CanFd],
      [](int n) { return StatusText::tr("%Ln CAN FD frames, which are not held", nullptr, n); });
  add(leftOut[Why::CanXl],
      [](int n) { return StatusText::tr("%Ln CAN XL frames, which are not held", nullptr, n); });
  add(leftOut[Why::NotClassic], [](int n) {
    return StatusText::tr("%Ln frames that are not classic CAN, which are not held", nullptr, n);
  });
  add(lines, [](int n) {
    return StatusText::tr(
        "what stood in %Ln lines of the file that it was saved from, which could not be read", nullptr, n);
  });
  add(leftOut[Why::Damaged], [](int n) {
    return StatusText::tr("%Ln frames that stood where the recording is damaged", nullptr, n);
  });
  add(notWhole, [](int n) {
    return StatusText::tr(
        "perhaps what stood at %Ln places of the file that it was saved from, which was not whole", nullptr,
        n);
  });
  if (kinds.isEmpty()) return {};
  return {places + lines + notWhole > 0 ? 0
                                        : lost + leftOut[Why::CanFd] + leftOut[Why::CanXl] +
                                              leftOut[Why::NotClassic] + leftOut[Why::Damaged],
          StatusText::tr("Missing in this log: %1.").arg(kinds.join(QStringLiteral("; ")))};
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
         StatusText::tr("Not all of the log could be read; what is missing is said beside the menus."));
  if (std::holds_alternative<StoreFull>(source.error))
    miss(StatusText::tr("Store full"),
         StatusText::tr("What came after the last frame is missing here: there was no room for more."));
  if (source.recording && source.recording->fault)
    miss(StatusText::tr("In memory only"),
         StatusText::tr(
             "What is not in the file of the recording is in memory, and is lost if Deckpipe ends."));
  const LinkOutages outages = outagesOf(snapshot);
  if (outages.isDown)
    miss(StatusText::tr("Link lost"),
         StatusText::tr("What is sent on the bus while the link is lost is missing here."));
  if (outages.count > 0)
    miss((outages.count == 1 ? StatusText::tr("1 gap of %1")
                             : StatusText::tr("%Ln gaps, %1 in all", nullptr, outages.count))
             .arg(briefAge(outages.length)),
         StatusText::tr("The link was down in between: what was sent on the bus then is missing here."));
  if (!snapshot.view.document->notes.filters().empty())
    miss(StatusText::tr("Filtered"),
         StatusText::tr("The log was saved through a filter: frames that did not pass it are missing."));
  if (snapshot.view.document->frames.channelCount() > FrameStore::kOtherChannels)
    miss(StatusText::tr("Interfaces unnamed"),
         StatusText::tr("Frames of interfaces beyond the first %1 are held under one name, “%2”.")
             .arg(FrameStore::kOtherChannels)
             .arg(toQString(FrameStore::kOtherChannelsName)));
  if (source.unreadable > 0)
    miss(StatusText::tr("%Ln unreadable lines", nullptr, forPlural(source.unreadable)),
         StatusText::tr("Lines that are no frames are left out; what they were is said beside the menus."));
  if (const MissingFrames missing = missingFrames(*snapshot.view.document); !missing.text.isEmpty())
    miss(missing.count == 0 ? StatusText::tr("Frames missing")
                            : StatusText::tr("%Ln frames missing", nullptr, forPlural(missing.count)),
         missing.text);
  if (!words.isEmpty())
    return {Severity::Warning, words.join(QStringLiteral(", ")), story.join(QLatin1Char('\n'))};
  if (snapshot.view.frameCount == 0)
    return {Severity::Unknown, StatusText::tr("No frame"),
            source.kind == From::File && source.progress != Progress::Opening
                ? StatusText::tr("The log holds no frame.")
                : StatusText::tr("Not one frame has come yet.")};
  if (source.progress == Progress::Opening)
    return {Severity::Plain, StatusText::tr("Not complete yet"),
            StatusText::tr("Nothing is known to be missing in what has come so far.")};
  return {Severity::Fine, StatusText::tr("Complete"),
          source.kind == From::File ? StatusText::tr("Every line of the log was read and is held.")
                                    : StatusText::tr("No frame is known to be lost since the link came up.")};
}

}  // namespace deckpipe
