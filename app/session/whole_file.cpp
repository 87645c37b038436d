// SPDX-License-Identifier: GPL-3.0-or-later
// The .cpp is POSIX, as in log/mapped_memory.h.
#include "session/whole_file.h"

#include <unistd.h>

#include <QFile>
#include <QFileInfo>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "log/journal_file.h"

namespace deckpipe {
namespace {

// Not every file system can be told to put a file on the disk, nor any a folder that may be written and not read.
bool cannotBeTold(int fault) {
  return fault == EINVAL || fault == EROFS || fault == ENOSYS || fault == EACCES;
}

}  // namespace

// A disk that is nearly full takes a part and gives no reason: the rest is tried for it.
QString writeAll(QFileDevice& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const qint64 n = file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    if (n <= 0) return file.errorString();
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return {};
}

// Qt takes a link to an open pipe (/dev/stdout) for a link to nothing, and would put a file in its place.
bool WholeFile::open() {
  std::error_code none;
  const auto there = std::filesystem::status(QFile::encodeName(m_file.fileName()).toStdString(), none);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there)) {
    const bool isFolder = std::filesystem::is_directory(there);
    m_reason = QString::fromStdString(std::generic_category().message(isFolder ? EISDIR : EINVAL));
    return false;
  }
  if (!m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) m_reason = m_file.errorString();
  return m_reason.isEmpty();
}

bool WholeFile::write(std::string_view bytes) {
  if (m_reason.isEmpty()) m_reason = writeAll(m_file, bytes);
  return m_reason.isEmpty();
}

// Its name stands in the folder, which of a link is that of the file it leads to.
bool WholeFile::commit() {
  if (!m_reason.isEmpty()) return false;
  const auto wordsOfFault = [] {
    return cannotBeTold(errno) ? QString() : QString::fromStdString(std::generic_category().message(errno));
  };
  if (::fsync(m_file.handle()) != 0) m_reason = wordsOfFault();
  if (!m_reason.isEmpty()) return false;
  if (!m_file.commit()) {
    m_reason = m_file.errorString();
  } else if (!syncName(QFile::encodeName(QFileInfo(m_file.fileName()).canonicalFilePath()).toStdString())) {
    m_reason = wordsOfFault();
  }
  return m_reason.isEmpty();
}

}  // namespace deckpipe
