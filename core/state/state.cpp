// SPDX-License-Identifier: GPL-3.0-or-later
#include "state/state.h"

#include <algorithm>

#include "base/overload.h"
#include "bus/canopen.h"
#include "bus/j1939.h"
#include "bus/load.h"
#include "protocol/address_book.h"
#include "protocol/lists.h"

namespace deckpipe {
namespace {

// The shortest time-out there is: a frame can cause no deadline sooner than this.
constexpr Duration kShortestTimeout = [] {
  Duration shortest = std::min<Duration>(kInputTimeout, kClaimTime);
  for (const MessageId id : kPeriodicReports) shortest = std::min(shortest, staleAfter(id));
  return shortest;
}();

constexpr BitRange kRequested = fieldOf(j1939::kRequestFields, "pgn").bits;

// A NAME or an announcement this long after a cause to say it is none of its own accord.
constexpr Duration kAskedWithin = 1s;
constexpr bool isRecent(Instant cause, Instant time) {
  return cause != kNotYet && time - cause <= kAskedWithin;
}

// A device without a status for so long does not run, or says nothing to anybody.
constexpr Duration kMuteAfter = staleAfter(MessageId::PositionLimitStatus);

// Transport announces the message that commands an address. Who is meant stands in the frames that follow.
bool commandsAddress(const Frame& frame, const J1939Id& id) {
  return id.pgn == pgn::kTransport && frame.length == 8 &&
         (frame.data[5] | frame.data[6] << 8 | frame.data[7] << 16) ==
             static_cast<int>(pgn::kCommandedAddress);
}

bool isNamed(const Device& device, Name name, const AddressBook& book) {
  if (device.kind == Device::Kind::Pin) return isNameOf(name, device.pin);
  return book.holder(device.address) == name;
}

// Another NAME claims the address of this device, which has to answer or to look for another one.
bool isPushed(const Device& device, Address source, Instant time) {
  const FormerAddress& lost = device.formerAddresses.front();
  return device.address == source || (lost.address == source && lost.until == time);
}

// Whether its periodic messages were missing, up to now or to the loss of its address, although they could have been
// heard.
bool isMute(const Device& device, Instant lastBeat, Instant time) {
  const Instant until = device.address == kNullAddress ? device.formerAddresses.front().until : time;
  return lastBeat != kNotYet &&
         until - std::max(lastBeat, device.listenedSince) >= kMuteAfter + device.slack();
}

// Whether a device that says its NAME or PIN has just started: it had no cause to say it, or it is the first thing
// that it says after its periodic messages were missing. One that runs without them is asked more than once.
// What it was asked while its link was down nobody heard, and what it sent before that tells nothing.
bool isStart(const ChannelState& channel, const Device& device, Instant time) {
  if (channel.isBeforeGap(device.lastHeard)) return false;
  Instant lastBeat = device.lastStatus;
  if (const Joystick* stick = channel.joysticks.find(device.address))
    lastBeat = std::max({lastBeat, stick->basic.at, stick->extended.at});
  if (channel.isBeforeGap(lastBeat)) lastBeat = kNotYet;
  const bool isListening = channel.linkDown == kNotYet || !isRecent(channel.linkUp, time);
  const bool isUnasked =
      isListening && !isRecent(channel.namesAsked, time) && !isRecent(device.provoked, time);
  if (isMute(device, lastBeat, time)) return isUnasked || device.restarted <= lastBeat;
  return isUnasked && device.address != kNullAddress;
}

// Sent to all, and neither a request nor what one may cause.
bool isOfItsOwnAccord(const J1939Id& id) {
  return id.destination == kGlobalAddress && id.pgn != pgn::kRequest && id.pgn != pgn::kAddressClaimed &&
         id.pgn != pgn::kAcknowledgement;
}

bool isNode(Address a) { return a != kNullAddress && a != kGlobalAddress; }

}  // namespace

const ChannelState& State::channel(Channel c) const {
  static const ChannelState kNothingHeard;
  return c.value < m_channels.size() ? m_channels[c.value] : kNothingHeard;
}

void State::timesAre(TimeGrain grain) {
  m_isCoarse = grain == TimeGrain::Seconds;
  m_devices.setCoarse(m_isCoarse);
}

ChannelState& State::use(Channel c) {
  while (c.value >= m_channels.size()) m_channels.emplace_back().joysticks.setCoarse(m_isCoarse);
  return m_channels[c.value];
}

void State::apply(const Frame& frame, Instant time) {
  timeCame(time);
  ++m_cursor.frames;
  if (frame.channel >= kMaxChannels) {
    ++m_untrackedFrames;
    return;
  }
  m_nextCheck = std::min(m_nextCheck, time + kShortestTimeout);
  ChannelState& channel = use({frame.channel});
  ++channel.frames;
  channel.lastFrame = time;
  if (frame.isError()) {
    ++channel.errorFrames;
    channel.controller = controllerStateOf(frame).value_or(channel.controller);
    return;
  }
  channel.bits += estimatedBits(frame);
  if (frame.isRemote()) ++channel.remoteFrames;
  const Classified what = classify(frame, time, channel.book);
  count(what, time);
  if (channel.book.mayTeach(frame, what)) {
    AddressBook::Lost lost;
    channel.book.observe(frame, time, what, lost);
    lose({frame.channel}, lost, time);
  }
  if (frame.isExtended()) {
    applyExtended(frame, time, what);
  } else {
    applyStandard(frame, time, what);
  }
}

void State::count(const Classified& what, Instant time) {
  MessageCounter& counter = what.malformed     ? m_malformed
                            : what.isDecoded() ? m_counters[what.message]
                                               : m_others;
  ++counter.count;
  counter.last = time;
}

void State::applyExtended(const Frame& frame, Instant time, const Classified& what) {
  const Channel channelId{frame.channel};
  ChannelState& channel = m_channels[frame.channel];
  const J1939Id id = J1939Id::of(frame.identifier());
  if (isNode(id.source)) {
    channel.nodes.heard(id.source, time);
    if (isOfItsOwnAccord(id)) channel.nodes.broadcast(id.source, time);
  }
  Device* sender = isNode(id.source) ? m_devices.findAddress(channelId, id.source) : nullptr;
  // Who was there before the link was down may not be there any more.
  if (sender != nullptr && channel.isBeforeGap(sender->lastHeard)) sender->addressSince = time;
  if (what.malformed) {
    channel.nodes.countMalformed(id.source);
    if (what.message == MessageId::BasicJoystick || what.message == MessageId::ExtendedJoystick)
      channel.joysticks.heardMalformed(id.source);
  }
  if (commandsAddress(frame, id)) channel.namesAsked = time;

  if (what.isDecoded()) {
    const Message& message = messageOf(what.message);
    switch (what.message) {
      case MessageId::BasicJoystick: channel.joysticks.heardBasic(id.source, frame, time); break;
      case MessageId::ExtendedJoystick: channel.joysticks.heardExtended(id.source, frame, time); break;
      case MessageId::Request:
        if (readBits(frame.data, kRequested) == pgn::kAddressClaimed)
          namesAsked(channel, channelId, id.destination, time);
        break;
      case MessageId::Name: nameHeard(channelId, frame, time); break;
      case MessageId::AddressAnnouncement:
        if (id.destination != kGlobalAddress) break;
        announced(channel, channelId, id.source, frame, time);
        sender = m_devices.findAddress(channelId, id.source);
        break;
      case MessageId::SoePermissive:
        if (Device* device = m_devices.findAddress(channelId, id.destination))
          device->take(frame, what.message, time);
        break;
      default:
        if (message.family == Family::Akron && message.device == DeviceEnd::Sender && isNode(id.source)) {
          // Whoever only sends to a device of Akron's is none: other makers use these types too. Nothing tells which
          // end is the device if both may be.
          const bool isPresumed = what.family == Family::Presumed && !isDynamicAddress(id.destination);
          const bool isDevice = isPresumed || channel.book.isAkron(id.source);
          if (sender == nullptr && isDevice) sender = m_devices.atAddress(channelId, id.source, time);
          if (sender != nullptr) sender->take(frame, what.message, time);
        } else if (message.part == Part::Asks) {
          if (Device* device = m_devices.findAddress(channelId, id.destination))
            device->asked(message.request, time);
        }
        break;
    }
  }
  if (sender != nullptr) {
    sender->heard(time);
    if (what.malformed) sender->takeMalformed(frame, what.message, time);
  }
}

void State::namesAsked(ChannelState& channel, Channel channelId, Address destination, Instant time) {
  if (destination == kGlobalAddress) {
    channel.namesAsked = time;
  } else if (Device* device = m_devices.findAddress(channelId, destination)) {
    device->provoked = time;
  }
}

// A device says its NAME when it starts, when it is asked for it, and when another one claims its address. On a bus
// where all prefer the same address, each start is a contest, too.
void State::nameHeard(Channel channelId, const Frame& frame, Instant time) {
  const ChannelState& channel = m_channels[channelId.value];
  const Address source = J1939Id::of(frame.identifier()).source;
  const Name name = Name::of(frame);
  if (name.isNull()) return;
  if (const Pin pin = channel.book.pin(source); !pin.isNull()) m_devices.named(channelId, source, pin);
  for (Device& device : m_devices.all()) {
    const bool isJ1939 = device.kind == Device::Kind::Pin || device.kind == Device::Kind::Address;
    if (!isJ1939 || device.channel != channelId) continue;
    if (!isNamed(device, name, channel.book)) {
      if (isPushed(device, source, time)) device.provoked = time;
    } else if (isNode(source) && maySayStart() && isStart(channel, device, time)) {
      device.starts(time);
    }
  }
}

void State::announced(ChannelState& channel, Channel channelId, Address source, const Frame& frame,
                      Instant time) {
  const std::optional<Pin> pin = announcedPin(frame);
  if (!pin || !isNode(source)) return;
  const Device* before = m_devices.findAddress(channelId, source);
  // Whoever says who it is from where it was before, and not as the end of its first start, may have just started.
  const bool hasStayed =
      before != nullptr &&
      (before->kind == Device::Kind::Pin ? before->pin == *pin : time - before->addressSince > kOneStart);
  m_devices.announced(channelId, source, *pin, time);
  Device* device = m_devices.findAddress(channelId, source);
  if (device != nullptr && hasStayed && maySayStart() && isStart(channel, *device, time))
    device->starts(time);
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
    device->takeMalformed(frame, what.message, time);
  } else {
    device->take(frame, what.message, time);
  }
  if (!fromNode) return;
  device->heard(time);
}

