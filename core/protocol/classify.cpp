// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/classify.h"

#include "bus/canopen.h"
#include "bus/j1939.h"
#include "protocol/address_book.h"
#include "protocol/lists.h"

namespace deckpipe {
namespace {

// A first byte of PGN EF00 names up to two messages, told apart by length or (41, 46) by direction.
struct TypeEntry {
  MessageId first = MessageId::Count;
  MessageId second = MessageId::Count;

  constexpr bool isKnown() const { return first != MessageId::Count; }
  constexpr bool isShared() const { return isKnown() && messageOf(first).sharedType; }
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
  } else if (book.openRequests().awaitsAnswer(type, id.source, id.destination, time)) {
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

  if (length > 0 && entry.isShared()) return {.family = Family::Ambiguous};
  if (!fits) return {};
  const MessageId message = akronMessage(entry, frame, id, time, book);
  const Message& m = messageOf(message);
  const Address device = m.device == DeviceEnd::Sender ? id.source : id.destination;
  if (m.broadcast != broadcast || (!isDynamicAddress(device) && !book.wasAkron(device))) return {};
  return decoded(Family::Presumed, message, length);
}

using SpecifierTable = std::array<MessageId, 256>;

// Which SDO a command specifier is in frames of one function code.
constexpr SpecifierTable makeSpecifiers(CobFunction function) {
  SpecifierTable table;
  table.fill(MessageId::SdoOther);
  for (const Message& message : gateway::kMessages) {
    const bool isHere = message.selector == static_cast<std::uint32_t>(function) ||
                        (message.selector == static_cast<std::uint32_t>(CobFunction::SdoResponse) &&
                         message.device == DeviceEnd::Either);
    if (!isHere || message.firstByte < 0) continue;
    for (unsigned byte = 0; byte < table.size(); ++byte) {
      if ((byte | message.sizeBits) == (static_cast<unsigned>(message.firstByte) | message.sizeBits))
        table[byte] = message.id;
    }
  }
  return table;
}
constexpr SpecifierTable kSdoRequests = makeSpecifiers(CobFunction::SdoRequest);
constexpr SpecifierTable kSdoResponses = makeSpecifiers(CobFunction::SdoResponse);

Classified classifySdo(const Frame& frame, const SpecifierTable& specifiers) {
  if (frame.length == 0) return decoded(Family::Canopen, MessageId::SdoOther, 0);
  const MessageId id = specifiers[frame.data[0]];
  Classified result = decoded(Family::Canopen, id, frame.length);
  if (messageOf(id).sizeBits != 0) {
    result.wanted = lengths(4 + sdo::valueSize(frame.data[0]), 8u);
    result.malformed = !allows(result.wanted, frame.length);
  }
  return result;
}

// The message of each function code of the predefined connection set, SDOs apart.
constexpr std::size_t kFunctions = 16;
constexpr std::size_t functionIndex(std::uint32_t function) { return function >> 7; }
constexpr std::array<MessageId, kFunctions> kByFunction = [] {
  std::array<MessageId, kFunctions> table;
  table.fill(MessageId::Count);
  for (const Message& message : kCatalogue) {
    if (message.family == Family::Canopen) table[functionIndex(message.selector)] = message.id;
    if (message.pdo != 0) table[functionIndex(message.pdo)] = message.id;
  }
  return table;
}();

// PDOs say nothing of whose they are: known only from their node, and then told by first byte and length.
Classified classifyPdo(const Frame& frame, NodeId node, const AddressBook& book, MessageId id) {
  const bool akron = book.isAkronNode(node);
  const int firstByte = messageOf(id).firstByte;
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
  const MessageId id = kByFunction[functionIndex(cob.function)];
  switch (static_cast<CobFunction>(cob.function)) {
    case CobFunction::SdoResponse: return classifySdo(frame, kSdoResponses);
    case CobFunction::SdoRequest: return classifySdo(frame, kSdoRequests);
    case CobFunction::Nmt: return {};
    default: break;
  }
  if (id == MessageId::Count) return {};
  if (isPdo(cob.function)) return classifyPdo(frame, cob.node, book, id);
  return decoded(Family::Canopen, id, frame.length);
}

}  // namespace

Classified classify(const Frame& frame, Instant time, const AddressBook& book) {
  if ((frame.id & (kRemoteBit | kErrorBit)) != 0 || frame.length > 8) return {};
  if (!frame.isExtended()) return classifyStandard(frame, book);
  const J1939Id id = J1939Id::of(frame.identifier());
  if (id.pgn == pgn::kProprietaryA) return classifyProprietary(frame, id, time, book);
  for (const Message& message : j1939::kMessages) {
    if (message.selector == id.pgn) return decoded(Family::J1939, message.id, frame.length);
  }
  return {};
}

}  // namespace deckpipe
