// SPDX-License-Identifier: GPL-3.0-or-later
// The frames that a link wrote and has not heard back, oldest first. LinkDelivery puts one in per write and
// takes it out on its echo; those that stay never reached the bus. It knows no plugin and no time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "bus/frame.h"

namespace deckpipe {

class OwnFrames {
 public:
  // Above `limit` the oldest is given up: an adapter that never echoes must not grow us.
  explicit OwnFrames(std::size_t limit = 512) : m_limit(limit) {}

  void wrote(const Frame& frame) {
    if (m_waiting.size() == m_limit) m_waiting.pop_front();
    m_waiting.push_back({frame.id, frame.length, frame.data});
  }
  // False if no such frame is waiting. Of equal frames the oldest came back: first in, first out. A frame may
  // come back before an older one that differs, as controllers with several mailboxes send by priority.
  bool cameBack(const Frame& frame) {
    const Key key{frame.id, frame.length, frame.data};
    const auto found = std::find(m_waiting.begin(), m_waiting.end(), key);
    if (found == m_waiting.end()) return false;
    m_waiting.erase(found);
    return true;
  }
  std::size_t waiting() const { return m_waiting.size(); }
  void clear() { m_waiting.clear(); }

 private:
  struct Key {
    std::uint32_t id;
    std::uint8_t length;
    Payload data;
    friend bool operator==(const Key&, const Key&) = default;
  };
  std::size_t m_limit;
  std::deque<Key> m_waiting;
};

}  // namespace deckpipe
