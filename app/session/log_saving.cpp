// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/log_saving.h"

#include <QSaveFile>
#include <string>

#include "log/candump.h"

namespace deckpipe {
namespace {

constexpr std::size_t kBlock = 1 << 20;

}  // namespace

LogSaving::LogSaving(std::shared_ptr<const LogDocument> document, const QString& path, QObject* parent)
    : QObject(parent),
      m_document(std::move(document)),
      m_path(path),
      m_frames(m_document->frames.count()),
      m_thread([this](const std::stop_token& stop) { write(stop); }) {}

LogSaving::~LogSaving() = default;

void LogSaving::write(const std::stop_token& stop) {
  const auto end = [this](Outcome outcome, const QString& reason) {
    QMetaObject::invokeMethod(
        this, [=, this] { Q_EMIT ended(outcome, reason); }, Qt::QueuedConnection);
  };
  QSaveFile file(m_path);
  if (!file.open(QIODevice::WriteOnly)) return end(Outcome::Failed, file.errorString());
  const FrameStore& frames = m_document->frames;
  std::string text;
  text.reserve(kBlock + 256);
  std::uint64_t i = 0;
  while (i < m_frames) {
    for (const Frame& frame : frames.run(i)) {
      if (i == m_frames) break;
      writeCandump(frame, frames.channelName(frame.channel), text);
      ++i;
      if (text.size() < kBlock) continue;
      if (stop.stop_requested()) return end(Outcome::Cancelled, {});
      file.write(text.data(), static_cast<qint64>(text.size()));
      text.clear();
      m_fraction.store(static_cast<double>(i) / static_cast<double>(m_frames), std::memory_order_relaxed);
    }
  }
  file.write(text.data(), static_cast<qint64>(text.size()));
  if (stop.stop_requested()) return end(Outcome::Cancelled, {});
  // A failed write is remembered by the file and fails the commit.
  if (!file.commit()) return end(Outcome::Failed, file.errorString());
  m_fraction.store(1, std::memory_order_relaxed);
  end(Outcome::Saved, {});
}

}  // namespace deckpipe
