// SPDX-License-Identifier: GPL-3.0-or-later
// An append-only list whose elements never move: one writer, readers on other threads while it grows.
// FrameStore keeps its chunks and its offsets in these. A reader sees every element below the size() that
// it asked for; elements are not changed after they were appended.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <memory>
#include <utility>

namespace deckpipe {

template <typename T>
class StableList {
 public:
  std::size_t size() const { return m_size.load(std::memory_order_acquire); }

  const T& operator[](std::size_t i) const {
    const auto [segment, offset] = place(i);
    return m_segments[segment][offset];
  }

  void append(T value) {
    const std::size_t size = m_size.load(std::memory_order_relaxed);
    const auto [segment, offset] = place(size);
    if (offset == 0) m_segments[segment] = std::make_unique<T[]>(kFirst << segment);
    m_segments[segment][offset] = std::move(value);
    m_size.store(size + 1, std::memory_order_release);
  }

 private:
  // Segment k holds kFirst << k elements, so that no element ever moves and the table stays short.
  static constexpr std::size_t kFirst = 8;

  static std::pair<std::size_t, std::size_t> place(std::size_t i) {
    const std::size_t n = i / kFirst + 1;
    const auto segment = static_cast<std::size_t>(std::bit_width(n)) - 1;
    return {segment, i - kFirst * ((std::size_t{1} << segment) - 1)};
  }

  std::array<std::unique_ptr<T[]>, 40> m_segments;
  std::atomic<std::size_t> m_size = 0;
};

}  // namespace deckpipe
