// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mark_keeper.h"

#include <QFile>
#include <QFileInfo>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "log/sidecar.h"
#include "session/clocks.h"
#include "session/whole_file.h"

namespace deckpipe {
namespace {

using Why = UnkeptMarks::Why;

}  // namespace

QString sidecarOf(const QString& logPath) {
  return QFile::decodeName(sidecarPath(QFile::encodeName(logPath).toStdString()).c_str());
}

QString writeWholeFile(const QString& path, const std::string& text) {
  WholeFile file(path);
  if (file.open() && file.write(text)) file.commit();
  return file.reason();
}

QDateTime sidecarTime(const QString& logPath) { return sidecarModified(sidecarOf(logPath)); }

struct MarkKeeper::Work {
  const QString path;                       // of the sidecar
  const std::optional<UnkeptMarks> mayNot;  // why it must not be written; nothing if it may
  QDateTime modified;      // when it was read or written; invalid if there was none. The thread's own
  const Write writeWhole;  // the thread's own
  const std::shared_ptr<KnownSidecars> sidecars;

  std::mutex lock{};
  std::condition_variable ended{};
  std::shared_ptr<const LogDocument> wanted{};  // null: its marks are in the file, or are being written
  Instant busySince = kNotYet;                  // kNotYet: no thread
  std::optional<UnkeptMarks> unkept{};

  void run() {
    std::unique_lock guard(lock);
    while (const auto log = std::exchange(wanted, nullptr)) {
      busySince = bootTime();
      guard.unlock();
      std::optional<UnkeptMarks> why = write(log);
      guard.lock();
      unkept = std::move(why);
    }
    busySince = kNotYet;
    ended.notify_all();
  }

  std::optional<UnkeptMarks> write(const std::shared_ptr<const LogDocument>& log) {
    if (sidecarModified(path) != modified && !sidecars->isAllOf(*log, path))
      return UnkeptMarks{Why::SidecarChanged};
    const QString why = writeWhole(path, SidecarMaker::textOf(log->frames, log->notes));
    if (!why.isEmpty()) return UnkeptMarks{Why::CannotWrite, why};
    sidecars->wrote(path, log);
    modified = sidecarModified(path);
    return {};
  }
};

MarkKeeper::~MarkKeeper() {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  for (const auto& work : m_works) {
    std::unique_lock guard(work->lock);
    work->ended.wait_until(guard, end, [&] { return work->busySince == kNotYet; });
  }
}

void MarkKeeper::opened(const QString& path, const ReadSummary& read, const QDateTime& sidecarTime) {
  std::optional<UnkeptMarks> mayNot;
  if (!read.mayHaveSidecar) {
    mayNot = UnkeptMarks{Why::IsARecording};
  } else if (read.sidecarFault) {
    mayNot = UnkeptMarks{Why::SidecarUnusable};
  } else if (read.newerParts > 0) {
    mayNot = UnkeptMarks{Why::SidecarNewer};
  } else if (sidecarTime.isValid() != read.hasSidecar) {
    mayNot = UnkeptMarks{Why::SidecarChanged};
  }
  std::erase_if(m_works, [](const auto& work) {
    const std::lock_guard guard(work->lock);
    return work->busySince == kNotYet;
  });
  // What was not read whole would be lost.
  if (!mayNot) m_sidecars->read(sidecarOf(path), sidecarTime);
  m_works.push_back(std::make_shared<Work>(sidecarOf(path), mayNot, sidecarTime, m_write, m_sidecars));
}

void MarkKeeper::keep(std::shared_ptr<const LogDocument> log) {
  const std::shared_ptr<Work> work = m_works.back();
  const std::lock_guard guard(work->lock);
  work->unkept = work->mayNot;
  if (work->mayNot) return;
  work->wanted = std::move(log);
  if (work->busySince != kNotYet) return;
  work->busySince = bootTime();
  std::thread([work] { work->run(); }).detach();
}

void MarkKeeper::forget() {
  const std::lock_guard guard(m_works.back()->lock);
  m_works.back()->unkept.reset();
}

MarkKeeper::Status MarkKeeper::status(Instant now) const {
  const Work& work = *m_works.back();
  const std::lock_guard guard(m_works.back()->lock);
  if (work.busySince == kNotYet) return {.unkept = work.unkept};
  if (now - work.busySince <= kHangs) return {.isBusy = true};
  return {.unkept = UnkeptMarks{Why::NoAnswer}};
}

}  // namespace deckpipe
