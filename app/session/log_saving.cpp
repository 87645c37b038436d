// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/log_saving.h"

#include <QFile>
#include <algorithm>
#include <string>
#include <utility>

#include "log/journal_file.h"

namespace deckpipe {
namespace {

constexpr std::size_t kBlock = 1 << 20;   // of bytes that are written at once
constexpr std::uint64_t kGlance = 8'192;  // frames between two looks at whether to go on

}  // namespace

LogSaving::LogSaving(std::shared_ptr<const LogDocument> document, const QString& path, SavedPart part,
                     std::shared_ptr<KnownSidecars> sidecars)
    : m_document(std::move(document)),
      m_notes(m_document->notes.count()),
      m_ranUntil(m_document->notes.ranUntil()),
      m_path(path),
      m_format(formatToWrite(path.toStdString())),
      m_part(std::move(part)),
      m_sidecars(std::move(sidecars)) {
  const std::uint64_t count = m_document->frames.count();
  m_isToEnd = m_part.end >= count;
  m_part.end = std::min(m_part.end, count);
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
  // The name would go to the copy, and what is received to a file without one.
  if (isBeingWritten(QFile::encodeName(m_path).toStdString())) return end(Outcome::IsGrowing, {});
  const QString sidecar = sidecarOf(m_path);
  if (!m_sidecars->mayReplace(sidecar)) return end(Outcome::SidecarUnknown, {});
  WholeFile file(m_path);
  if (!file.open()) return end(Outcome::Failed, file.reason());
  const auto writer = m_format.makeWriter();
  if (!writeFrames(file, *writer, stop)) return end(Outcome::Cancelled, {});
  if (!file.reason().isEmpty()) return end(Outcome::Failed, file.reason());
  if (!m_sidecars->mayReplace(sidecar)) return end(Outcome::SidecarUnknown, {});
  if (!file.commit()) return end(Outcome::Failed, file.reason());
  const QString reason = writeSidecar(writer->beside());
  const bool isWhole = m_isToEnd && m_part.begin == 0 && !m_part.passes;
  if (reason.isEmpty()) m_sidecars->wrote(sidecar, isWhole ? m_document : nullptr);
  m_fraction.store(1, std::memory_order_relaxed);
  end(Outcome::Saved, reason);
}

// The sidecar of a log that was there before would be of another log.
QString LogSaving::writeSidecar(const std::string& text) {
  const QString path = sidecarOf(m_path);
  if (text.empty()) {
    QFile old(path);
    return !old.exists() || old.remove() ? QString() : old.errorString();
  }
  const QString reason = writeWholeFile(path, text);
  m_hasSidecar.store(reason.isEmpty(), std::memory_order_relaxed);
  return reason;
}

// False: given up. After a fault nothing more is written.
bool LogSaving::writeFrames(WholeFile& file, LogWriter& writer, const std::stop_token& stop) {
  std::string text;
  text.reserve(kBlock + 256);
  const PartWriter::Span span{m_part.begin,  m_part.end, m_isToEnd,     bool(m_part.passes),
                              m_part.filter, m_ranUntil, m_part.missing};
  PartWriter part(*m_document, span, m_part.labels, writer, text);
  const std::uint64_t first = m_part.passes ? 0 : m_part.begin;
  for (std::uint64_t i = first; i < m_part.end; ++i) {
    if (i % kGlance == 0) {
      if (stop.stop_requested()) return false;
      m_fraction.store(static_cast<double>(i - first) / static_cast<double>(m_part.end - first),
                       std::memory_order_relaxed);
    }
    const bool passes = !m_part.passes || m_part.passes(i);
    if (i < m_part.begin) continue;
    if (!passes) {
      part.heldBack(i);
    } else if (!part.frame(i, stop)) {
      return false;
    }
    if (text.size() < kBlock) continue;
    if (!file.write(text)) return true;
    text.clear();
  }
  part.end();
  file.write(text);
  m_written.store(part.written(), std::memory_order_relaxed);
  m_added.store(part.added(), std::memory_order_relaxed);
  return !stop.stop_requested();
}

}  // namespace deckpipe
