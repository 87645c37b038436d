// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/state_walker.h"

#include <utility>

namespace deckpipe {

StateWalker::StateWalker(std::shared_ptr<LogDocument> document)
    : m_document(std::move(document)),
      m_latest(std::make_shared<const State>()),
      m_thread([this](std::stop_token stop) { run(std::move(stop)); }) {}

StateWalker::~StateWalker() = default;

void StateWalker::request(Cursor cursor) {
  {
    const std::lock_guard lock(m_lock);
    if (m_latest->cursor() == cursor && !m_notesCame) return;
    m_request = cursor;
  }
  m_wake.notify_one();
}

void StateWalker::notesCame() {
  m_document->roles.invalidateAfter(0);
  {
    const std::lock_guard lock(m_lock);
    m_notesCame = true;
    m_indexRequested = true;
    if (!m_request) m_request = m_latest->cursor();
  }
  m_wake.notify_one();
}

void StateWalker::index(Cursor end) {
  {
    const std::lock_guard lock(m_lock);
    m_end = end;
    m_indexRequested = true;
  }
  m_wake.notify_one();
}

std::shared_ptr<const State> StateWalker::latest() const {
  const std::lock_guard lock(m_lock);
  return m_latest;
}

bool StateWalker::isSuperseded() const {
  const std::lock_guard lock(m_lock);
  return m_request.has_value();
}

void StateWalker::run(std::stop_token stop) {
  bool isAnew = false;  // no state was found since notes came
  while (!stop.stop_requested()) {
    std::optional<Cursor> cursor;
    {
      std::unique_lock lock(m_lock);
      if (!m_wake.wait(lock, stop, [this] { return m_request.has_value() || m_indexRequested; })) return;
      cursor = std::exchange(m_request, std::nullopt);
      m_indexRequested = false;
      if (std::exchange(m_notesCame, false)) {
        isAnew = true;
        m_document->keyframes.invalidateAfter(0);
        m_document->events.restart();
      }
    }
    if (auto state = cursor ? walkTo(*cursor, isAnew, stop) : nullptr) {
      const std::lock_guard lock(m_lock);
      m_latest = std::move(state);
      isAnew = false;
    }
    while (!stop.stop_requested() && !isSuperseded() && indexMore()) {
    }
  }
}

bool StateWalker::indexMore() {
  Cursor end;
  {
    const std::lock_guard lock(m_lock);
    end = m_end;
  }
  const bool hasRoles = m_document->roles.build(Keyframes::kEvery);
  // The walk for events makes keyframes too. What lies behind the end that it knows has none yet.
  const bool hasEvents = m_document->events.build(end);
  return hasRoles || hasEvents || m_document->keyframes.build();
}

// Null where a newer request or the end came between.
std::shared_ptr<const State> StateWalker::walkTo(Cursor cursor, bool isAnew, const std::stop_token& stop) {
  // Far from every keyframe the way leads over new ones, so that it can be left at each.
  while ((m_document->keyframes.count() + 1) * Keyframes::kEvery <= cursor.frames) {
    if (stop.stop_requested() || !indexMore()) break;
    if (isSuperseded()) return nullptr;
  }
  const std::shared_ptr<const State> here = latest();
  const Cursor from = here->cursor();
  const bool ahead = !isAnew && from.frames <= cursor.frames && from.time <= cursor.time;
  if (!ahead || cursor.frames - from.frames > Keyframes::kEvery) {
    return std::make_shared<const State>(m_document->keyframes.at(cursor));
  }
  auto state = std::make_shared<State>(*here);
  advance(*state, m_document->frames, m_document->notes, cursor);
  return state;
}

}  // namespace deckpipe
