// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/classify.h"

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/address_book.h"
#include "protocol/catalogue.h"

namespace deckpipe {
namespace {

// A first byte of PGN EF00 names up to two messages, told apart by length or (41, 46) by direction.
struct TypeEntry {
  MessageId first = MessageId::Count;
  MessageId second = MessageId::Count;

  constexpr bool isKnown() const { return first != MessageId::Count; }
  constexpr Lengths lengths() const {
    return static_cast<Lengths>(messageOf(first).lengths |
                                (second == MessageId::Count ? Lengths{0} : messageOf(second).lengths));
  }
};
using TypeTable = std::array<TypeEntry, 256>;

constexpr TypeTable makeTable(Family family) {
  TypeTable table;
  table.fill(
      {});  // explicitly: g++ 12 leaves zeros behind the last entry written where it only is initialised
  for (const Message& message : kCatalogue) {
    if (message.family != family || message.selector != pgn::kProprietaryA) continue;
    TypeEntry& entry = table[static_cast<std::size_t>(message.firstByte)];
    (entry.isKnown() ? entry.second : entry.first) = message.id;
  }
  return table;
}
constexpr TypeTable kAkronTypes = makeTable(Family::Akron);
constexpr TypeTable kCopleyCommands = makeTable(Family::Copley);

constexpr std::uint8_t kPipeType = 0xFE;

constexpr bool isDynamicAddress(Address a) { return a.value >= 0x80 && a.value <= 0xF7; }

Classified decoded(Family family, MessageId id, unsigned length) {
  const Lengths wanted = messageOf(id).lengths;
  return {family, id, !allows(wanted, length), wanted};
}

// Types 41 and 46 look the same both ways.
MessageId requestOrAck(const TypeEntry& entry, std::uint8_t type, const J1939Id& id, Instant time,
                       const AddressBook& book) {
  const bool fromAkron = book.isAkron(id.source);
  const bool toAkron = book.isAkron(id.destination);
  bool ack;
  if (fromAkron != toAkron) {
    ack = fromAkron;
  } else if (book.exchanges().awaitsAnswer(type, id.source, id.destination, time)) {
    ack = true;
  } else {
    ack = !fromAkron && isDynamicAddress(id.source) && !isDynamicAddress(id.destination);
  }
  return ack ? entry.second : entry.first;
}

MessageId akronMessage(const TypeEntry& entry, const Frame& frame, const J1939Id& id, Instant time,
                       const AddressBook& book) {
  if (entry.second == MessageId::Count || !allows(messageOf(entry.second).lengths, frame.length))
    return entry.first;
  if (!allows(messageOf(entry.first).lengths, frame.length)) return entry.second;
  return requestOrAck(entry, frame.data[0], id, time, book);
}

// PGN EF00 in the order of protocol.md 1.3.
Classified classifyProprietary(const Frame& frame, const J1939Id& id, Instant time, const AddressBook& book) {
  const bool broadcast = id.destination == kGlobalAddress;
  const bool driveSends = book.isDrive(id.source);
  const bool driveReceives = !broadcast && book.isDrive(id.destination);
  const bool akronSends = book.isAkron(id.source);
  const bool akronReceives = !broadcast && book.isAkron(id.destination);
  const unsigned length = frame.length;
  const std::uint8_t type = frame.data[0];

  if (!broadcast && (driveSends || driveReceives)) {
    if ((driveSends && akronReceives) || (driveReceives && akronSends)) return {.family = Family::Ambiguous};
    const TypeEntry& entry = kCopleyCommands[type];
    if (length == 0 || !entry.isKnown()) return {.family = Family::Copley};
    return decoded(Family::Copley, entry.first, length);
  }

  const TypeEntry& entry = kAkronTypes[type];
  const bool known = length > 0 && entry.isKnown();
  const bool fits = known && allows(entry.lengths(), length);
  if (akronSends || akronReceives) {
    if (!known) return {.family = Family::Akron};
    if (!fits) return {Family::Akron, entry.first, true, entry.lengths()};
    return decoded(Family::Akron, akronMessage(entry, frame, id, time, book), length);
  }

  if (book.isForeign(id.source) && (broadcast || book.isForeign(id.destination)))
    return {.family = Family::Other};

  if (length > 0 && type == kPipeType) return {.family = Family::Ambiguous};
  if (!fits) return {};
  const MessageId message = akronMessage(entry, frame, id, time, book);
  const Message& m = messageOf(message);
  const Address device = m.device == DeviceEnd::Sender ? id.source : id.destination;
  if (m.broadcast != broadcast || !isDynamicAddress(device)) return {};
  return decoded(Family::Presumed, message, length);
}

MessageId sdoMessage(std::uint8_t specifier, bool response) {
  switch (specifier) {
    case 0x80: return MessageId::SdoAbort;
    case 0x40: return response ? MessageId::SdoOther : MessageId::SdoReadRequest;
    case 0x60: return response ? MessageId::SdoWriteResponse : MessageId::SdoOther;
    case 0x43:
    case 0x47:
    case 0x4B:
    case 0x4F: return response ? MessageId::SdoReadResponse : MessageId::SdoOther;
    case 0x23:
    case 0x27:
    case 0x2B:
    case 0x2F: return response ? MessageId::SdoOther : MessageId::SdoWriteRequest;
    default: return MessageId::SdoOther;
  }
}

Classified classifySdo(const Frame& frame, bool response) {
  if (frame.length == 0) return decoded(Family::Canopen, MessageId::SdoOther, 0);
  const MessageId id = sdoMessage(frame.data[0], response);
  Classified result = decoded(Family::Canopen, id, frame.length);
  if (id == MessageId::SdoReadResponse || id == MessageId::SdoWriteRequest) {
    result.wanted = lengths(4 + sdo::valueSize(frame.data[0]), 8u);
    result.malformed = !allows(result.wanted, frame.length);
  }
  return result;
}

// PDOs say nothing of whose they are: known only from their node, and then told by first byte and length.
Classified classifyPdo(const Frame& frame, NodeId node, const AddressBook& book, MessageId id,
                       int firstByte) {
  const bool akron = book.isAkronNode(node);
  if (firstByte >= 0 && (frame.length == 0 || frame.data[0] != firstByte)) {
    return {.family = akron ? Family::Canopen : Family::None};
  }
  const Classified result = decoded(akron ? Family::Canopen : Family::Presumed, id, frame.length);
  return result.malformed && !akron ? Classified{} : result;
}

Classified classifyStandard(const Frame& frame, const AddressBook& book) {
  const CobId cob = CobId::of(frame.identifier());
  if (frame.identifier() == 0) return decoded(Family::Canopen, MessageId::NmtCommand, frame.length);
  if (cob.node.value == 0) return {};
  switch (static_cast<CobFunction>(cob.function)) {
    case CobFunction::Heartbeat: return decoded(Family::Canopen, MessageId::Heartbeat, frame.length);
    case CobFunction::SdoResponse: return classifySdo(frame, true);
    case CobFunction::SdoRequest: return classifySdo(frame, false);
    case CobFunction::Tpdo1: return classifyPdo(frame, cob.node, book, MessageId::PositionLimitStatus, 0x01);
    case CobFunction::Tpdo2: return classifyPdo(frame, cob.node, book, MessageId::DigitalOutputs, 0x83);
    case CobFunction::Rpdo1: return classifyPdo(frame, cob.node, book, MessageId::GatewayJoystick, -1);
    default: return {};
  }
}

}  // namespace

Classified classify(const Frame& frame, Instant time, const AddressBook& book) {
  if ((frame.id & (kRemoteBit | kErrorBit)) != 0 || frame.length > 8) return {};
  if (!frame.isExtended()) return classifyStandard(frame, book);
  const J1939Id id = J1939Id::of(frame.identifier());
  switch (id.pgn) {
    case pgn::kProprietaryA: return classifyProprietary(frame, id, time, book);
    case pgn::kBasicJoystick: return decoded(Family::J1939, MessageId::BasicJoystick, frame.length);
    case pgn::kExtendedJoystick: return decoded(Family::J1939, MessageId::ExtendedJoystick, frame.length);
    case pgn::kAddressClaimed: return decoded(Family::J1939, MessageId::Name, frame.length);
    case pgn::kRequest: return decoded(Family::J1939, MessageId::Request, frame.length);
    default: return {};
  }
}

}  // namespace deckpipe
