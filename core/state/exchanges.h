// SPDX-License-Identifier: GPL-3.0-or-later
// The exchanges of a log: what Akron devices and whoever asks them sent one another. Polls, answers, commands,
// acknowledgements and the data pipe, each with the device it belongs to. Found by a worker while the log is read or
// grows, and read by views on any thread: the terminal's transcript and the history of answers are made of it, live and
// of a file alike.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "base/ids.h"
#include "log/frame_store.h"
#include "log/stable_list.h"
#include "state/role_index.h"

namespace deckpipe {

struct Exchange {
  std::uint64_t frame = 0;
  Instant time;
  MessageId message = MessageId::Count;
  bool isFromDevice = false;
  DeviceKey device;
};

class Exchanges {
 public:
  // A person reads no longer list: later ones are not listed.
  static constexpr std::size_t kMax = 2'000'000;
  using List = StableList<Exchange>;

  Exchanges(const FrameStore& frames, const RoleIndex& roles);

  // Looks at up to so many further frames; not beyond what the index of roles has built. One thread at a time. False
  // where there is none.
  bool build(std::uint64_t atMost);
  // Notes came at places that were looked at already: everything is found anew. On the thread of build().
  void restart();

  // Readers, on any thread. Never null; it grows, and another one means that everything was found anew.
  std::shared_ptr<const List> list() const;

 private:
  void look(const Frame& frame, std::uint64_t index, Instant time);

  const FrameStore& m_frames;
  const RoleIndex& m_roles;
  RoleIndex::Stand m_stand;
  std::uint64_t m_looked = 0;
  mutable std::mutex m_lock;
  std::shared_ptr<List> m_list = std::make_shared<List>();
};

}  // namespace deckpipe
