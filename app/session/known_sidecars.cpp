// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/known_sidecars.h"

#include <QDir>
#include <QFileInfo>
#include <utility>

namespace deckpipe {

QDateTime sidecarModified(const QString& sidecar) { return QFileInfo(sidecar).lastModified(); }

// One file has one key, whichever way its folder is named.
QString KnownSidecars::keyOf(const QString& sidecar) {
  const QFileInfo file(sidecar);
  const QString folder = file.dir().canonicalPath();
  return folder.isEmpty() ? file.absoluteFilePath() : folder + QLatin1Char('/') + file.fileName();
}

void KnownSidecars::set(const QString& sidecar, Known known) {
  const QString key = keyOf(sidecar);
  const std::lock_guard guard(m_lock);
  m_known.insert_or_assign(key, std::move(known));
}

void KnownSidecars::read(const QString& sidecar, const QDateTime& modified) { set(sidecar, {modified, {}}); }

void KnownSidecars::wrote(const QString& sidecar, const std::shared_ptr<const LogDocument>& whole) {
  set(sidecar, {sidecarModified(sidecar), whole});
}

bool KnownSidecars::mayReplace(const QString& sidecar) const {
  if (!QFileInfo(sidecar).isFile()) return true;
  const QString key = keyOf(sidecar);
  const std::lock_guard guard(m_lock);
  const auto known = m_known.find(key);
  return known != m_known.end() && known->second.modified == sidecarModified(sidecar);
}

bool KnownSidecars::isAllOf(const LogDocument& log, const QString& sidecar) const {
  const QString key = keyOf(sidecar);
  const std::lock_guard guard(m_lock);
  const auto known = m_known.find(key);
  return known != m_known.end() && known->second.whole.lock().get() == &log &&
         known->second.modified == sidecarModified(sidecar);
}

}  // namespace deckpipe