void State::apply(const Note& note) {
  timeCame(std::max(note.time, m_cursor.time));
  if (std::holds_alternative<note::Locked>(note.value)) m_locked = true;
  if (std::holds_alternative<note::Unlocked>(note.value)) m_locked = false;
  if (std::holds_alternative<note::Filtered>(note.value)) m_isFiltered = true;
  if (const auto* added = std::get_if<note::Added>(&note.value))
    m_addedUntil = std::max(m_addedUntil, m_cursor.frames + added->count);
  const auto about = channelOf(note.value);
  if (!about || about->value >= kMaxChannels) return;
  ChannelState& channel = use(*about);
  std::visit(Overload{[&](const note::LinkUp& n) {
                        linkIs(*about, ChannelLink::Up);
                        channel.bitRate = n.bitRate;
                        channel.controller = ControllerState::Unknown;
                      },
                      [&](const note::LinkDown&) { linkIs(*about, ChannelLink::Down); },
                      [&](const note::Dropped& n) { channel.dropped += n.count; },
                      [&](const note::DriveSaid& n) { channel.book.sayDrive(n.address, n.isDrive); },
                      [&](const note::OwnAddress& n) {
                        channel.ownAddress = n.address;
                        if (isNode(n.address)) channel.wereOwn.set(n.address.value);
                      },
                      [](const note::Locked&) {},
                      [](const note::Unlocked&) {},
                      [](const note::Mark&) {},
                      [](const note::Asked&) {},
                      [](const note::AnglesBefore&) {},
                      [](const note::RequestWaits&) {},
                      [](const note::RequestEnded&) {},
                      [](const note::StillWaits&) {},
                      [](const note::Pipe&) {},
                      [](const note::LeftOut&) {},
                      [](const note::Label&) {},
                      [](const note::Added&) {},
                      [](const note::Filtered&) {},
                      [](const note::RanUntil&) {},
                      [](const note::MotionArmed&) {},
                      [](const note::MotionEnded&) {},
                      [](const note::MotionLate&) {}},
             note.value);
}

