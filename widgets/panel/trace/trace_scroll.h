// SPDX-License-Identifier: GPL-3.0-or-later
// Which rows of a log the trace shows, and what the scroll bar says of it: 64-bit rows, an int bar. Up to
// kBarMost positions the bar is exact; beyond, it is a share, while wheel and keys still move by single rows.
// Plain numbers, tested without a window.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace deckpipe {

struct TraceScroll {
  static constexpr int kBarMost = 1 << 30;

  std::uint64_t rows = 0;
  std::uint64_t pageRows = 1;  // that are wholly seen at once
  std::uint64_t top = 0;

  std::uint64_t lastTop() const { return rows > pageRows ? rows - pageRows : 0; }
  bool isAtEnd() const { return top >= lastTop(); }

  void moveTo(std::uint64_t row) { top = std::min(row, lastTop()); }
  void moveBy(std::int64_t by) {
    const std::uint64_t far = by < 0 ? 0 - static_cast<std::uint64_t>(by) : static_cast<std::uint64_t>(by);
    if (by < 0) {
      moveTo(top - std::min(top, far));
    } else {
      moveTo(top + std::min(lastTop() - std::min(top, lastTop()), far));
    }
  }
  // As little as is needed for the row to be wholly seen.
  void show(std::uint64_t row) {
    if (row < top) {
      moveTo(row);
    } else if (row - top >= pageRows) {
      moveTo(row - pageRows + 1);
    }
  }
  bool shows(std::uint64_t row) const { return row >= top && row - top < pageRows; }

  int barMaximum() const { return static_cast<int>(std::min<std::uint64_t>(lastTop(), kBarMost)); }
  int barPage() const { return static_cast<int>(std::min<std::uint64_t>(pageRows, kBarMost)); }
  bool isBarExact() const { return lastTop() <= kBarMost; }
  int barValue() const {
    if (isBarExact()) return static_cast<int>(top);
    return static_cast<int>(std::llround(static_cast<double>(top) / rowsPerStep()));
  }
  // The row for a place of the bar; both ends are the log's.
  std::uint64_t topOf(int value) const {
    if (value <= 0) return 0;
    if (value >= barMaximum()) return lastTop();
    if (isBarExact()) return static_cast<std::uint64_t>(value);
    return std::min(lastTop(), static_cast<std::uint64_t>(std::llround(value * rowsPerStep())));
  }

 private:
  double rowsPerStep() const { return static_cast<double>(lastTop()) / kBarMost; }
};

}  // namespace deckpipe
