// SPDX-License-Identifier: GPL-3.0-or-later
// How much was heard from each node of a bus: a frame is its who held the address when the frame came. Two
// nodes that had one address one after the other are two nodes.
#pragma once

#include <map>
#include <utility>

#include "protocol/address_book.h"

namespace deckpipe::ctl {

struct NodeCount {
  std::uint32_t frames = 0;
  std::uint32_t malformed = 0;
  Instant lastHeard = kNotYet;
};

class NodeCounts {
 public:
  // Each frame of the bus in order; `book` knows the frame already.
  void count(const Frame& frame, Instant time, const Classified& what, const AddressBook& book);
  // The count of the node with this NAME at this address; the null NAME stands for a node without one.
  NodeCount at(Address address, Name name) const;

 private:
  std::map<std::pair<std::uint8_t, std::uint64_t>, NodeCount> m_counts;
};

}  // namespace deckpipe::ctl
