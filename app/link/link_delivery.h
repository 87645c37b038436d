// SPDX-License-Identifier: GPL-3.0-or-later
// The way of a link's frames to its listener. CanLink puts in what the adapter handed over and what was
// written, and hands it over once per turn of its event loop: many frames at a time, in order of arrival,
// each loss at its place.
//
// 1. Own frames reach the listener once: on their echo where the link echoes, else when they were written. A
//    plugin that is known not to echo and echoes all the same does not make them come twice.
// 2. The listener may write, close or open from inside any call. After end() it is not called again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "bus/own_frames.h"
#include "link/link_status.h"

class QCanBusFrame;

namespace deckpipe {

class LinkDelivery {
 public:
  // Counts into `status`.
  LinkDelivery(Channel channel, bool echoes, LinkStatus& status);

  void begin(PortListener& listener);
  // The listener that is not called any more; null if there was none.
  PortListener* end();
  bool hasListener() const { return m_listener != nullptr; }

  // A frame from the adapter.
  void take(const QCanBusFrame& frame);
  // A frame that the adapter accepted at `time`, ns since 1970.
  void wrote(const Frame& frame, std::int64_t time);
  // The kernel dropped so many frames.
  void dropped(std::uint32_t frames) { m_dropped += frames; }
  // Controller or driver lost so many frames.
  void overran(std::uint32_t frames) { m_overrun += frames; }
  // The device is gone: nothing more comes from it.
  void clear();

  bool isEmpty() const { return m_batch.empty() && m_missing.empty() && m_dropped == 0 && m_overrun == 0; }
  void handOver();
  void tell(LinkState state, const std::string& reason);

 private:
  Channel m_channel;
  bool m_echoes;
  LinkStatus& m_status;
  PortListener* m_listener = nullptr;
  int m_listeners = 0;  // counts begin() and end()
  OwnFrames m_strays;   // written; a plugin that is known not to echo may give them back all the same
  std::vector<Frame> m_batch;
  std::vector<std::pair<std::size_t, NotKept>> m_missing;  // place in m_batch
  std::uint32_t m_dropped = 0, m_overrun = 0;
};

}  // namespace deckpipe
