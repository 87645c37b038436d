// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/state.h"

#include <algorithm>

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "bus/load.h"
#include "protocol/catalogue.h"

namespace deckpipe {
namespace {

// The shortest time-out there is: a frame can cause no deadline sooner than this.
constexpr Duration kShortestTimeout =
    std::min({Duration(kInputTimeout), kClaimTime, staleAfter(Periodic::Position)});

bool isNode(Address a) { return a != kNullAddress && a != kGlobalAddress; }

}  // namespace

void State::apply(const Frame& frame, Instant time) {
  timeCame(time);
  ++m_cursor.frames;
  if (frame.channel >= kMaxChannels) {
    ++m_untrackedFrames;
    return;
  }
  m_nextCheck = std::min(m_nextCheck, time + kShortestTimeout);
  ChannelState& channel = m_channels[frame.channel];
  ++channel.frames;
  channel.lastFrame = time;
  if (frame.isError()) {
    ++channel.errorFrames;
    channel.controller = controllerStateOf(frame).value_or(channel.controller);
    return;
  }
  channel.bits += estimatedBits(frame);
  if (frame.isRemote()) ++channel.remoteFrames;
  const Classified what = classify(frame, time, channel.roles);
  count(what, time);
  channel.roles.observe(frame, time, what);
  if (frame.isExtended()) {
    applyExtended(frame, time, what);
  } else {
    applyStandard(frame, time, what);
  }
}

void State::count(const Classified& what, Instant time) {
  std::size_t i = kMessageCount;
  if (what.malformed) {
    i = kMessageCount + 1;
  } else if (what.isDecoded()) {
    i = static_cast<std::size_t>(what.message);
  }
  ++m_counters[i].count;
  m_counters[i].last = time;
}

void State::applyExtended(const Frame& frame, Instant time, const Classified& what) {
  const Channel channelId{frame.channel};
  ChannelState& channel = m_channels[frame.channel];
  const J1939Id id = J1939Id::of(frame.identifier());
  if (isNode(id.source)) channel.claims.heard(id.source, time);
  Device* sender = isNode(id.source) ? m_devices.findAddress(channelId, id.source) : nullptr;
  if (what.malformed) channel.claims.countMalformed(id.source);

  if (what.isDecoded()) {
    const Message& message = messageOf(what.message);
    switch (what.message) {
      case MessageId::Name: {
        const Name name = Name::of(frame);
        const bool isFirst = channel.claims[id.source].name.value == 0;
        // From the null address one frame may give up several; elsewhere it changes one address at most.
        for (Address changed = channel.claims.claimed(id.source, name, time); isNode(changed);
             changed = id.source == kNullAddress ? channel.claims.claimed(id.source, name, time)
                                                 : kNullAddress) {
          if (id.source == kNullAddress) {
            m_devices.addressLeft(channelId, changed, time);
          } else {
            m_devices.addressTaken(channelId, changed, name, isFirst, time);
          }
        }
        sender = isNode(id.source) ? m_devices.findAddress(channelId, id.source) : nullptr;
        break;
      }
      case MessageId::BasicJoystick: channel.joysticks.heardBasic(id.source, frame, time); break;
      case MessageId::ExtendedJoystick: channel.joysticks.heardExtended(id.source, frame, time); break;
      case MessageId::AddressAnnouncement:
        if (const auto pin = announcedPin(frame); pin && isNode(id.source)) {
          const Device* device = m_devices.byPin(channelId, *pin);
          const Address before = device == nullptr ? kNullAddress : device->address;
          m_devices.announced(channelId, id.source, *pin, time);
          if (before != id.source && before != kNullAddress) channel.claims.left(before);
        }
        sender = m_devices.findAddress(channelId, id.source);
        break;
      case MessageId::SoePermissive:
        if (Device* device = m_devices.findAddress(channelId, id.destination))
          device->take(frame, what.message, time);
        break;
      default:
        if (message.family == Family::Akron && message.device == DeviceEnd::Sender && isNode(id.source)) {
          if (sender == nullptr) sender = m_devices.atAddress(channelId, id.source);
          if (sender != nullptr) sender->take(frame, what.message, time);
        }
        break;
    }
  }
  if (sender != nullptr) {
    sender->heard(time);
    if (what.malformed) ++sender->malformed;
  }
}

void State::applyStandard(const Frame& frame, Instant time, const Classified& what) {
  const CobId cob = CobId::of(frame.identifier());
  if (!cob.hasNode() || (!what.isDecoded() && !what.malformed)) return;
  // A request is to the node, not from it: it makes no device.
  const bool fromNode = cob.function != static_cast<std::uint16_t>(CobFunction::SdoRequest) &&
                        cob.function != static_cast<std::uint16_t>(CobFunction::Rpdo1);
  const Channel channel{frame.channel};
  // Nor does what only looks like CANopen: other buses use these identifiers too.
  const bool makesDevice = fromNode && what.isDecoded() && what.message != MessageId::SdoOther;
  Device* device = makesDevice ? m_devices.atNode(channel, cob.node)
                               : const_cast<Device*>(m_devices.byNode(channel, cob.node));
  if (device == nullptr) return;
  if (what.malformed) {
    ++device->malformed;
  } else {
    device->take(frame, what.message, time);
  }
  if (!fromNode) return;
  device->heard(time);
}

void State::apply(const Note& note) {
  timeCame(std::max(note.time, m_cursor.time));
  if (note.kind == NoteKind::Locked) m_locked = true;
  if (note.kind == NoteKind::Unlocked) m_locked = false;
  if (note.channel.value >= kMaxChannels) return;
  ChannelState& channel = m_channels[note.channel.value];
  switch (note.kind) {
    case NoteKind::LinkUp:
      channel.link = ChannelLink::Up;
      channel.controller = ControllerState::Unknown;
      break;
    case NoteKind::LinkDown: channel.link = ChannelLink::Down; break;
    case NoteKind::Dropped: channel.dropped += note.number; break;
    case NoteKind::DriveSaid: channel.roles.sayDrive(note.address, true); break;
    case NoteKind::DriveUnsaid: channel.roles.sayDrive(note.address, false); break;
    case NoteKind::OwnAddress: channel.ownAddress = note.address; break;
    case NoteKind::Locked:
    case NoteKind::Unlocked:
    case NoteKind::Mark:
    case NoteKind::Asked:
    case NoteKind::AskEnded:
    case NoteKind::AskWaits:
    case NoteKind::StillWaits:
    case NoteKind::Pipe: break;
  }
}

void State::timeCame(Instant time) {
  while (m_nextCheck <= time && m_nextCheck != kNever) {
    m_nextCheck = nextDeadline();
    if (m_nextCheck <= time && m_nextCheck != kNever) fire(m_nextCheck);
  }
  m_cursor.time = std::max(m_cursor.time, time);
}

Instant State::nextDeadline() const {
  Instant next = m_devices.nextDeadline();
  for (const ChannelState& channel : m_channels) {
    next = std::min({next, channel.claims.nextDeadline(), channel.joysticks.nextDeadline()});
  }
  return next;
}

void State::fire(Instant due) {
  m_devices.timeCame(due);
  for (std::size_t i = 0; i < m_channels.size(); ++i) {
    m_channels[i].joysticks.timeCame(due);
    const Channel channel{static_cast<std::uint8_t>(i)};
    for (Address changed = m_channels[i].claims.decide(due); isNode(changed);
         changed = m_channels[i].claims.decide(due)) {
      m_devices.addressTaken(channel, changed, m_channels[i].claims[changed].name, false, due);
    }
  }
}

}  // namespace deckpipe
