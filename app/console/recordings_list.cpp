// SPDX-License-Identifier: GPL-3.0-or-later
#include "recordings_list.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <algorithm>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "log/journal_file.h"
#include "panel/connect/recordings_page.h"
#include "session/whole_file.h"
#include "status_text.h"

namespace deckpipe {
namespace {

constexpr int kPinsNamed = 3;
constexpr std::size_t kUnsavedNamed = 3;
const QString kMegabytesKey = QStringLiteral("recordings/mostMegabytes");
const QString kDaysKey = QStringLiteral("recordings/mostDays");

QString whenText(const Recording& recording) {
  return QLocale().toString(recording.begin, QLocale::ShortFormat);
}

QString pinsText(const Recording& recording) {
  if (recording.pins.isEmpty()) return RecordingsList::tr("no device named");
  QString text = recording.pins.mid(0, kPinsNamed).join(QStringLiteral(", "));
  if (recording.pins.size() > kPinsNamed || recording.isGlanced) text += QStringLiteral(", …");
  return text;
}

QString lengthText(const Recording& recording) {
  if (!recording.length) return RecordingsList::tr("length not known");
  const auto seconds = static_cast<qint64>(recording.length->count() / 1'000'000'000);
  const QString length = QStringLiteral("%1:%2:%3")
                             .arg(seconds / 3600)
                             .arg(seconds / 60 % 60, 2, 10, QLatin1Char('0'))
                             .arg(seconds % 60, 2, 10, QLatin1Char('0'));
  return recording.isGlanced ? RecordingsList::tr("about %1", "length").arg(length) : length;
}

QString stateText(const Recording& recording) {
  if (recording.isGrowing) return RecordingsList::tr("recording now");
  if (!recording.isReadable) return RecordingsList::tr("cannot be read");
  if (recording.isSaved) return RecordingsList::tr("saved");
  if (recording.isSimulated) return RecordingsList::tr("simulated truck");
  return recording.isWhole ? RecordingsList::tr("not saved")
                           : RecordingsList::tr("not saved, cut off at its end");
}

RecordingRow rowOf(const Recording& recording) {
  QStringList details{lengthText(recording), frameCountText(recording.frames),
                      QLocale().formattedDataSize(static_cast<qint64>(recording.bytes)), pinsText(recording)};
  details += recording.adapters;
  if (recording.isGlanced) details += RecordingsList::tr("only its beginning and end were read");
  return {
      .path = recording.path,
      .title = RecordingsList::tr("%1 – %2", "when, state").arg(whenText(recording), stateText(recording)),
      .details = details.join(QStringLiteral(" · ")),
      .isReadable = recording.isReadable,
      .isGrowing = recording.isGrowing};
}

QString copyFile(const QString& path, const QString& as) {
  const auto failed = [&as](const QString& why) {
    return RecordingsList::tr("%1 cannot be saved: %2").arg(as, why);
  };
  if (QFileInfo(as).dir() == QFileInfo(path).dir())
    return failed(RecordingsList::tr("it would be one of the recordings; choose another folder"));
  // The name would go to the copy, and what is received to a file without one.
  if (isBeingWritten(QFile::encodeName(as).toStdString()))
    return failed(RecordingsList::tr("it is a recording that goes on"));
  QFile from(path);
  const auto unread = [&from, &path] {
    return RecordingsList::tr("%1 cannot be read: %2").arg(path, from.errorString());
  };
  WholeFile to(as);
  if (!from.open(QIODevice::ReadOnly)) return unread();
  if (!to.open()) return failed(to.reason());
  constexpr qint64 kPiece = 1 << 20;
  for (QByteArray piece = from.read(kPiece); !piece.isEmpty(); piece = from.read(kPiece)) {
    if (!to.write({piece.constData(), static_cast<std::size_t>(piece.size())})) return failed(to.reason());
  }
  if (from.error() != QFileDevice::NoError) return unread();
  if (!to.commit()) return failed(to.reason());
  if (const JournalFault fault = markJournalSaved(QFile::encodeName(path).toStdString()))
    return RecordingsList::tr("Saved %1, but the recording cannot be marked as saved: %2")
        .arg(as, QString::fromStdString(fault.detail));
  return RecordingsList::tr("Saved %1").arg(as);
}

}  // namespace

RecordingLimits recordingLimits() {
  const QSettings settings;
  RecordingLimits limits;
  const auto megabytes = settings.value(kMegabytesKey, qulonglong{limits.maxBytes >> 20});
  limits.maxBytes = std::uint64_t{megabytes.toULongLong()} << 20;
  limits.maxDays = settings.value(kDaysKey, limits.maxDays).toInt();
  return limits;
}

void keepRecordingLimits(const RecordingLimits& limits) {
  QSettings settings;
  settings.setValue(kMegabytesKey, qulonglong{limits.maxBytes >> 20});
  settings.setValue(kDaysKey, limits.maxDays);
}

Notice unsavedNotice(const std::vector<Recording>& recordings) {
  std::vector<Recording> unsaved;
  std::ranges::copy_if(recordings, std::back_inserter(unsaved), [](const Recording& recording) {
    return recording.isUnsaved() && recording.isReadable && recording.frames > 0;
  });
  if (unsaved.empty()) return {};
  const auto namedText = [](const Recording& recording, const QString& sentence) {
    return sentence.arg(whenText(recording), frameCountText(recording.frames), pinsText(recording));
  };
  QStringList sentences{
      namedText(unsaved.front(),
                RecordingsList::tr("A recording of %1 was not saved: %2, %3.", "when, frames, devices"))};
  const std::size_t named = std::min(unsaved.size(), kUnsavedNamed);
  for (std::size_t i = 1; i < named; ++i)
    sentences << namedText(unsaved[i],
                           RecordingsList::tr("Nor was that of %1: %2, %3.", "when, frames, devices"));
  if (unsaved.size() > named)
    sentences << RecordingsList::tr("%Ln earlier ones were not saved either.", nullptr,
                                    static_cast<int>(unsaved.size() - named));
  const QString text = sentences.join(QLatin1Char(' '));
  return {
      .tone = Severity::Warning, .text = text, .action = Notice::Action::ShowRecordings, .canClose = true};
}

struct RecordingsList::Work {
  std::mutex lock;
  bool hasEnded = false;
  QString outcome;
  std::vector<Recording> recordings;
};

RecordingsList::RecordingsList(const QString& folder, QWidget* parent)
    : QObject(parent), m_folder(folder), m_page(new RecordingsPage(parent)) {
  m_tick.setInterval(50);
  connect(&m_tick, &QTimer::timeout, this, &RecordingsList::finish);
}

RecordingsList::~RecordingsList() = default;

void RecordingsList::read() { start({}); }

void RecordingsList::saveCopy(const QString& path, const QString& as) {
  start([path, as] { return copyFile(path, as); });
}

void RecordingsList::remove(const QString& path) {
  start([path] {
    QFile file(path);
    return file.remove() ? tr("Deleted %1").arg(QFileInfo(path).fileName())
                         : tr("%1 cannot be deleted: %2").arg(path, file.errorString());
  });
}

// One after the other; the folder is read after each.
void RecordingsList::start(std::function<QString()> deed) {
  m_page->setReading();
  m_isDeed = m_isDeed || deed;
  if (m_work != nullptr) {
    m_waiting.push_back(std::move(deed));
    return;
  }
  m_work = std::make_shared<Work>();
  const std::optional<RecordingLimits> tidyTo =
      std::exchange(m_isTidy, true) ? std::nullopt : std::optional(recordingLimits());
  std::thread([work = m_work, folder = m_folder, deed = std::move(deed), tidyTo] {
    const QString outcome = deed ? deed() : QString();
    std::vector<Recording> recordings = recordingsIn(folder);
    if (tidyTo) {
      QStringList gone = recordingsToDelete(recordings, *tidyTo, QDateTime::currentDateTime());
      gone.removeIf([](const QString& path) { return !QFile::remove(path); });
      std::erase_if(recordings, [&](const Recording& recording) { return gone.contains(recording.path); });
    }
    const std::lock_guard guard(work->lock);
    work->outcome = outcome;
    work->recordings = std::move(recordings);
    work->hasEnded = true;
  }).detach();
  m_tick.start();
}

void RecordingsList::finish() {
  {
    const std::lock_guard guard(m_work->lock);
    if (!m_work->hasEnded) return;
  }
  m_tick.stop();
  const std::shared_ptr<Work> work = std::exchange(m_work, nullptr);
  std::vector<RecordingRow> rows;
  std::ranges::transform(work->recordings, std::back_inserter(rows), rowOf);
  m_page->setRows(rows, m_folder);
  m_page->setOutcome(work->outcome);
  Q_EMIT changed(work->recordings);
  if (m_waiting.empty()) {
    m_isDeed = false;
    return;
  }
  const auto next = std::move(m_waiting.front());
  m_waiting.erase(m_waiting.begin());
  start(next);
}

}  // namespace deckpipe
