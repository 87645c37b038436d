// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/live_bus.h"

#include <QTimer>
#include <ctime>

namespace deckpipe {
namespace {

constexpr std::chrono::milliseconds kTick{33};

}  // namespace

Instant bootTime() {
  timespec now{};
  ::clock_gettime(CLOCK_BOOTTIME, &now);
  return Instant{std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec};
}

LiveBus::LiveBus(std::shared_ptr<LogDocument> document, LinkSettings settings)
    : m_document(std::move(document)), m_settings(std::move(settings)), m_times(m_document->frames) {
  m_published.state = std::make_shared<const State>();
}

LiveBus::~LiveBus() { stop(); }

LiveBus::Published LiveBus::latest() const {
  const std::lock_guard lock(m_lock);
  return m_published;
}

void LiveBus::start() {
  m_tick = new QTimer(this);
  m_tick->setTimerType(Qt::PreciseTimer);
  connect(m_tick, &QTimer::timeout, this, &LiveBus::publish);
  m_tick->start(kTick);
  m_link = std::make_unique<CanLink>(m_settings);
  m_link->open(*this);
}

void LiveBus::stop() {
  if (m_link == nullptr) return;
  m_tick->stop();
  m_link->close();
  publish();
  m_link.reset();
}

void LiveBus::framesReceived(std::span<const Frame> frames) {
  if (!m_document->frames.append(frames, bootTime())) m_storeFull = true;
  const std::uint64_t count = m_document->frames.count();
  for (std::uint64_t i = m_state.cursor().frames; i < count; ++i) {
    m_state.apply(m_document->frames[i], m_times.at(i));
  }
}

void LiveBus::framesNotKept(NotKept reason, std::uint32_t count) {
  m_notKept += count;
  switch (reason) {
    case NotKept::Overflow: note(NoteKind::Dropped, count, {}); break;
    case NotKept::FlexibleDataRate:
      for (std::uint32_t i = 0; i < count; ++i) {
        m_document->unkept.add(m_document->frames.count(), Unkept::CanFd);
      }
      break;
    case NotKept::Invalid: break;
  }
}

void LiveBus::linkChanged(LinkState state, const std::string& reason) {
  const bool wasUp = m_linkState == LinkState::Up;
  m_linkState = state;
  if (state == LinkState::Up && !wasUp) note(NoteKind::LinkUp, 0, {});
  if (state != LinkState::Up && wasUp) note(NoteKind::LinkDown, 0, reason);
  publish();
}

void LiveBus::note(NoteKind kind, std::uint64_t number, const std::string& text) {
  const Note note{.frame = m_document->frames.count(),
                  // Behind every cursor that was published: a note at a cursor's own time has happened there.
                  .time = std::max(m_state.cursor().time, bootTime() - FrameStore::kLiveDrift) + 1ns,
                  .kind = kind,
                  .channel = m_settings.channel,
                  .number = number,
                  .text = text};
  m_document->notes.append(note);
  m_state.apply(note);
}

void LiveBus::publish() {
  m_state.timeCame(bootTime() - FrameStore::kLiveDrift);
  auto state = std::make_shared<const State>(m_state);
  const std::lock_guard lock(m_lock);
  m_published.state = std::move(state);
  if (m_link != nullptr) m_published.link = m_link->status();
  m_published.notKept = m_notKept;
  m_published.storeFull = m_storeFull;
}

}  // namespace deckpipe
