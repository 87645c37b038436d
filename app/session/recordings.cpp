// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recordings.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "log/journal_bytes.h"
#include "log/journal_file.h"
#include "log/log_format.h"
#include "state/advance.h"

namespace deckpipe {
namespace {

JournalHead headOf(const QString& path) {
  QFile file(path);
  JournalHead head;
  if (!file.open(QIODevice::ReadOnly)) return head;
  const QByteArray bytes = file.read(JournalHead::kBytes);
  takeJournalHead(
      {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())},
      head);
  return head;
}

}  // namespace

QString recordingsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
         QStringLiteral("/Deckpipe/deckpipe/recordings");
}

Recording readRecording(const QString& path) {
  Recording recording;
  const QFileInfo facts(path);
  const std::string name = QFile::encodeName(path).toStdString();
  recording.path = path;
  recording.bytes = static_cast<std::uint64_t>(facts.size());
  // Before it is read: what ends meanwhile is not taken for one that nobody ended.
  recording.isGrowing = isBeingWritten(name);
  const JournalHead head = headOf(path);
  recording.begin = head.begin != 0 ? QDateTime::fromMSecsSinceEpoch(head.begin / 1'000'000)
                                    : QDateTime::fromString(facts.baseName().left(19),
                                                            QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
  recording.isSaved = head.isSaved;
  recording.isSimulated = head.isSimulated;

  FrameStore frames;
  NoteStore notes;
  UnkeptList unkept;
  const auto summary = openLog(name, {frames, unkept, &notes});
  if (!summary) return recording;
  recording.isReadable = true;
  recording.frames = frames.count();
  recording.isWhole = !summary.value().isOpenEnded && summary.value().cutBytes == 0;
  if (recording.frames == 0) return recording;
  recording.length = frames.lastTime() - frames.timeAt(0);
  State state;
  advance(state, frames, notes, cursorAfter(frames, frames.count()));
  for (const Device& device : state.devices().all()) {
    if (device.kind != Device::Kind::Pin) continue;
    const std::string_view pin = device.pin.text();
    const QString text = QString::fromLatin1(pin.data(), static_cast<qsizetype>(pin.size()));
    if (!recording.pins.contains(text)) recording.pins += text;
  }
  return recording;
}

std::vector<Recording> recordingsIn(const QString& folder) {
  std::vector<Recording> recordings;
  const QDir files(folder, QStringLiteral("*.deckpipe"), QDir::NoSort, QDir::Files);
  for (const QFileInfo& file : files.entryInfoList()) recordings.push_back(readRecording(file.filePath()));
  std::ranges::sort(recordings, [](const Recording& a, const Recording& b) {
    return a.begin != b.begin ? a.begin > b.begin : a.path > b.path;
  });
  return recordings;
}

QStringList recordingsToDelete(std::vector<Recording> recordings, const RecordingLimits& limits,
                               const QDateTime& now) {
  std::ranges::stable_sort(recordings, {}, &Recording::begin);
  std::uint64_t bytes = 0;
  for (const Recording& recording : recordings) bytes += recording.bytes;
  QStringList paths;
  for (const Recording& recording : recordings) {
    const bool isOld = recording.begin.daysTo(now) > limits.mostDays;
    const bool mayGo = (recording.isSaved || recording.isSimulated) && !recording.isGrowing;
    if (!mayGo || (!isOld && bytes <= limits.mostBytes)) continue;
    paths += recording.path;
    bytes -= recording.bytes;
  }
  return paths;
}

}  // namespace deckpipe
