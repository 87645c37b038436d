// SPDX-License-Identifier: GPL-3.0-or-later
// What the log room wants from the operating system, and nothing else: large zeroed pieces of memory, the
// same backed by a temporary file that has no name, and reading a file at an offset. The .cpp is POSIX;
// another system replaces that one file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace deckpipe {

// A piece of memory that is given back when this goes; empty where the system had none.
class MappedMemory {
 public:
  MappedMemory() = default;
  MappedMemory(MappedMemory&& other) noexcept
      : m_start(std::exchange(other.m_start, nullptr)), m_size(std::exchange(other.m_size, 0)) {}
  MappedMemory& operator=(MappedMemory&& other) noexcept {
    std::swap(m_start, other.m_start);
    std::swap(m_size, other.m_size);
    return *this;
  }
  ~MappedMemory();

  static MappedMemory allocate(std::size_t size);

  std::byte* start() const { return m_start; }
  explicit operator bool() const { return m_start != nullptr; }

 private:
  friend class SpillFile;
  MappedMemory(std::byte* start, std::size_t size) : m_start(start), m_size(size) {}

  std::byte* m_start = nullptr;
  std::size_t m_size = 0;
};

// A temporary file, unlinked as soon as it is open, whose pieces are mapped one after another. Its disk space
// is reserved before a piece is handed out: a full disk is an empty piece, never a crash on a later write.
class SpillFile {
 public:
  SpillFile() = default;
  SpillFile(const SpillFile&) = delete;
  SpillFile& operator=(const SpillFile&) = delete;
  ~SpillFile();

  // The file is created in `folder` when the first piece is asked for. `size` is a multiple of the page size.
  MappedMemory next(std::size_t size, const std::string& folder);

 private:
  int m_file = -1;
  std::uint64_t m_size = 0;
};

// A file that is only read, at any offset, from any thread. Read and not mapped: a file that shrinks, or a
// memory stick that is pulled out, is then an error to report and not a fault that ends the program.
class InputFile {
 public:
  InputFile() = default;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  // Empty, or the reason why not in the system's words.
  std::string open(const std::string& path);
  std::uint64_t size() const { return m_size; }
  // All of `into`, or the reason why not: the system's words, or that the file became shorter.
  std::string read(std::uint64_t offset, std::span<char> into) const;

 private:
  int m_file = -1;
  std::uint64_t m_size = 0;
};

}  // namespace deckpipe
