// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_counts.h"

#include "bus/j1939.h"

namespace deckpipe::ctl {

void NodeCounts::count(const Frame& frame, Instant time, const Classified& what, const AddressBook& book) {
  if (!frame.isExtended() || frame.isError()) return;
  const Address source = J1939Id::of(frame.identifier()).source;
  // A claim is its own NAME's, also where that does not get the address.
  const bool isClaim = what.message == MessageId::Name && what.isDecoded();
  const Name name = isClaim ? Name::of(frame) : book.lastHolder(source);
  NodeCount& count = m_counts[{source.value, name.value}];
  // The first NAME takes over the frames that came before any NAME was heard there.
  if (name.value != 0 && count.frames == 0) {
    if (const auto before = m_counts.extract({source.value, 0}); !before.empty()) count = before.mapped();
  }
  ++count.frames;
  count.lastHeard = time;
  if (what.malformed) ++count.malformed;
}

NodeCount NodeCounts::at(Address address, Name name) const {
  const auto found = m_counts.find({address.value, name.value});
  return found != m_counts.end() ? found->second : NodeCount{};
}

}  // namespace deckpipe::ctl
