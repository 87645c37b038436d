// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of a log: what its own stamps say, where they are dates, and where in the log the clock says a time.
#pragma once

#include <QDateTime>
#include <cstdint>
#include <optional>
#include <vector>

#include "state/log_view.h"

namespace deckpipe {

class LogClock {
 public:
  // Reads a few frames at each jump of the clock.
  explicit LogClock(const LogView& view);

  // Local times; invalid where no stamp is a date.
  QDateTime first() const;
  QDateTime last() const;
  bool hasDates() const { return !m_pieces.empty(); }
  bool spansDays() const { return first().date() != last().date(); }

  // Where the clock first says this local time; nothing where it never does.
  std::optional<Instant> at(const QDateTime& local) const;
  // The dates on which the clock says this time of day.
  std::vector<QDate> datesOf(QTime time) const;

 private:
  // The clock runs on from `stamp` at `begin` for `length`, as log time does.
  struct Piece {
    std::int64_t stamp = 0;  // ns since 1970
    Instant begin;
    Duration length{0};
    std::int64_t end() const { return saturatedPlus(stamp, length.count()); }
  };
  std::vector<Piece> m_pieces;  // from one jump of the clock to the next
};

}  // namespace deckpipe
