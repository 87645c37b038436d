// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole and on the disk, or not at all. It keeps the system's words why it could not be written as
// they are at the fault: QSaveFile forgets them when it is committed, and says nothing of what fsync() says.
#pragma once

#include <QSaveFile>
#include <QString>
#include <string_view>

namespace deckpipe {

class WholeFile {
 public:
  explicit WholeFile(const QString& path) : m_file(path) {}

  bool open();
  // False after a fault, now or before.
  bool write(std::string_view bytes);
  // Puts it in the place of what had its name. False after a fault, now or before: what was there stays, or if only its
  // folder cannot be put on the disk, nobody knows which of the two is there after a loss of power.
  bool commit();
  // The system's words; empty as long as nothing failed.
  const QString& reason() const { return m_reason; }

 private:
  QSaveFile m_file;
  QString m_reason;
};

// Writes to a file that was opened without a buffer. Returns the system's words why not all of it was written.
QString writeAll(QFileDevice& file, std::string_view bytes);

}  // namespace deckpipe
