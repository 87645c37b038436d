// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/state_walker.h"

#include <utility>

namespace deckpipe {

StateWalker::StateWalker(std::shared_ptr<LogDocument> document)
    : m_document(std::move(document)),
      m_here(std::make_shared<const State>()),
      m_worker([this](const Intent& intent, const Worker::Turn& turn) { fulfil(intent, turn); }, m_here) {}

void StateWalker::request(Cursor cursor) {
  if (std::exchange(m_intent.cursor, cursor) != cursor) m_worker.request(m_intent);
}

void StateWalker::notesCame() {
  m_document->roles.invalidateAfter(0);
  ++m_intent.generation;
  m_worker.request(m_intent);
}

void StateWalker::index(Cursor end) {
  m_intent.end = end;
  m_worker.request(m_intent);
}

void StateWalker::fulfil(const Intent& intent, const Worker::Turn& turn) {
  if (std::exchange(m_generation, intent.generation) != intent.generation) {
    m_isAnew = true;
    m_document->keyframes.invalidateAfter(0);
    m_document->events.restart();
    m_document->exchanges.restart();
  }
  if (m_isAnew || m_here->cursor() != intent.cursor) {
    auto state = walk(intent, turn);
    if (state == nullptr) return;
    m_here = std::move(state);
    m_isAnew = false;
    turn.handOver(m_here);
  }
  while (!turn.isGivenUp() && indexMore(intent.end)) {
  }
}

bool StateWalker::indexMore(Cursor end) {
  const bool hasRoles = m_document->roles.build(Keyframes::kEvery);
  // The walk for events makes keyframes too. What lies behind the end that it knows has none yet.
  const bool hasEvents = m_document->events.build(end);
  const bool hasExchanges = m_document->exchanges.build(Keyframes::kEvery);
  return hasRoles || hasEvents || hasExchanges || m_document->keyframes.build();
}

std::shared_ptr<const State> StateWalker::walk(const Intent& intent, const Worker::Turn& turn) {
  const Cursor cursor = intent.cursor;
  // Far from every keyframe the way leads over new ones, so that it can be left at each.
  while ((m_document->keyframes.count() + 1) * Keyframes::kEvery <= cursor.frames) {
    if (!indexMore(intent.end)) break;
    if (turn.isGivenUp()) return nullptr;
  }
  const Cursor from = m_here->cursor();
  const bool ahead = !m_isAnew && from.frames <= cursor.frames && from.time <= cursor.time;
  if (!ahead || cursor.frames - from.frames > Keyframes::kEvery) {
    return std::make_shared<const State>(m_document->keyframes.at(cursor));
  }
  auto state = std::make_shared<State>(*m_here);
  advance(*state, m_document->frames, m_document->notes, cursor);
  return state;
}

}  // namespace deckpipe
