// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/log_saving.h"

#include <QSaveFile>
#include <algorithm>
#include <string>
#include <utility>

namespace deckpipe {
namespace {

constexpr std::size_t kBlock = 1 << 20;   // of bytes that are written at once
constexpr std::uint64_t kGlance = 8'192;  // frames between two looks at whether to go on

}  // namespace

LogSaving::LogSaving(std::shared_ptr<const LogDocument> document, const QString& path, SavedPart part,
                     QObject* parent)
    : QObject(parent),
      m_document(std::move(document)),
      m_path(path),
      m_format(formatToWrite(path.toStdString())),
      m_part(std::move(part)) {
  m_part.end = std::min(m_part.end, m_document->frames.count());
  m_part.begin = std::min(m_part.begin, m_part.end);
  m_thread = std::jthread([this](const std::stop_token& stop) { write(stop); });
}

LogSaving::~LogSaving() = default;

std::optional<std::uint64_t> LogSaving::frames() const {
  return m_part.passes ? std::nullopt : std::optional(m_part.end - m_part.begin);
}

void LogSaving::write(const std::stop_token& stop) {
  const auto end = [this](Outcome outcome, const QString& reason) {
    QMetaObject::invokeMethod(
        this, [=, this] { Q_EMIT ended(outcome, reason); }, Qt::QueuedConnection);
  };
  QSaveFile file(m_path);
  if (!file.open(QIODevice::WriteOnly)) return end(Outcome::Failed, file.errorString());
  if (!writeFrames(file, stop)) return end(Outcome::Cancelled, {});
  // A failed write is remembered by the file and fails the commit.
  if (!file.commit()) return end(Outcome::Failed, file.errorString());
  m_fraction.store(1, std::memory_order_relaxed);
  end(Outcome::Saved, {});
}

QString LogSaving::formatName() const {
  return QString::fromLatin1(m_format.name.data(), static_cast<qsizetype>(m_format.name.size()));
}

// False: given up.
bool LogSaving::writeFrames(QSaveFile& file, const std::stop_token& stop) {
  const FrameStore& frames = m_document->frames;
  std::string text;
  text.reserve(kBlock + 256);
  std::uint64_t written = 0;
  const std::uint64_t first = m_part.passes ? 0 : m_part.begin;
  for (std::uint64_t i = first; i < m_part.end;) {
    for (const Frame& frame : frames.run(i)) {
      if (i == m_part.end) break;
      if (i % kGlance == 0) {
        if (stop.stop_requested()) return false;
        m_fraction.store(static_cast<double>(i - first) / static_cast<double>(m_part.end - first),
                         std::memory_order_relaxed);
      }
      const bool passes = !m_part.passes || m_part.passes(i);
      if (i++ < m_part.begin || !passes) continue;
      m_format.write(frame, frames.channelName(frame.channel), text);
      ++written;
      if (text.size() < kBlock) continue;
      file.write(text.data(), static_cast<qint64>(text.size()));
      text.clear();
    }
  }
  file.write(text.data(), static_cast<qint64>(text.size()));
  m_written.store(written, std::memory_order_relaxed);
  return !stop.stop_requested();
}

}  // namespace deckpipe
