// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/role_walk.h"

#include <algorithm>

namespace deckpipe {

const AddressBook& RoleWalk::book(Channel channel) const {
  static const AddressBook kNothingKnown;
  const std::uint16_t place = m_places[channel.value];
  return place == 0 ? kNothingKnown : m_books[place - 1u];
}

void RoleWalk::sayDrive(Channel channel, Address address, bool isDrive, Instant time) {
  timeCame(time);
  const std::uint16_t place = m_places[channel.value];
  (place == 0 ? addBook(channel) : m_books[place - 1u]).sayDrive(address, isDrive);
}

void RoleWalk::linkIs(Channel channel, bool isUp, Instant time) {
  timeCame(time);
  if (m_isDown[channel.value] != isUp) return;
  m_isDown[channel.value] = !isUp;
  const std::uint16_t place = m_places[channel.value];
  if (place == 0) return;
  isUp ? m_books[place - 1u].linkCameBack() : m_books[place - 1u].linkWentDown();
}

AddressBook& RoleWalk::addBook(Channel channel) {
  AddressBook& book = m_books.emplace_back();
  m_places[channel.value] = static_cast<std::uint16_t>(m_books.size());
  return book;
}

bool RoleWalk::learn(AddressBook& book, const Frame& frame, Instant time, const Classified& what) {
  AddressBook::Lost lost;
  const bool hasChanged = book.observe(frame, time, what, lost);
  m_nextDecision = std::min(m_nextDecision, book.nextDecision());
  return hasChanged;
}

bool RoleWalk::decide(Instant time) {
  bool hasChanged = false;
  AddressBook::Lost lost;
  m_nextDecision = kNever;
  for (AddressBook& book : m_books) {
    hasChanged |= book.timeCame(time, lost);
    m_nextDecision = std::min(m_nextDecision, book.nextDecision());
  }
  return hasChanged;
}

}  // namespace deckpipe
