// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/mapped_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace deckpipe {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

std::string systemWords(int number) { return std::generic_category().message(number); }

}  // namespace

MappedMemory::~MappedMemory() {
  if (m_start) munmap(m_start, m_size);
}

// Aligned to huge pages and marked for them: filling a store is otherwise bound by page faults.
MappedMemory MappedMemory::allocate(std::size_t size) {
  void* whole = mmap(nullptr, size + kHugePage, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (whole == MAP_FAILED) return {};
  auto* start = static_cast<std::byte*>(whole);
  const std::size_t before = (kHugePage - reinterpret_cast<std::uintptr_t>(start) % kHugePage) % kHugePage;
  if (before > 0) munmap(start, before);
  if (before < kHugePage) munmap(start + before + size, kHugePage - before);
#ifdef MADV_HUGEPAGE
  madvise(start + before, size, MADV_HUGEPAGE);
#endif
  return {start + before, size};
}

SpillFile::~SpillFile() {
  if (m_file >= 0) close(m_file);
}

MappedMemory SpillFile::next(std::size_t size, const std::string& folder) {
  if (m_file < 0) {
    std::string name = folder + "/deckpipe-XXXXXX";
    m_file = mkostemp(name.data(), O_CLOEXEC);
    if (m_file < 0) return {};
    unlink(name.c_str());
  }
  const auto offset = static_cast<off_t>(m_size);
  if (posix_fallocate(m_file, offset, static_cast<off_t>(size)) != 0) return {};
  void* start = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, m_file, offset);
  if (start == MAP_FAILED) return {};
  m_size += size;
  return {static_cast<std::byte*>(start), size};
}

InputFile::~InputFile() {
  if (m_file >= 0) close(m_file);
}

std::string InputFile::open(const std::string& path) {
  // A pipe without a writer must not hold us up before we know that it is one.
  m_file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat facts {};
  if (m_file < 0 || fstat(m_file, &facts) != 0) return systemWords(errno);
  if (!S_ISREG(facts.st_mode)) return systemWords(S_ISDIR(facts.st_mode) ? EISDIR : EINVAL);
  m_size = static_cast<std::uint64_t>(facts.st_size);
  return {};
}

std::string InputFile::read(std::uint64_t offset, std::span<char> into) const {
  while (!into.empty()) {
    const ssize_t n = pread(m_file, into.data(), into.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return systemWords(errno);
    if (n == 0) return "the file became shorter while it was read";
    offset += static_cast<std::uint64_t>(n);
    into = into.subspan(static_cast<std::size_t>(n));
  }
  return {};
}

}  // namespace deckpipe
