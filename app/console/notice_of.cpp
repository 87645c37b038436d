// SPDX-License-Identifier: GPL-3.0-or-later
#include "notice_of.h"

#include <QFile>
#include <QFileInfo>

#include "status_text.h"
#include "text/device_text.h"
#include "text/service_text.h"
#include "text/time_text.h"
#include "words.h"

namespace deckpipe {
namespace {

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
    return {.tone = Severity::Fault,
            .text = NoticeText::tr(
                        "The link was left. %1. What is not written yet stays in memory and is tried again "
                        "every 10 s, until Deckpipe is quit.")
                        .arg(recordingFaultText(recording)),
            .canClose = true};
  const QString path = QFile::decodeName(recording.path.c_str());
  return {.tone = Severity::Plain,
          .text = NoticeText::tr("The link was left. What it received is kept under Recordings: %1.")
                      .arg(QFileInfo(path).fileName()),
          .action = Notice::Action::ShowRecordings,
          .canClose = true};
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
  if (why == Refusal::None) return {};
  return {.tone = Severity::Warning,
          .text = NoticeText::tr("Nothing was sent. %1").arg(refusalText(why)),
          .action = why == Refusal::NotLive ? Notice::Action::GoToEnd : Notice::Action::None};
}

Notice recordingFaultNotice(const SourceStatus& source) {
  if (!source.recording || !source.recording->fault) return {};
  return {Severity::Fault, NoticeText::tr("%1. What is received is kept in memory only.")
                               .arg(recordingFaultText(*source.recording))};
}

Notice givenUpNotice(const Snapshot& snapshot) {
  if (!snapshot.givenUpFile || !snapshot.source.recording) return {};
  return {.tone = Severity::Warning,
          .text = NoticeText::tr("%1. All of the recording was written anew, and it goes on in %2.",
                                 "what became of a file; another file")
                      .arg(givenUpText(*snapshot.givenUpFile),
                           QFile::decodeName(snapshot.source.recording->path.c_str())),
          .canClose = true};
}

// The notice about the log or link that is open.
Notice sourceNotice(const Snapshot& snapshot, const BusRates& rates) {
  if (!snapshot.view.document) return {};
  return snapshot.source.kind == From::File ? fileNotice(snapshot) : linkNotice(snapshot, rates);
}

// The worst notice that stands as long as its cause does.
Notice standingNotice(const Snapshot& snapshot, const BusRates& rates) {
  Notice source = sourceNotice(snapshot, rates);
  if (!source.text.isEmpty() && source.tone == Severity::Fault) return source;
  if (Notice recording = recordingFaultNotice(snapshot.source); !recording.text.isEmpty()) return recording;
  if (snapshot.leftRecording && snapshot.leftRecording->fault)
    return leftRecordingNotice(*snapshot.leftRecording);
  if (Notice givenUp = givenUpNotice(snapshot); !givenUp.text.isEmpty()) return givenUp;
  // Before the other warnings: nothing of what is drawn is of the cursor.
  if (snapshot.isCatchingUp)
    return {.tone = Severity::Busy,
            .text = NoticeText::tr(
                "The log is being looked through: devices and dial do not show the place of the "
                "cursor yet.")};
  if (Notice past = pastNotice(snapshot); !past.text.isEmpty()) return past;
  if (!source.text.isEmpty() || !snapshot.leftRecording) return source;
  return leftRecordingNotice(*snapshot.leftRecording);
}

// The answer to the last thing that a person wanted. It goes when the person does another.
Notice answerNotice(const Snapshot& snapshot) {
  Notice answer = unsentNotice(snapshot.notSent);
  if (const auto& log = snapshot.notOpened; log && (log->error || answer.text.isEmpty()))
    answer = notOpenedNotice(*log);
  answer.canClose = !answer.text.isEmpty();
  return answer;
}

// An answer stands instead of a notice that is no fault and no worse than it. Beside all others it is said as well.
bool hides(const Notice& answer, const Notice& standing) {
  if (standing.text.isEmpty()) return true;
  const auto weight = [](Severity tone) {
    return tone == Severity::Fault ? 3 : tone == Severity::Warning ? 2 : tone == Severity::Busy ? 1 : 0;
  };
  return standing.tone != Severity::Fault && weight(answer.tone) >= weight(standing.tone);
}

}  // namespace

Notice refusedAddressNotice(Address refused, Address used) {
  return {
      .tone = Severity::Warning,
      .text =
          NoticeText::tr(
              "The preferred address %1 of the settings is a joystick's or a monitor's and is not used: on "
              "unlocking, %2 is claimed. Another can be chosen in the settings.")
              .arg(hexText(refused.value), hexText(used.value)),
      .canClose = true};
}

Notice noticeOf(const Snapshot& snapshot, const BusRates& rates) {
  Notice standing = standingNotice(snapshot, rates);
  Notice answer = answerNotice(snapshot);
  if (answer.text.isEmpty()) return standing;
  if (hides(answer, standing)) return answer;
  standing.text += QLatin1Char('\n') + answer.text;
  standing.canClose = true;
  return standing;
}

}  // namespace deckpipe
