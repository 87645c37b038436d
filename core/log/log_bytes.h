// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of a log, all of which are there: a file, or a text in memory. Readers ask for pieces of it from
// several threads at once.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "log/mapped_memory.h"

namespace deckpipe {

class LogBytes {
 public:
  virtual ~LogBytes() = default;
  virtual std::uint64_t size() const = 0;
  // [from, to) as `piece`, which may lie in `buffer`. Returns the reason why it could not; empty if it could.
  virtual std::string get(std::uint64_t from, std::uint64_t to, std::vector<char>& buffer,
                          std::string_view& piece) const = 0;
};

class BytesInMemory final : public LogBytes {
 public:
  explicit BytesInMemory(std::string_view bytes) : m_bytes(bytes) {}
  std::uint64_t size() const override { return m_bytes.size(); }
  std::string get(std::uint64_t from, std::uint64_t to, std::vector<char>&,
                  std::string_view& piece) const override {
    piece = m_bytes.substr(from, to - from);
    return {};
  }

 private:
  std::string_view m_bytes;
};

class BytesOfFile final : public LogBytes {
 public:
  // Empty, or the reason why not in the system's words. First of all.
  std::string open(const std::string& path) { return m_file.open(path); }
  std::uint64_t size() const override { return m_file.size(); }
  std::string get(std::uint64_t from, std::uint64_t to, std::vector<char>& buffer,
                  std::string_view& piece) const override {
    if (buffer.size() < to - from) buffer.resize(to - from);
    piece = {buffer.data(), static_cast<std::size_t>(to - from)};
    return m_file.read(from, {buffer.data(), piece.size()});
  }

 private:
  InputFile m_file;
};

}  // namespace deckpipe
