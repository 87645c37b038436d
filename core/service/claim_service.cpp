// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/claim_service.h"

#include "bus/j1939.h"

namespace deckpipe {
namespace {

using How = note::OwnAddress::How;

constexpr BitRange kRequested = fieldOf(j1939::kRequestFields, "pgn").bits;

Encoded encodedName(Name name) { return {std::bit_cast<Payload>(name.value), 8}; }

}  // namespace

Name consoleName(std::uint32_t identityNumber) {
  constexpr std::uint64_t kNoManufacturer = 0x7FF;
  using j1939::kNameFields;
  Payload name{};
  writeBits(name, fieldOf(kNameFields, "identity_number").bits, identityNumber);
  writeBits(name, fieldOf(kNameFields, "manufacturer_code").bits, kNoManufacturer);
  writeBits(name, fieldOf(kNameFields, "function").bits, kServiceToolFunction);
  writeBits(name, fieldOf(kNameFields, "arbitrary_address_capable").bits, 1);
  return {loadLittle(name)};
}

ClaimService::ClaimService(const ClaimSettings& settings)
    : m_settings(settings), m_spread(settings.identityNumber) {
  if (addressUse(m_settings.preferred) == AddressUse::Refused) m_settings.preferred = kServiceTool1;
  m_status.name = consoleName(settings.identityNumber).value;
}

void ClaimService::start(Instant now, const Live& live, Outgoing& out) {
  const std::uint64_t name = m_status.name;
  m_status = {};
  m_status.name = name;
  m_status.progress = Progress::Asking;
  m_lost.reset();
  m_deadline = now + kListen;
  askNames(live, out);
}

void ClaimService::stop() {
  m_status.progress = Progress::Off;
  m_status.address = kNullAddress;
  m_deadline = kNever;
}

void ClaimService::askNames(const Live& live, Outgoing& out) {
  Encoded data{.length = 3};
  writeBits(data.data, kRequested, pgn::kAddressClaimed);
  Live from = live;
  from.own = address();
  out.send(from, MessageId::Request, kGlobalAddress, data);
}

void ClaimService::sendName(const Live& live, Address from, Outgoing& out) const {
  Live sender = live;
  sender.own = from;
  out.send(sender, MessageId::Name, kGlobalAddress, encodedName({m_status.name}));
}

// Neither taken by another NAME nor in use without one.
bool ClaimService::isFree(const Live& live, Address address) const {
  const AddressBook& book = live.bus().book;
  if (m_lost[address.value]) return false;
  if (book.isHeld(address) && book.holder(address).value != m_status.name) return false;
  if (!book.isHeard(address)) return true;
  // Rule 7: others may have sent from a monitor's address that was ours, while we did not listen.
  return m_ours[address.value] && !isDynamicAddress(address);
}

void ClaimService::claimNext(Instant now, const Live& live, Outgoing& out) {
  for (const Address candidate : {m_settings.preferred, kServiceTool1, kServiceTool2}) {
    if (isFree(live, candidate)) return claim(now, live, candidate, out);
  }
  // From the top: Akron's devices claim theirs from 80 hex up.
  for (Address a = kLastDynamic; isDynamicAddress(a); --a.value) {
    if (isFree(live, a)) return claim(now, live, a, out);
  }
  cannotClaim(now, live, out);
}

void ClaimService::claim(Instant now, const Live& live, Address address, Outgoing& out) {
  m_status.progress = Progress::Claiming;
  m_status.address = address;
  m_ours.set(address.value);
  m_deadline = now + kClaimTime;
  sendName(live, address, out);
}

// J1939-81 spreads these over 153 ms, because all of them have the same identifier.
void ClaimService::cannotClaim(Instant now, const Live& live, Outgoing& out) {
  if (m_status.progress != Progress::CannotClaim)
    out.note(note::OwnAddress{live.channel, kNullAddress, How::CannotClaim});
  m_status.progress = Progress::CannotClaim;
  m_status.address = kNullAddress;
  m_spread = m_spread * 1'664'525u + 1'013'904'223u;
  m_deadline = now + (m_spread >> 24) * Duration(600us);
}

void ClaimService::timeCame(Instant now, const Live& live, Outgoing& out) {
  if (now < m_deadline) return;
  m_deadline = kNever;
  switch (m_status.progress) {
    case Progress::Asking: return claimNext(now, live, out);
    case Progress::Claiming:
      m_status.progress = Progress::Claimed;
      out.note(note::OwnAddress{live.channel, m_status.address, How::Claimed});
      return;
    case Progress::CannotClaim: return sendName(live, kNullAddress, out);
    case Progress::Off:
    case Progress::Claimed:
    case Progress::SameName: return;
  }
}

void ClaimService::received(Instant now, const Live& live, const Frame& frame, Outgoing& out) {
  if (m_status.progress == Progress::Off || m_status.progress == Progress::SameName) return;
  if (!frame.isExtended() || frame.isRemote() || frame.isError() || (frame.flags & Frame::kSent) != 0) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  const bool isClaim = id.pgn == pgn::kAddressClaimed && frame.length == 8;
  const bool isSameName = isClaim && Name::of(frame).value == m_status.name;
  if (id.source == m_status.address && isDynamicAddress(id.source) && !isSameName)
    return addressLost(now, live, out);
  if (isClaim) return claimHeard(now, live, id.source, Name::of(frame), out);
  if (id.pgn != pgn::kRequest || frame.length != 3 ||
      readBits(frame.data, kRequested) != pgn::kAddressClaimed)
    return;
  const bool hasAddress = m_status.address != kNullAddress;
  if (id.destination != kGlobalAddress && (!hasAddress || id.destination != m_status.address)) return;
  if (hasAddress) sendName(live, m_status.address, out);
  if (m_status.progress == Progress::CannotClaim) cannotClaim(now, live, out);
}

void ClaimService::claimHeard(Instant now, const Live& live, Address source, Name name, Outgoing& out) {
  if (source == kGlobalAddress || name.value == 0) return;
  if (name.value == m_status.name) {
    m_status.progress = Progress::SameName;
    m_status.address = kNullAddress;
    m_deadline = kNever;
    out.note(note::OwnAddress{live.channel, kNullAddress, How::SameName});
    return;
  }
  if (source == kNullAddress || m_status.address == kNullAddress || source != m_status.address) return;
  if (m_status.name < name.value) {
    ++m_status.won;
    // Who has the address already keeps using it while it defends it.
    return sendName(live, m_status.address, out);
  }
  addressLost(now, live, out);
}

void ClaimService::addressLost(Instant now, const Live& live, Outgoing& out) {
  ++m_status.lost;
  m_lost.set(m_status.address.value);
  out.note(note::OwnAddress{live.channel, kNullAddress, How::Lost});
  claimNext(now, live, out);
}

}  // namespace deckpipe
