// SPDX-License-Identifier: GPL-3.0-or-later
// The sidecars (log/sidecar.h) that this program read or wrote, as they were then. One that another window wrote since
// holds marks that are nowhere here: it is not replaced. Any thread may call this.
#pragma once

#include <QDateTime>
#include <QString>
#include <map>
#include <memory>
#include <mutex>

#include "state/log_view.h"

namespace deckpipe {

// When the sidecar of this path was written; invalid if there is none.
QDateTime sidecarModified(const QString& sidecar);

class KnownSidecars {
 public:
  // It was read when it was that of `modified`.
  void read(const QString& sidecar, const QDateTime& modified);
  // It was written just now, or removed. `whole`: with all notes of this log; null if of a part of a log.
  void wrote(const QString& sidecar, const std::shared_ptr<const LogDocument>& whole);
  // Whether nothing is lost if it is replaced: there is none, or it is as it was read or written last.
  bool mayReplace(const QString& sidecar) const;
  // Whether what is there, if only nothing, was written by wrote() for all of this log.
  bool isAllOf(const LogDocument& log, const QString& sidecar) const;

 private:
  struct Known {
    QDateTime modified;
    std::weak_ptr<const LogDocument> whole;
  };
  static QString keyOf(const QString& sidecar);
  void set(const QString& sidecar, Known known);

  mutable std::mutex m_lock;
  std::map<QString, Known> m_known;
};

}  // namespace deckpipe
