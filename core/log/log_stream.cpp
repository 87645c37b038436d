// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/log_stream.h"

#include <algorithm>
#include <utility>

#include "log/foreign_formats.h"

namespace deckpipe {

// As openLog() would: a format is taken once all before it have said no. So the outcome does not depend on
// how the pipe is cut.
void LogStream::decide(bool isWhole) {
  const auto format = std::ranges::find_if(m_formats, [&](const LogFormat& candidate) {
    m_sniff = candidate.sniff(m_head, isWhole);
    return m_sniff != Sniff::No;
  });
  if (format == m_formats.end()) m_sniff = Sniff::No;
  if (m_sniff != Sniff::Yes) return;
  m_format = &*format;
  if (format->stream != nullptr) m_reader = format->stream(m_target, m_options);
}

bool LogStream::feed(std::string_view bytes) { return feedPlain(m_unmarker.take(bytes)); }

bool LogStream::feedPlain(std::string_view bytes) {
  if (m_reader) return m_reader->feed(bytes);
  if (m_sniff != Sniff::Open) return false;
  m_head += bytes;
  if (m_head.size() < m_sniffAt) return true;
  decide(false);
  // Not after each of many small pieces.
  m_sniffAt = m_head.size() + std::clamp<std::size_t>(m_head.size() / 4, 1, 1024);
  if (m_reader) return m_reader->feed(std::exchange(m_head, {}));
  return m_sniff == Sniff::Open;
}

Result<ReadSummary, ReadError> LogStream::finish() {
  feedPlain(m_unmarker.finish());
  if (m_sniff == Sniff::Open) {
    decide(true);
    if (m_reader) m_reader->feed(std::exchange(m_head, {}));
  }
  if (m_sniff != Sniff::Yes)
    return Failure{ReadError{ReadError::Kind::UnknownFormat, {}, std::string(foreignFormat(m_head))}};
  ReadError error{ReadError::Kind::NoPipe};
  if (m_reader) {
    auto result = m_reader->finish();
    if (result) {
      result.value().isOwn = m_format->isOwn;
      return result;
    }
    error = result.error();
  }
  error.format = m_format->name;
  return Failure{std::move(error)};
}

}  // namespace deckpipe
