// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "log/candump.h"
#include "log/candump_appender.h"
#include "log/candump_parser.h"
#include "log/mapped_memory.h"

namespace deckpipe {
namespace {

// A text in memory or in a file: both hand out [from, to), the file through a buffer of the asker's. What
// get() returns is the reason why it could not.
class TextSource {
 public:
  explicit TextSource(std::string_view text) : m_text(text) {}
  std::uint64_t size() const { return m_text.size(); }
  std::string get(std::uint64_t from, std::uint64_t to, std::vector<char>&, std::string_view& piece) const {
    piece = m_text.substr(from, to - from);
    return {};
  }

 private:
  std::string_view m_text;
};

class FileSource {
 public:
  explicit FileSource(const InputFile& file) : m_file(file) {}
  std::uint64_t size() const { return m_file.size(); }
  std::string get(std::uint64_t from, std::uint64_t to, std::vector<char>& buffer,
                  std::string_view& piece) const {
    if (buffer.size() < to - from) buffer.resize(to - from);
    piece = {buffer.data(), static_cast<std::size_t>(to - from)};
    return m_file.read(from, {buffer.data(), piece.size()});
  }

 private:
  const InputFile& m_file;
};

// Threads take blocks by number, parse them side by side and append them in turn.
template <typename Source>
class BlockReading {
 public:
  BlockReading(const Source& source, FrameStore& store, UnkeptList& unkept, const ReadOptions& options)
      : m_source(source), m_options(options), m_appender(store, unkept) {}

  Result<ReadSummary, ReadError> run() {
    std::vector<char> buffer;
    std::string_view head;
    const std::uint64_t headSize = std::min<std::uint64_t>(m_source.size(), kCandumpHead);
    if (std::string why = m_source.get(0, headSize, buffer, head); !why.empty()) {
      return Failure{ReadError{ReadError::Kind::CannotRead, std::move(why)}};
    }
    if (!looksLikeCandump(head))
      return Failure{ReadError{ReadError::Kind::NotThisFormat, std::string(kNotCandump)}};
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
    return ReadSummary{m_appender.frames(), m_appender.lines(), m_cancelled};
  }

 private:
  // The first blocks are small: their rows are on the screen while the rest is read.
  std::uint64_t blockStart(std::uint64_t block) const {
    const std::uint64_t size = std::max<std::uint64_t>(m_options.blockBytes, 1);
    const std::uint64_t first = std::min<std::uint64_t>(size, 64 * 1024);
    return std::min(m_source.size(), block == 0 ? 0 : first + (block - 1) * size);
  }

  void work() {
    CandumpParser parser;
    CandumpBlock block;
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
      std::string why = parseBlock(from, to, parser, block, buffer);
      std::unique_lock lock(m_lock);
      m_turn.wait(lock, [&] { return m_ended || m_nextToAppend == number; });
      if (m_ended) return;
      if (!why.empty()) {
        end({ReadError::Kind::CannotRead, std::move(why)});
      } else if (!m_appender.append(block, channels)) {
        end({ReadError::Kind::StoreFull, {}});
      } else if (m_options.onProgress && !m_options.onProgress({to, m_source.size(), m_appender.frames()})) {
        m_cancelled = m_ended = true;
      }
      ++m_nextToAppend;
      lock.unlock();
      m_turn.notify_all();
    }
  }

  std::string parseBlock(std::uint64_t from, std::uint64_t to, CandumpParser& parser, CandumpBlock& block,
                         std::vector<char>& buffer) const {
    const std::uint64_t known = std::min(m_source.size(), to + kMaxCandumpLine);
    const std::uint64_t before = from == 0 ? 0 : 1;  // the byte that says whether a line begins at `from`
    std::string_view piece;
    if (std::string why = m_source.get(from - before, known, buffer, piece); !why.empty()) return why;
    const char* const end = piece.data() + before + (to - from);
    const char* begin = piece.data();
    if (before > 0) {
      const auto* feed = static_cast<const char*>(std::memchr(begin, '\n', to - from));
      begin = feed ? feed + 1 : end;
    }
    parser.parse(begin, end, piece.data() + piece.size(), block);
    return {};
  }

  void end(ReadError error) {
    m_error = std::move(error);
    m_failed = m_ended = true;
  }

  const Source& m_source;
  const ReadOptions& m_options;

  std::mutex m_lock;
  std::condition_variable m_turn;
  CandumpAppender m_appender;
  std::uint64_t m_nextToParse = 0;
  std::uint64_t m_nextToAppend = 0;
  bool m_ended = false;
  bool m_cancelled = false;
  bool m_failed = false;
  ReadError m_error;
};

}  // namespace

bool looksLikeCandump(std::string_view head) {
  CandumpParser parser;
  CandumpBlock block;
  const char* const begin = head.data();
  parser.parse(begin, begin + std::min(head.size(), kCandumpSniff), begin + head.size(), block);
  return block.count > 0 || block.unkept.understood() > 0 || block.unkept.unreadable() == 0;
}

Result<ReadSummary, ReadError> readCandump(const std::string& path, FrameStore& store, UnkeptList& unkept,
                                           const ReadOptions& options) {
  InputFile file;
  if (std::string why = file.open(path); !why.empty()) {
    return Failure{ReadError{ReadError::Kind::CannotOpen, std::move(why)}};
  }
  const FileSource source(file);
  return BlockReading<FileSource>(source, store, unkept, options).run();
}

Result<ReadSummary, ReadError> readCandumpText(std::string_view text, FrameStore& store, UnkeptList& unkept,
                                               const ReadOptions& options) {
  const TextSource source(text);
  return BlockReading<TextSource>(source, store, unkept, options).run();
}

}  // namespace deckpipe
