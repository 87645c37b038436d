// SPDX-License-Identifier: GPL-3.0-or-later
// Address claims of one channel as a listener sees them: who holds an address, contests won and lost.
// Source: SAE J1939-81; CAN Messaging manual, Appendix A.
#pragma once

#include <array>

#include "state/node.h"

namespace deckpipe {

class Claims {
 public:
  const Node& operator[](Address a) const { return m_nodes[a.value]; }

  void heard(Address source, Instant time) {
    Node& node = m_nodes[source.value];
    node.rate.count(time, node.lastHeard);
    node.lastHeard = time;
    ++node.frames;
    node.wasLeft = false;
  }
  // Whoever was here announced itself elsewhere.
  void left(Address a) { m_nodes[a.value].wasLeft = true; }
  void countMalformed(Address source) {
    std::uint16_t& count = m_nodes[source.value].malformed;
    if (count < std::numeric_limits<std::uint16_t>::max()) ++count;
  }

  // A NAME of length 8. From the null address it says 'cannot claim'. Claims from the global address and with
  // NAME 0 mean nothing. Returns the address whose holder changed or left; the null address where none did. A
  // NAME that held several leaves one a call: from the null address call again until it returns that.
  Address claimed(Address source, Name name, Instant time);

  // The next time a claim or a contest is decided; kNever where none is open.
  Instant nextDeadline() const;
  // Decides what is due at `time`. Returns an address whose holder changed, the null address where none did;
  // call again until it returns that.
  Address decide(Instant time);

  friend bool operator==(const Claims&, const Claims&) = default;

 private:
  struct Contest {  // a claim by a NAME that would lose, to which the holder has not answered yet
    Name name;
    Instant since = kNotYet;
    Address address;
    friend bool operator==(const Contest&, const Contest&) = default;
  };
  Contest* contestAt(Address a);
  void take(Address a, Name name, Instant time);

  std::array<Node, 256> m_nodes{};
  std::array<Contest, 8> m_contests{};  // more at once than this are not followed
  std::uint16_t m_open = 0;             // addresses that are Claiming or Contested
};

}  // namespace deckpipe
