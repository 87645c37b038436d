// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recorder.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "session/live_bus.h"

namespace deckpipe {

JournalWriter::MakeFile recordingIn(const QString& folder) {
  return [folder] {
    QDir().mkpath(folder);
    const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
    return createJournalFile(QFile::encodeName(folder + QLatin1Char('/') + name).toStdString());
  };
}

JournalHead recordingHead(bool isSimulated) {
  return {.isSimulated = isSimulated, .begin = QDateTime::currentMSecsSinceEpoch() * 1'000'000};
}

struct Recorder::Work {
  std::mutex lock;
  std::condition_variable changed;
  JournalStatus status;
  std::uint64_t saved = 0;
  bool isEnding = false;
  bool hasEnded = false;

  void run(const LogDocument& document, const JournalWriter::MakeFile& makeFile, bool isSimulated) {
    auto writer = std::make_unique<JournalWriter>(document.frames, document.notes, makeFile,
                                                  [isSimulated] { return recordingHead(isSimulated); });
    for (bool isLast = false; !isLast;) {
      {
        std::unique_lock guard(lock);
        changed.wait_for(guard, kPoll, [this] { return isEnding; });
        isLast = isEnding;
      }
      isLast ? writer->end() : writer->timeCame(bootTime());
      const std::lock_guard guard(lock);
      status = writer->status();
    }
    writer.reset();  // closes the file
    markWhereSaved();
    const std::lock_guard guard(lock);
    hasEnded = true;
    changed.notify_all();
  }

  // Once the file is closed.
  void markWhereSaved() {
    std::string path;
    {
      const std::lock_guard guard(lock);
      if (status.path.empty() || status.fault || saved < status.frames) return;
      path = status.path;
    }
    markJournalSaved(path);
  }
};

Recorder::Recorder(std::shared_ptr<const LogDocument> document, JournalWriter::MakeFile makeFile,
                   bool isSimulated)
    : m_work(std::make_shared<Work>()), m_document(document) {
  std::thread([work = m_work, document = std::move(document), makeFile = std::move(makeFile), isSimulated] {
    work->run(*document, makeFile, isSimulated);
  }).detach();
}

Recorder::~Recorder() {
  end();
  std::unique_lock guard(m_work->lock);
  m_work->changed.wait_for(guard, kPatience, [this] { return m_work->hasEnded; });
}

JournalStatus Recorder::status() const {
  const std::lock_guard guard(m_work->lock);
  return m_work->status;
}

bool Recorder::isOf(const std::shared_ptr<const LogDocument>& document) const {
  return document != nullptr && m_document.lock() == document;
}

void Recorder::end() {
  const std::lock_guard guard(m_work->lock);
  m_work->isEnding = true;
  m_work->changed.notify_all();
}

bool Recorder::hasEnded() const {
  const std::lock_guard guard(m_work->lock);
  return m_work->hasEnded;
}

void Recorder::setSaved(std::uint64_t frames) {
  {
    const std::lock_guard guard(m_work->lock);
    m_work->saved = std::max(m_work->saved, frames);
    if (!m_work->hasEnded) return;
  }
  std::thread([work = m_work] { work->markWhereSaved(); }).detach();
}

}  // namespace deckpipe
