// SPDX-License-Identifier: GPL-3.0-or-later
// What was said between Akron devices and whoever asks them: polls, answers, commands, acknowledgements and
// the data pipe, each with the device it belongs to. One look through the frames, a bounded piece at a time,
// continued as the log grows. The terminal's transcript and the history of answers are read from it, live and
// of a log alike.
#pragma once

#include <cstdint>
#include <vector>

#include "base/device_key.h"
#include "state/log_view.h"

namespace deckpipe {

struct Utterance {
  std::uint64_t frame = 0;
  Instant time;
  MessageId message = MessageId::Count;
  bool isFromDevice = false;
  DeviceKey device;
};

class Conversations {
 public:
  // More than a person reads; looking stops, and isFull() says so.
  static constexpr std::size_t kMost = 2'000'000;

  // Looks at up to so many further frames before `until`; not beyond what the log's index of roles has built.
  // False where frames remain to be looked at.
  bool take(const LogDocument& log, std::uint64_t until, std::uint64_t atMost);

  const std::vector<Utterance>& list() const { return m_list; }
  bool isFull() const { return m_list.size() >= kMost; }

 private:
  void look(const LogDocument& log, const Frame& frame, std::uint64_t index, Instant time);

  std::vector<Utterance> m_list;
  RoleIndex::Stand m_roles;
  std::uint64_t m_looked = 0;
};

}  // namespace deckpipe
