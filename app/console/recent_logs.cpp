// SPDX-License-Identifier: GPL-3.0-or-later
#include "recent_logs.h"

#include <QFileInfo>
#include <QSettings>

namespace deckpipe {
namespace {

const QString kKey = QStringLiteral("logs/recent");

}  // namespace

QStringList recentLogs() { return QSettings().value(kKey).toStringList(); }

void rememberLog(const QString& path) {
  const QString whole = QFileInfo(path).absoluteFilePath();
  QStringList logs = recentLogs();
  logs.removeAll(whole);
  logs.prepend(whole);
  QSettings().setValue(kKey, logs.mid(0, kMaxRecentLogs));
}

void forgetLogs() { QSettings().remove(kKey); }

}  // namespace deckpipe
