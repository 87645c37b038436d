// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/text_reader.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "log/line_ends.h"
#include "log/text_appender.h"

namespace deckpipe {
namespace {

// The lines that begin in so many bytes decide whether a text is a log of a format.
constexpr std::size_t kSniffedLines = kSniffBytes - kMaxTextLine;

// Threads take blocks by number, parse them side by side and append them in turn.
class BlockReading {
 public:
  BlockReading(const LogBytes& bytes, MakeTextParser makeParser, FrameStore& store, SkippedList& skipped,
               const ReadOptions& options)
      : m_bytes(bytes),
        m_makeParser(makeParser),
        m_options(options),
        m_appender(store, skipped, options.addsUpTimes) {}

  Result<ReadSummary, ReadError> run() {
    std::thread second;
    if (m_options.threads > 1) {
      try {
        second = std::thread([this] { work(); });
      } catch (const std::system_error&) {  // no thread to be had: one does as well
      }
    }
    work();
    if (second.joinable()) second.join();
    if (!m_appender.finish() && !m_failed) end({ReadError::Kind::StoreFull, {}});
    if (m_failed) return Failure{m_error};
    ReadSummary summary{m_appender.frames(), m_appender.lines(), m_cancelled};
    summary.lastLine = m_appender.lastLine();
    return summary;
  }

 private:
  // The first blocks are small: their rows are on the screen while the rest is read.
  std::uint64_t blockStart(std::uint64_t block) const {
    const std::uint64_t size = std::max<std::uint64_t>(m_options.blockBytes, 1);
    const std::uint64_t first = std::min<std::uint64_t>(size, 64 * 1024);
    return std::min(m_bytes.size(), block == 0 ? 0 : first + (block - 1) * size);
  }

  void work() {
    const std::unique_ptr<TextParser> parser = m_makeParser();
    TextBlock block;
    ChannelMap channels;
    std::vector<char> buffer;
    for (;;) {
      std::uint64_t number = 0;
      {
        const std::lock_guard lock(m_lock);
        number = m_nextToParse++;
      }
      const std::uint64_t from = blockStart(number);
      const std::uint64_t to = blockStart(number + 1);
      if (from == to) return;
      std::string why = parseBlock(from, to, *parser, block, buffer);
      std::unique_lock lock(m_lock);
      m_turn.wait(lock, [&] { return m_ended || m_nextToAppend == number; });
      if (m_ended) return;
      if (!why.empty()) {
        end({ReadError::Kind::CannotRead, std::move(why)});
      } else if (!m_appender.append(block, channels)) {
        end({ReadError::Kind::StoreFull, {}});
      } else if (m_options.onProgress && !m_options.onProgress({to, m_bytes.size(), m_appender.frames()})) {
        m_cancelled = m_ended = true;
      }
      ++m_nextToAppend;
      lock.unlock();
      m_turn.notify_all();
    }
  }

  std::string parseBlock(std::uint64_t from, std::uint64_t to, TextParser& parser, TextBlock& block,
                         std::vector<char>& buffer) const {
    const std::uint64_t known = std::min(m_bytes.size(), to + kMaxTextLine);
    const std::uint64_t before = from == 0 ? 0 : 1;  // the byte that says whether a line begins at `from`
    std::string_view piece;
    if (std::string why = m_bytes.get(from - before, known, buffer, piece); !why.empty()) return why;
    const char* const end = piece.data() + before + (to - from);
    const char* begin = piece.data();
    if (before > 0) {
      const char* const lineEnd = findLineEnd(begin, end);
      begin = lineEnd != nullptr ? lineEnd + 1 : end;
    }
    parser.parse(begin, end, piece.data() + piece.size(), block);
    return {};
  }

  void end(ReadError error) {
    m_error = std::move(error);
    m_failed = m_ended = true;
  }

  const LogBytes& m_bytes;
  const MakeTextParser m_makeParser;
  const ReadOptions& m_options;

  std::mutex m_lock;
  std::condition_variable m_turn;
  TextAppender m_appender;
  std::uint64_t m_nextToParse = 0;
  std::uint64_t m_nextToAppend = 0;
  bool m_ended = false;
  bool m_cancelled = false;
  bool m_failed = false;
  ReadError m_error;
};

}  // namespace

Result<ReadSummary, ReadError> readText(const LogBytes& bytes, MakeTextParser makeParser, FrameStore& store,
                                        SkippedList& skipped, const ReadOptions& options) {
  return BlockReading(bytes, makeParser, store, skipped, options).run();
}

Sniff sniffText(TextParser& parser, std::string_view head, bool isWhole) {
  // What follows the last line end is judged if nothing more can come to it, or if it is too long for a
  // line.
  const std::size_t whole = wholeLines(head);
  const std::size_t known = isWhole || head.size() - whole > kMaxTextLine ? head.size() : whole;
  const char* const begin = head.data();
  TextBlock block;
  parser.parse(begin, begin + std::min(known, kSniffedLines), begin + known, block);
  if (block.isUnderstood()) return Sniff::Yes;
  if (!isWhole && known < kSniffedLines) return Sniff::Open;
  return block.skipped.unreadable() == 0 ? Sniff::Yes : Sniff::No;
}

}  // namespace deckpipe
