// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/source_status.h"

namespace deckpipe {
namespace {

SourceError errorOf(const LiveBus::Published& published) {
  const LinkStatus& link = published.link;
  if (published.storeFull) return StoreFull{};
  if (link.fault == LinkFault::None && link.reason.empty()) return {};
  return link.error();
}

// An interface that went down, or is another one since, holds no frame any more.
bool holdsNothing(LinkFault fault) {
  return fault == LinkFault::InterfaceDown || fault == LinkFault::Gone || fault == LinkFault::NoInterface;
}

}  // namespace

void takeLink(Snapshot& snapshot, const LiveBus::Published& published) {
  SourceStatus& source = snapshot.source;
  const auto& waiting = snapshot.leftWaiting;
  if (waiting && waiting->interfaceName == source.interfaceName && holdsNothing(published.link.fault))
    snapshot.leftWaiting.reset();
  source.error = errorOf(published);
  if (const auto& hardware = published.link.hardware) {
    source.isListenOnly = hardware->isListenOnly;
    source.controller = hardware->controller;
    if (hardware->bitRate != 0) source.bitRate = static_cast<int>(hardware->bitRate);
  }
  switch (published.link.state) {
    case LinkState::Up: source.progress = SourceStatus::Progress::Running; break;
    case LinkState::Connecting: source.progress = SourceStatus::Progress::Opening; break;
    case LinkState::Lost: source.progress = SourceStatus::Progress::Lost; break;
    case LinkState::Closed:
      if (published.link.fault != LinkFault::None) source.progress = SourceStatus::Progress::Failed;
      break;
  }
  if (published.storeFull) source.progress = SourceStatus::Progress::Failed;
}

void keepWaiting(Snapshot& snapshot, const ServiceStatus& services) {
  if (services.unconfirmed == 0 || snapshot.source.simulated) return;
  snapshot.leftWaiting = {.interfaceName = snapshot.source.interfaceName,
                          .frames = services.unconfirmed,
                          .commands = services.waitingCommands};
}

}  // namespace deckpipe
