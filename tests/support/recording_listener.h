// SPDX-License-Identifier: GPL-3.0-or-later
// A PortListener that writes down what it is told.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bus/port.h"

namespace deckpipe {

struct RecordingListener : PortListener {
  std::vector<Frame> frames;
  std::vector<std::size_t> batches;  // sizes
  std::vector<std::pair<NotKept, std::uint32_t>> notKept;
  std::vector<LinkState> states;
  std::vector<std::string> reasons;  // one for each state

  void framesReceived(std::span<const Frame> received) override {
    frames.insert(frames.end(), received.begin(), received.end());
    batches.push_back(received.size());
  }
  void framesNotKept(NotKept reason, std::uint32_t count) override { notKept.emplace_back(reason, count); }
  void linkChanged(LinkState state, const std::string& reason) override {
    states.push_back(state);
    reasons.push_back(reason);
  }

  LinkState state() const { return states.empty() ? LinkState::Closed : states.back(); }
  std::string reason() const { return reasons.empty() ? std::string() : reasons.back(); }
  void forget() { *this = {}; }
};

}  // namespace deckpipe
