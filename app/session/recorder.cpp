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
#include <vector>

#include "session/clocks.h"

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

namespace {

// How many notes hold all that happened: those that only tell how a link was left follow in no copy of it.
std::size_t notesToSave(const NoteStore& notes) {
  std::vector<Note> all = notes.appendedAfter(0);
  const auto tellsLeaving = [](const Note& note) {
    return std::holds_alternative<note::LinkDown>(note.value) ||
           std::holds_alternative<note::OwnAddress>(note.value) ||
           std::holds_alternative<note::Locked>(note.value);
  };
  while (!all.empty() && tellsLeaving(all.back())) all.pop_back();
  return all.size();
}

}  // namespace

struct Recorder::Work {
  std::mutex lock;
  std::condition_variable changed;
  JournalStatus status;
  Instant busySince = kNotYet;  // kNotYet: waits for the next round
  std::uint64_t savedFrames = 0;
  std::size_t savedNotes = 0, notes = 0;  // elsewhere; of those there are, all that a copy must hold
  bool isEnding = false;
  bool isGivenUp = false;    // after the first fault at the end nothing is tried again
  bool hasTriedEnd = false;  // at least once
  bool hasEnded = false;

  void run(const LogDocument& document, const JournalWriter::MakeFile& makeFile, bool isSimulated) {
    auto writer = std::make_unique<JournalWriter>(document.frames, document.notes, makeFile,
                                                  [isSimulated] { return recordingHead(isSimulated); });
    while (oneRound(*writer)) {
    }
    writer.reset();  // closes the file
    const std::size_t toSave = notesToSave(document.notes);
    for (bool isMarked = false;; isMarked = true) {
      {
        const std::lock_guard guard(lock);
        notes = toSave;
        if (isMarked || !isAllSaved()) {
          hasEnded = true;
          return changed.notify_all();
        }
      }
      markJournalSaved(status.path);
    }
  }

  bool isAllSaved() const {
    return !status.path.empty() && !status.fault && savedFrames >= status.frames && savedNotes >= notes;
  }

  // False once nothing is left to write, or is given up.
  bool oneRound(JournalWriter& writer) {
    bool isLast = false;
    {
      std::unique_lock guard(lock);
      if (hasTriedEnd) {
        changed.wait_for(guard, JournalWriter::kRetry, [this] { return isGivenUp; });
        if (isGivenUp) return false;
      } else {
        changed.wait_for(guard, kPoll, [this] { return isEnding; });
      }
      isLast = isEnding;
      busySince = bootTime();
    }
    isLast ? writer.end() : writer.timeCame(bootTime());
    const std::lock_guard guard(lock);
    busySince = kNotYet;
    status = writer.status();
    hasTriedEnd = isLast;
    changed.notify_all();
    return !isLast || status.fault;
  }

  // After the end.
  void markIfSaved() {
    {
      const std::lock_guard guard(lock);
      if (!isAllSaved()) return;
    }
    markJournalSaved(status.path);
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
  m_work->changed.wait_for(guard, kPatience, [this] { return m_work->hasEnded || m_work->hasTriedEnd; });
  m_work->isGivenUp = true;
  m_work->changed.notify_all();
  if (m_work->hasTriedEnd) m_work->changed.wait_for(guard, kPatience, [this] { return m_work->hasEnded; });
}

JournalStatus Recorder::status() const {
  const std::lock_guard guard(m_work->lock);
  JournalStatus status = m_work->status;
  if (m_work->busySince != kNotYet && bootTime() - m_work->busySince > kHangs)
    status.fault.kind = JournalFault::Kind::NoAnswer;
  return status;
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

void Recorder::setSaved(std::uint64_t frames, std::size_t notes) {
  {
    const std::lock_guard guard(m_work->lock);
    m_work->savedFrames = std::max(m_work->savedFrames, frames);
    m_work->savedNotes = std::max(m_work->savedNotes, notes);
    if (!m_work->hasEnded) return;
  }
  std::thread([work = m_work] { work->markIfSaved(); }).detach();
}

}  // namespace deckpipe
