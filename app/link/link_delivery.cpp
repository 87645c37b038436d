// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/link_delivery.h"

#include "link/link_device.h"

namespace deckpipe {
namespace {

constexpr std::size_t kStrayEchoes = 64;

}  // namespace

LinkDelivery::LinkDelivery(Channel channel, bool echoes, LinkStatus& status)
    : m_channel(channel), m_echoes(echoes), m_status(status), m_strays(kStrayEchoes) {}

void LinkDelivery::begin(PortListener& listener) {
  clear();
  ++m_listeners;
  m_listener = &listener;
}

PortListener* LinkDelivery::end() {
  clear();
  ++m_listeners;
  return std::exchange(m_listener, nullptr);
}

void LinkDelivery::clear() {
  m_strays.clear();
  m_batch.clear();
  m_missing.clear();
  m_dropped = m_overrun = 0;
}

void LinkDelivery::take(const QCanBusFrame& frame) {
  auto converted = fromCanBusFrame(frame, m_channel);
  if (!converted) {
    m_missing.emplace_back(m_batch.size(), converted.error());
    return;
  }
  Frame& out = converted.value();
  if (frame.hasLocalEcho()) {
    if (!m_echoes && m_strays.cameBack(out)) return;  // delivered when it was written
    if (m_echoes) {
      out.flags = Frame::kSent | Frame::kConfirmed;
      ++m_status.confirmed;
    }
  }
  if ((out.flags & Frame::kSent) == 0) ++m_status.received;
  m_batch.push_back(out);
}

void LinkDelivery::wrote(const Frame& frame, std::int64_t time) {
  ++m_status.written;
  if (m_echoes) return;
  m_strays.wrote(frame);
  Frame own = frame;
  own.channel = m_channel.value;
  own.flags = Frame::kSent;
  own.stamp = time;
  m_batch.push_back(own);
}

void LinkDelivery::handOver() {
  auto batch = std::exchange(m_batch, {});
  const auto missing = std::exchange(m_missing, {});
  const std::uint32_t dropped = std::exchange(m_dropped, 0), overrun = std::exchange(m_overrun, 0);
  m_status.notKept += missing.size() + dropped + overrun;
  const int listeners = m_listeners;
  const auto isHeard = [&] { return m_listener != nullptr && m_listeners == listeners; };
  std::size_t from = 0;
  const auto hand = [&](std::size_t to) {
    if (isHeard() && to > from) {
      m_listener->framesReceived(std::span<const Frame>(batch).subspan(from, to - from));
    }
    from = to;
  };
  for (const auto& [place, reason] : missing) {
    hand(place);
    if (isHeard()) m_listener->framesNotKept(reason, 1);
  }
  hand(batch.size());
  if (isHeard() && dropped > 0) m_listener->framesNotKept(NotKept::Overflow, dropped);
  if (isHeard() && overrun > 0) m_listener->framesNotKept(NotKept::Overrun, overrun);
  if (m_batch.empty()) {
    batch.clear();
    m_batch = std::move(batch);  // its memory serves again
  }
}

void LinkDelivery::tell(LinkState state, const std::string& reason) {
  if (m_listener != nullptr) m_listener->linkChanged(state, reason);
}

}  // namespace deckpipe
