// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recordings.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>

#include "log/journal_bytes.h"
#include "log/journal_file.h"
#include "log/journal_tail.h"
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

QString textOf(std::string_view words) {
  return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

// The first so many bytes of a file.
class FrontOfFile final : public LogBytes {
 public:
  FrontOfFile(const LogBytes& file, std::uint64_t size) : m_file(file), m_size(std::min(size, file.size())) {}
  std::uint64_t size() const override { return m_size; }
  std::string get(std::uint64_t from, std::uint64_t to, std::vector<char>& buffer,
                  std::string_view& piece) const override {
    return m_file.get(from, to, buffer, piece);
  }

 private:
  const LogBytes& m_file;
  const std::uint64_t m_size;
};

void takeNames(Recording& recording, const FrameStore& frames, const NoteStore& notes) {
  State state;
  advance(state, frames, notes, cursorAfter(frames, frames.count()));
  for (const Device& device : state.devices().all()) {
    const QString pin = textOf(device.pin.text());
    if (device.kind == Device::Kind::Pin && !recording.pins.contains(pin)) recording.pins += pin;
  }
  // Said before a gap of the link, and not since.
  for (std::size_t c = 0; c < state.channelCount(); ++c) {
    for (unsigned a = 0; a < kNullAddress.value; ++a) {
      const AddressBook& book = state.channel({static_cast<std::uint8_t>(c)}).book;
      const Pin former = book.formerPin({static_cast<std::uint8_t>(a)});
      if (const QString pin = textOf(former.text()); !former.isNull() && !recording.pins.contains(pin))
        recording.pins += pin;
    }
  }
  for (const Note& note : notes.all()) {
    const auto* up = std::get_if<note::LinkUp>(&note.value);
    if (up == nullptr || up->adapter.isEmpty()) continue;
    const QString adapter = textOf(up->adapter.str());
    if (!recording.adapters.contains(adapter)) recording.adapters += adapter;
  }
}

// When the log ends. The log time of its last frame is by the clock of that channel as the beginning or the end tells
// it.
std::optional<Instant> endOf(const JournalTail& tail, const FrameStore& begin) {
  if (!tail.last) return tail.ranUntil == kNotYet ? std::nullopt : std::optional(tail.ranUntil);
  const Frame last = tail.last.value_or(Frame{});
  std::int64_t offset = tail.offset.value_or(0);
  const auto* offsets = begin.offsets(last.channel);
  if (!tail.offset && offsets != nullptr && offsets->size() > 0)
    offset = (*offsets)[offsets->size() - 1].offset;
  return endAfter(Instant{saturatedPlus(last.stamp, offset)}, tail.ranUntil, tail.noted);
}

}  // namespace

QString recordingsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
         QStringLiteral("/Deckpipe/deckpipe/recordings");
}

Recording readRecording(const QString& path, std::uint64_t readWhole) {
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

  BytesOfFile file;
  if (!file.open(name).empty()) return recording;
  const std::optional<JournalTail> tail =
      file.size() > readWhole ? readJournalTail(file, std::min(readWhole, kJournalTailBytes)) : std::nullopt;
  FrameStore frames;
  NoteStore notes;
  SkippedList skipped;
  const auto summary =
      readLog(FrontOfFile(file, tail ? readWhole / 2 : file.size()), {frames, skipped, &notes});
  if (!summary) return recording;
  recording.isReadable = true;
  recording.isGlanced = tail.has_value();
  recording.frames = tail ? tail->frames : frames.count();
  const ReadSummary& read = summary.value();
  recording.isWhole =
      tail ? tail->isEnded && tail->cutBytes == 0 && !tail->isDamaged && read.damage.places == 0
           : !read.isOpenEnded && read.isWhole();
  if (frames.count() == 0) return recording;
  const auto last = tail ? endOf(*tail, frames) : std::optional(endOf(frames, notes).time);
  if (last && *last >= frames.timeAt(0)) recording.length = *last - frames.timeAt(0);
  takeNames(recording, frames, notes);
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
    const bool isOld = recording.begin.daysTo(now) > limits.maxDays;
    const bool mayGo = (recording.isSaved || recording.isSimulated) && !recording.isGrowing;
    if (!mayGo || (!isOld && bytes <= limits.maxBytes)) continue;
    paths += recording.path;
    bytes -= recording.bytes;
  }
  return paths;
}

}  // namespace deckpipe
