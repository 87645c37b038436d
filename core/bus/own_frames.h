// SPDX-License-Identifier: GPL-3.0-or-later
// The frames that were handed to an adapter and have not come back, oldest first. Whoever writes puts one in
// per write and takes it out on its echo; what stays has not been on the bus yet. Of equal frames the one
// that was handed over first came back first. It knows no plugin.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "base/time.h"
#include "bus/frame.h"

namespace deckpipe {

// Which frame it was, for whoever wrote it.
struct FrameTag {
  std::uint32_t owner = 0;
  std::uint64_t number = 0;  // 0: no frame
  friend bool operator==(const FrameTag&, const FrameTag&) = default;
};

class OwnFrames {
 public:
  struct Own {
    FrameTag tag;
    Instant when;  // handed over
  };

  // Above `limit` the oldest is given up: an adapter that never echoes must not grow us.
  explicit OwnFrames(std::size_t limit = 512) : m_limit(limit) {}

  // Returns the one that is given up for it.
  std::optional<Own> wrote(const Frame& frame, FrameTag tag = {}, Instant when = kNotYet) {
    std::optional<Own> givenUp;
    if (m_waiting.size() == m_limit) {
      givenUp = m_waiting.front().own;
      m_waiting.pop_front();
    }
    m_waiting.push_back({{frame.id, frame.length, frame.data}, {tag, when}});
    return givenUp;
  }
  // Nothing where no such frame is waiting. Not only the oldest is looked at: controllers with several
  // transmit mailboxes send by priority.
  std::optional<Own> take(const Frame& frame) {
    const auto found = std::ranges::find(m_waiting, Key{frame.id, frame.length, frame.data}, &Waiting::key);
    if (found == m_waiting.end()) return {};
    const Own own = found->own;
    m_waiting.erase(found);
    return own;
  }
  bool cameBack(const Frame& frame) { return take(frame).has_value(); }
  // All of them: no echo of theirs is to be expected any more.
  std::vector<Own> takeAll() {
    std::vector<Own> all;
    for (const Waiting& waiting : m_waiting) all.push_back(waiting.own);
    m_waiting.clear();
    return all;
  }

  std::size_t waiting() const { return m_waiting.size(); }
  // Of these handed over at this time or before.
  std::size_t waitingSince(Instant time) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(m_waiting, [time](const Waiting& w) { return w.own.when <= time; }));
  }
  void clear() { m_waiting.clear(); }

 private:
  struct Key {
    std::uint32_t id;
    std::uint8_t length;
    Payload data;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Waiting {
    Key key;
    Own own;
  };
  std::size_t m_limit;
  std::deque<Waiting> m_waiting;
};

}  // namespace deckpipe
