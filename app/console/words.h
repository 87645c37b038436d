// SPDX-License-Identifier: GPL-3.0-or-later
// Words that notices (notice_of.h) and the facts of the strip (status_text.h) share.
#pragma once

#include <QCoreApplication>

#include "model/bus_rates.h"
#include "panel/common/notice_bar.h"
#include "session/snapshot.h"

namespace deckpipe {

struct NoticeText {
  Q_DECLARE_TR_FUNCTIONS(NoticeText)
};
struct StatusText {
  Q_DECLARE_TR_FUNCTIONS(StatusText)
};

using From = SourceStatus::Kind;
using Progress = SourceStatus::Progress;

inline constexpr int kJ1939BitRate = 250'000;

// The notice about the open log of a file, or about the open link; without text if there is none.
Notice fileNotice(const Snapshot& snapshot);
Notice linkNotice(const Snapshot& snapshot, const BusRates& rates);
// "truck.log cannot be read: …"
QString unreadableText(const QString& path, const SourceError& why);

}  // namespace deckpipe
