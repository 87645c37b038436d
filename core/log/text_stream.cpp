// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/text_stream.h"

#include "log/line_ends.h"

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
  if (m_isSkipping) skip();
  if (const std::size_t whole = wholeLines(m_pending); whole > 0) take(whole);
  if (!m_isFull && m_pending.size() > kMaxTextLine) {
    m_appender.appendTooLong();
    m_isSkipping = true;
    skip();
  }
  return !m_isFull;
}

// What is left of a line that was too long.
void TextStream::skip() {
  const char* const begin = m_pending.data();
  const char* const lineEnd = findLineEnd(begin, begin + m_pending.size());
  m_isSkipping = lineEnd == nullptr;
  const std::size_t unknown = m_pending.ends_with('\r') ? 1 : 0;
  m_pending.erase(0,
                  m_isSkipping ? m_pending.size() - unknown : static_cast<std::size_t>(lineEnd - begin) + 1);
}

Result<ReadSummary, ReadError> TextStream::finish() {
  if (!m_isFull && !m_isSkipping && !m_pending.empty()) take(m_pending.size());
  if (!m_appender.finish()) m_isFull = true;
  if (m_isFull) return Failure{ReadError{ReadError::Kind::StoreFull, {}}};
  ReadSummary summary{m_appender.frames(), m_appender.lines(), false};
  summary.lastLine = m_appender.lastLine();
  return summary;
}

}  // namespace deckpipe
