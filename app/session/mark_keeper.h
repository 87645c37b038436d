// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the marks that a person makes in a log of a file: writes the sidecar beside the log (sidecar.h) anew, with all
// notes of the log. The session calls it after each mark. A sidecar that is not the one that was read, or that was not
// read whole, is never replaced.
#pragma once

#include <QCoreApplication>
#include <QDateTime>
#include <QString>

#include "log/reading.h"
#include "state/log_view.h"

namespace deckpipe {

class MarkKeeper {
  Q_DECLARE_TR_FUNCTIONS(MarkKeeper)
 public:
  // The log of this file was read. Before the first keep().
  void opened(const QString& path, const ReadSummary& read);
  // The reason why the notes are in memory alone; empty if they are in the file.
  QString keep(const LogDocument& log);

 private:
  QString m_path;        // of the sidecar
  QString m_reason;      // why it must not be written; empty if it may
  QDateTime m_modified;  // when it was read or written; invalid if there was none
};

}  // namespace deckpipe
