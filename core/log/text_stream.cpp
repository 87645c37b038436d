// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/text_stream.h"

namespace deckpipe {

// The lines in the first bytes of what is pending.
void TextStream::take(std::size_t size) {
  const char* const begin = m_pending.data();
  m_parser->parse(begin, begin + size, begin + size, m_block);
  m_isFull = !m_appender.append(m_block, m_channels);
  m_pending.erase(0, size);
}

bool TextStream::feed(std::string_view bytes) {
  if (m_isFull) return false;
  m_pending.append(bytes);
  if (m_isSkipping) {
    const std::size_t feed = m_pending.find('\n');
    m_isSkipping = feed == std::string::npos;
    m_pending.erase(0, m_isSkipping ? m_pending.size() : feed + 1);
  }
  if (const std::size_t feed = m_pending.rfind('\n'); feed != std::string::npos) take(feed + 1);
  if (!m_isFull && m_pending.size() > kMaxTextLine) {
    m_appender.appendTooLong();
    m_isSkipping = true;
    m_pending.clear();
  }
  return !m_isFull;
}

Result<ReadSummary, ReadError> TextStream::finish() {
  if (!m_isFull && !m_pending.empty()) take(m_pending.size());
  if (!m_appender.finish()) m_isFull = true;
  if (m_isFull) return Failure{ReadError{ReadError::Kind::StoreFull, {}}};
  return ReadSummary{m_appender.frames(), m_appender.lines(), false};
}

}  // namespace deckpipe
