// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "log/journal_bytes.h"

namespace deckpipe {
namespace {

JournalFault fault(JournalFault::Kind kind) {
  const int number = errno;
  const bool isFull = number == ENOSPC || number == EDQUOT || number == EFBIG;
  return {isFull ? JournalFault::Kind::DiskFull : kind, std::generic_category().message(number)};
}
JournalFault writeFault() { return fault(JournalFault::Kind::CannotWrite); }

class Descriptor {
 public:
  explicit Descriptor(int file) : m_file(file) {}
  ~Descriptor() {
    if (m_file >= 0) ::close(m_file);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return m_file; }
  explicit operator bool() const { return m_file >= 0; }

 private:
  int m_file;
};

// Of the open file, not of the process, so that a program sees its own; gone when the file is closed.
struct flock wholeFile(short type) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  return lock;
}
bool lockForWriting(int file) {
  struct flock lock = wholeFile(F_WRLCK);
  return ::fcntl(file, F_OFD_SETLK, &lock) == 0;
}

// A file that was opened with O_APPEND is written at its end, whatever the offset (Linux).
JournalFault writeAt(int file, std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return writeFault();
    offset += static_cast<std::uint64_t>(n);
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return {};
}

// It is opened with O_APPEND: after another program has cut it, it stays shorter than what was written, so that
// check() sees that later too.
class PosixJournalFile final : public JournalFile {
 public:
  PosixJournalFile(int file, std::string path) : m_file(file), m_path(std::move(path)) {}

  std::string path() const override { return m_path; }

  JournalFault check() override {
    struct stat facts {};
    if (::fstat(m_file.get(), &facts) != 0) return writeFault();
    if (facts.st_nlink == 0) return {JournalFault::Kind::Removed, m_path};
    followName(facts);
    if (static_cast<std::uint64_t>(facts.st_size) != m_size) return {JournalFault::Kind::Changed, m_path};
    return {};
  }

  JournalFault append(std::uint64_t offset, std::span<const std::uint8_t> bytes) override {
    if (m_size != offset && !cutTo(offset)) return writeFault();
    m_size = offset;
    JournalFault fault = writeAt(m_file.get(), offset, bytes);
    if (!fault) {
      m_size = offset + bytes.size();
    } else if (!cutTo(offset)) {
      m_size = offset + bytes.size();  // not known: the next call cuts it
    }
    return fault;
  }

  // The first time its name too, which stands in the folder.
  JournalFault sync() override {
    if (::fdatasync(m_file.get()) != 0) return writeFault();
    if (!m_isNamed && !syncName(m_path)) return writeFault();
    m_isNamed = true;
    return {};
  }

 private:
  // Never makes it longer, which would hide that another program has cut it.
  bool cutTo(std::uint64_t size) {
    struct stat facts {};
    if (::fstat(m_file.get(), &facts) != 0) return false;
    return static_cast<std::uint64_t>(facts.st_size) <= size ||
           ::ftruncate(m_file.get(), static_cast<off_t>(size)) == 0;
  }
  // Linux tells what the name is now.
  void followName(const struct stat& facts) {
    const auto isIt = [&facts](const std::string& path) {
      struct stat named {};
      return ::stat(path.c_str(), &named) == 0 && named.st_dev == facts.st_dev &&
             named.st_ino == facts.st_ino;
    };
    if (isIt(m_path)) return;
    std::array<char, 4'096> name{};
    const std::string link = "/proc/self/fd/" + std::to_string(m_file.get());
    const ssize_t length = ::readlink(link.c_str(), name.data(), name.size());
    if (length <= 0) return;
    if (std::string path(name.data(), static_cast<std::size_t>(length)); isIt(path)) m_path = std::move(path);
  }

  const Descriptor m_file;
  std::string m_path;
  std::uint64_t m_size = 0;
  bool m_isNamed = false;
};

}  // namespace

MadeJournalFile createJournalFile(const std::string& path) {
  constexpr int kMaxOfOneName = 1'000;
  for (int number = 1; number <= kMaxOfOneName; ++number) {
    const std::string name = path + (number == 1 ? "" : "-" + std::to_string(number)) + ".deckpipe";
    const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
    if (file < 0 && errno == EEXIST) continue;
    if (file < 0) break;
    // Nobody else knows it yet. Where a file system has no locks, it is a recording all the same.
    (void)lockForWriting(file);
    return MadeJournalFile(std::make_unique<PosixJournalFile>(file, name));
  }
  return Failure{fault(JournalFault::Kind::CannotCreate)};
}

bool syncName(const std::string& path) {
  const std::string folder = path.substr(0, path.rfind('/') + 1);
  const Descriptor opened(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return opened && ::fsync(opened.get()) == 0;
}

bool isBeingWritten(const std::string& path) {
  // A pipe that nobody writes must not hold us up.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct flock lock = wholeFile(F_RDLCK);
  return file && ::fcntl(file.get(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

JournalFault markJournalSaved(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (!file || !lockForWriting(file.get())) return writeFault();
  std::array<std::uint8_t, JournalHead::kBytes> bytes{};
  JournalHead head;
  if (::pread(file.get(), bytes.data(), bytes.size(), 0) != ssize_t{JournalHead::kBytes} ||
      !takeJournalHead(bytes, head) || head.major != JournalHead::kMajor)
    return {JournalFault::Kind::CannotWrite, std::generic_category().message(EINVAL)};
  head.isSaved = true;
  JournalBytes written;
  appendJournalHead(written, head);
  if (JournalFault fault = writeAt(file.get(), 0, written)) return fault;
  return ::fdatasync(file.get()) == 0 ? JournalFault{} : writeFault();
}

}  // namespace deckpipe
