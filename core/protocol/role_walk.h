// SPDX-License-Identifier: GPL-3.0-or-later
// Classifies the frames of a log one after another, keeping the address book of every channel it has. For
// whoever walks a log without a State: the headless decode, and the index that lets the trace start anywhere.
#pragma once

#include <array>
#include <bitset>
#include <vector>

#include "protocol/address_book.h"

namespace deckpipe {

class RoleWalk {
 public:
  // The next frame of the log, at its log time. What it teaches holds from the one after it.
  Classified next(const Frame& frame, Instant time) {
    timeCame(time);
    const std::uint16_t place = m_places[frame.channel];
    AddressBook& book = place == 0 ? addBook({frame.channel}) : m_books[place - 1u];
    const Classified what = classify(frame, time, book);
    m_learned = book.mayTeach(frame, what) && learn(book, frame, time, what);
    return what;
  }
  // Whether the last frame changed any book.
  bool learned() const { return m_learned; }
  // Decides contests that are due before a frame or a note at `time`; says whether there was any. Both do so
  // by themselves.
  bool timeCame(Instant time) { return time >= m_nextDecision && decide(time); }
  // What next() would say of a frame once its time has come, without going on.
  Classified peek(const Frame& frame, Instant time) const {
    return classify(frame, time, book({frame.channel}));
  }
  // What is known of a channel.
  const AddressBook& book(Channel channel) const;
  // The person said at `time` that a Copley drive is at this address, or took it back.
  void sayDrive(Channel channel, Address address, bool isDrive, Instant time);
  // The link of this channel went up or down at `time`.
  void linkIs(Channel channel, bool isUp, Instant time);

 private:
  AddressBook& addBook(Channel channel);
  bool learn(AddressBook& book, const Frame& frame, Instant time, const Classified& what);
  bool decide(Instant time);

  std::vector<AddressBook> m_books;           // of the channels that had a frame
  std::array<std::uint16_t, 256> m_places{};  // by channel: 1 + the index of its book; 0 = none
  std::bitset<256> m_isDown;                  // by channel: its link
  Instant m_nextDecision = kNever;            // no book's is earlier
  bool m_learned = false;
};

}  // namespace deckpipe
