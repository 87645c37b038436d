// SPDX-License-Identifier: GPL-3.0-or-later
// A port without hardware, for testing whatever sits on one: it does what its script says, keeps what was
// written, and keeps the rules of bus/port.h. No Qt, no clock, no thread.
//
//   FakePort port;                 port.open(listener);        Up at once, unless told otherwise
//   service writes;                port.deliver();             echoes and what was heard reach the listener
//   port.holdBus();                                            nothing goes out: no acknowledge, bus-off
//   port.refuseWrites(WriteResult::Failed, 1);                 the next write fails
//
// deliver() stands for one turn of the event loop: as with the real thing, nothing comes from inside write().
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bus/port.h"

namespace deckpipe {

class FakePort : public Port {
 public:
  static constexpr int kAlways = std::numeric_limits<int>::max();

  // --- the script
  void setEchoing(bool echoing) { m_isEchoing = echoing; }
  // What open() ends in, at once: Up, or Closed with a reason, or Connecting until finishOpening().
  void setOpening(LinkState outcome, std::string reason = {}) { m_opening = {outcome, std::move(reason)}; }
  void finishOpening(LinkState outcome = LinkState::Up, const std::string& reason = {}) {
    tell(outcome, reason);
  }
  // The next `count` writes have that result and go nowhere.
  void refuseWrites(WriteResult result, int count = kAlways) { m_refusal = {result, count}; }
  void acceptWrites() { m_refusal.second = 0; }
  // So many frames may wait for the bus; one more is QueueFull. Of interest while the bus is held.
  void setQueue(std::size_t frames) { m_room = frames; }
  // What is written stays in the queue until releaseBus(), which lets `count` out.
  void holdBus() { m_isHeld = true; }
  void releaseBus(std::size_t count = std::numeric_limits<std::size_t>::max()) {
    m_isHeld = count != std::numeric_limits<std::size_t>::max();
    for (; count > 0 && !m_queue.empty(); --count) sendFirst();
  }
  // The next `count` frames that go out do not come back.
  void loseEchoes(int count) { m_echoesToLose = count; }
  // Where frames go when they are on the bus, e.g. to the other end's hear().
  void setWire(std::function<void(const Frame&)> wire) { m_wire = std::move(wire); }
  // Stamps of own frames from now on, ns.
  void setClock(std::int64_t stamp) { m_clock = stamp; }

  // --- what happens on the bus; reaches the listener with deliver()
  void hear(const Frame& frame) { m_events.push_back({frame, NotKept::Invalid, 0}); }
  void miss(NotKept reason, std::uint32_t count = 1) { m_events.push_back({{}, reason, count}); }
  // Reaches it at once. What waited in the queue never goes out.
  void lose(const std::string& reason) {
    m_queue.clear();
    tell(LinkState::Lost, reason);
  }
  void recover() { tell(LinkState::Up, {}); }
  void report(const std::string& reason) { tell(m_state, reason); }

  void deliver() {
    std::vector<Frame> frames;
    const auto hand = [&] {
      if (!frames.empty() && m_listener != nullptr) m_listener->framesReceived(frames);
      frames.clear();
    };
    for (const Event& event : std::exchange(m_events, {})) {
      if (event.missing == 0) {
        frames.push_back(event.frame);
        continue;
      }
      hand();
      if (m_listener != nullptr) m_listener->framesNotKept(event.reason, event.missing);
    }
    hand();
  }

  // --- what was seen
  const std::vector<Frame>& written() const { return m_written; }  // Accepted ones, in order
  std::size_t attempts() const { return m_attempts; }              // refused ones too
  std::size_t waiting() const { return m_queue.size(); }           // in the queue
  LinkState state() const { return m_state; }
  void forget() {
    m_written.clear();
    m_attempts = 0;
  }

  // --- Port
  void open(PortListener& listener) override {
    close();
    m_listener = &listener;
    tell(LinkState::Connecting, {});
    if (m_opening.first != LinkState::Connecting) tell(m_opening.first, m_opening.second);
  }
  void close() override {
    if (m_listener == nullptr) return;
    deliver();
    m_queue.clear();
    PortListener* listener = std::exchange(m_listener, nullptr);
    if (listener != nullptr && std::exchange(m_state, LinkState::Closed) != LinkState::Closed) {
      listener->linkChanged(LinkState::Closed, {});
    }
  }
  WriteResult write(const Frame& frame) override {
    ++m_attempts;
    if (m_state != LinkState::Up) return WriteResult::NotOpen;
    if (m_refusal.second > 0) {
      if (m_refusal.second != kAlways) --m_refusal.second;
      return m_refusal.first;
    }
    if (m_queue.size() >= m_room) return WriteResult::QueueFull;
    m_written.push_back(frame);
    m_queue.push_back(frame);
    if (!m_isEchoing) returnToListener(frame, Frame::kSent);
    if (!m_isHeld) sendFirst();
    return WriteResult::Accepted;
  }
  bool echoes() const override { return m_isEchoing; }

 private:
  struct Event {
    Frame frame;
    NotKept reason;
    std::uint32_t missing;  // 0: it is a frame
  };

  void sendFirst() {
    const Frame frame = m_queue.front();
    m_queue.pop_front();
    if (m_wire) m_wire(frame);
    if (!m_isEchoing) return;
    if (m_echoesToLose > 0) {
      --m_echoesToLose;
    } else {
      returnToListener(frame, Frame::kSent | Frame::kConfirmed);
    }
  }
  void returnToListener(Frame frame, int flags) {
    frame.flags = static_cast<std::uint8_t>(flags);
    frame.stamp = m_clock;
    hear(frame);
  }
  void tell(LinkState state, const std::string& reason) {
    deliver();
    m_state = state;
    if (m_listener != nullptr) m_listener->linkChanged(state, reason);
  }

  PortListener* m_listener = nullptr;
  LinkState m_state = LinkState::Closed;
  std::pair<LinkState, std::string> m_opening{LinkState::Up, {}};
  bool m_isEchoing = true;
  bool m_isHeld = false;
  int m_echoesToLose = 0;
  std::pair<WriteResult, int> m_refusal{WriteResult::Failed, 0};
  std::size_t m_room = std::numeric_limits<std::size_t>::max();
  std::int64_t m_clock = 0;
  std::function<void(const Frame&)> m_wire;
  std::deque<Frame> m_queue;
  std::deque<Event> m_events;
  std::vector<Frame> m_written;
  std::size_t m_attempts = 0;
};

}  // namespace deckpipe
