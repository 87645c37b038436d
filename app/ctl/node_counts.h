// SPDX-License-Identifier: GPL-3.0-or-later
// How much was heard from each node of a bus: a frame is its who held the address when the frame came. Two
// nodes that had one address one after the other are two nodes.
#pragma once

#include <map>
#include <utility>

#include "bus/j1939.h"
#include "protocol/address_book.h"
#include "protocol/classify.h"

namespace deckpipe::ctl {

struct NodeCount {
  std::uint32_t frames = 0;
  std::uint32_t malformed = 0;
  Instant lastHeard = kNotYet;
};

class NodeCounts {
 public:
  // Each frame of the bus in order; `book` knows the frame already.
  void count(const Frame& frame, Instant time, const Classified& what, const AddressBook& book) {
    if (!frame.isExtended() || frame.isError()) return;
    const Address source = J1939Id::of(frame.identifier()).source;
    // A claim is its own NAME's, also where that does not get the address.
    const bool isClaim = what.message == MessageId::Name && what.isDecoded();
    const Name name = isClaim ? Name::of(frame) : book.lastHolder(source);
    NodeCount& count = m_counts[{source.value, name.value}];
    // The first NAME takes over the frames that came before any NAME was heard there, or was heard anew.
    if (name.value != 0) {
      if (const auto before = m_counts.extract({source.value, 0}); !before.empty()) {
        count.frames += before.mapped().frames;
        count.malformed += before.mapped().malformed;
      }
    }
    ++count.frames;
    count.lastHeard = time;
    if (what.malformed) ++count.malformed;
  }
  // The count of the node with this NAME at this address; the null NAME stands for a node without one.
  NodeCount at(Address address, Name name) const {
    const auto found = m_counts.find({address.value, name.value});
    return found != m_counts.end() ? found->second : NodeCount{};
  }

 private:
  std::map<std::pair<std::uint8_t, std::uint64_t>, NodeCount> m_counts;
};

}  // namespace deckpipe::ctl
