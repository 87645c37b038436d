// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mark_keeper.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <string>

#include "log/sidecar.h"

namespace deckpipe {
namespace {

QDateTime modifiedOf(const QString& path) { return QFileInfo(path).lastModified(); }

}  // namespace

void MarkKeeper::opened(const QString& path, const ReadSummary& read) {
  *this = {};
  m_path = QFile::decodeName(sidecarPath(QFile::encodeName(path).toStdString()).c_str());
  m_modified = modifiedOf(m_path);
  if (!read.mayHaveSidecar) {
    m_reason = tr("nothing is added to a recording that is opened");
  } else if (read.sidecarFault) {
    m_reason = tr("the file of notes beside the log could not be used, and is not replaced");
  } else if (read.newerParts > 0) {
    m_reason = tr("the file of notes beside the log is of a newer version, and is not replaced");
  } else if (m_modified.isValid() != read.hasSidecar) {
    m_reason = tr("the file of notes beside the log was changed meanwhile, and is not replaced");
  }
}

QString MarkKeeper::keep(const LogDocument& log) {
  if (!m_reason.isEmpty()) return m_reason;
  if (modifiedOf(m_path) != m_modified)
    return tr("the file of notes beside the log was changed meanwhile, and is not replaced");
  const std::string text = SidecarMaker::textOf(log.frames, log.notes);
  QSaveFile file(m_path);
  if (!file.open(QIODevice::WriteOnly)) return file.errorString();
  file.write(text.data(), static_cast<qint64>(text.size()));
  if (!file.commit()) return file.errorString();
  m_modified = modifiedOf(m_path);
  return {};
}

}  // namespace deckpipe
