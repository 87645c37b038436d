// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/claims.h"

#include <algorithm>

namespace deckpipe {
namespace {

bool isOpen(ClaimState state) { return state == ClaimState::Claiming || state == ClaimState::Contested; }

}  // namespace

Claims::Contest* Claims::contestAt(Address a) {
  for (Contest& contest : m_contests) {
    if (contest.since != kNotYet && contest.address == a) return &contest;
  }
  return nullptr;
}

void Claims::take(Address a, Name name, Instant time) {
  Node& node = m_nodes[a.value];
  if (!isOpen(node.claim)) ++m_open;
  node.name = name;
  node.claimedAt = time;
  node.claim = ClaimState::Claiming;
  if (Contest* contest = contestAt(a)) *contest = {};
}

Address Claims::claimed(Address source, Name name, Instant time) {
  if (source == kGlobalAddress || name.value == 0) return kNullAddress;
  if (source == kNullAddress) {
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
      Node& node = m_nodes[i];
      const Address a{static_cast<std::uint8_t>(i)};
      if (node.name != name || node.claim == ClaimState::CannotClaim) continue;
      if (isOpen(node.claim)) --m_open;
      if (Contest* contest = contestAt(a)) *contest = {};
      node.claim = ClaimState::CannotClaim;
      return a;
    }
    return kNullAddress;
  }
  Node& node = m_nodes[source.value];
  const bool held = node.claim != ClaimState::NoClaim && node.claim != ClaimState::CannotClaim;
  if (!held) {
    take(source, name, time);
    return source;
  }
  if (node.name == name) {  // an answer to a contest, or to a request
    if (Contest* contest = contestAt(source)) {
      *contest = {};
      ++node.claimsWon;
      node.claim = ClaimState::Claimed;
      --m_open;
    }
    return kNullAddress;
  }
  if (name.value < node.name.value) {
    ++node.claimsLost;
    take(source, name, time);
    return source;
  }
  Contest* contest = contestAt(source);
  if (contest == nullptr) {
    const auto free = std::ranges::find(m_contests, kNotYet, &Contest::since);
    if (free == m_contests.end()) return kNullAddress;
    contest = &*free;
  }
  *contest = {name, time, source};
  if (!isOpen(node.claim)) ++m_open;
  node.claim = ClaimState::Contested;
  return kNullAddress;
}

Instant Claims::nextDeadline() const {
  Instant next = kNever;
  if (m_open == 0) return next;
  for (const Node& node : m_nodes) {
    if (node.claim == ClaimState::Claiming) next = std::min(next, node.claimedAt + kClaimTime);
  }
  for (const Contest& contest : m_contests) {
    if (contest.since != kNotYet) next = std::min(next, contest.since + kClaimTime);
  }
  return next;
}

Address Claims::decide(Instant time) {
  if (m_open == 0) return kNullAddress;
  for (Node& node : m_nodes) {
    if (node.claim == ClaimState::Claiming && node.claimedAt + kClaimTime <= time) {
      node.claim = ClaimState::Claimed;
      --m_open;
    }
  }
  for (Contest& contest : m_contests) {
    if (contest.since == kNotYet || contest.since + kClaimTime > time) continue;
    // The holder did not answer: it is gone, and the address is the other's.
    const Contest decided = contest;
    contest = {};
    Node& node = m_nodes[decided.address.value];
    ++node.claimsLost;
    node.name = decided.name;
    node.claimedAt = decided.since;
    node.claim = ClaimState::Claimed;
    --m_open;
    return decided.address;
  }
  return kNullAddress;
}

}  // namespace deckpipe