// No time-out runs while nothing can be heard.
void State::linkIs(Channel channelId, ChannelLink link) {
  ChannelState& channel = m_channels[channelId.value];
  if (channel.link == link) return;
  const bool isBack = channel.link == ChannelLink::Down;
  channel.link = link;
  const bool isDown = link == ChannelLink::Down;
  if (isDown) channel.book.linkWentDown();
  if (isBack) {
    channel.book.linkCameBack();
    channel.nodes.linkCameBack();
    channel.joysticks.linkCameBack();
    m_devices.linkCameBack(channelId, m_cursor.time);
  }
  (isDown ? channel.linkDown : channel.linkUp) = m_cursor.time;
  const Instant since = isDown ? kNever : m_cursor.time;
  channel.joysticks.listensSince(since);
  for (Device& device : m_devices.all()) {
    if (device.kind != Device::Kind::Free && device.channel == channelId) device.listenedSince = since;
  }
  m_nextCheck = std::min(m_nextCheck, m_cursor.time);
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
    next = std::min({next, channel.book.nextDecision(), channel.joysticks.nextDeadline()});
  }
  return next;
}

void State::fire(Instant due) {
  m_devices.timeCame(due);
  for (std::size_t i = 0; i < m_channels.size(); ++i) {
    m_channels[i].joysticks.timeCame(due);
    const Channel channel{static_cast<std::uint8_t>(i)};
    AddressBook::Lost lost;
    if (m_channels[i].book.timeCame(due, lost)) lose(channel, lost, due);
  }
}

void State::lose(Channel channel, const AddressBook::Lost& lost, Instant time) {
  if (lost.none()) return;
  for (std::size_t a = 0; a < lost.size(); ++a) {
    if (!lost[a]) continue;
    const Address address{static_cast<std::uint8_t>(a)};
    m_devices.addressLost(channel, address, time);
    m_channels[channel.value].nodes.left(address);
  }
}

}  // namespace deckpipe
