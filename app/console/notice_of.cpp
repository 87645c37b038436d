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
