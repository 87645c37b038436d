// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/claim_service.h"

#include <utility>

#include "bus/j1939.h"

namespace deckpipe {
namespace {

constexpr BitRange kRequested = fieldOf(j1939::kRequestFields, "pgn").bits;

// SAE J1939-21, Acknowledgement: says to all that we do not have what `to` asked us for.
Frame negativeAcknowledgement(Address from, Address to, std::uint32_t wanted) {
  Frame frame;
  frame.id = J1939Id{6, pgn::kAcknowledgement, from, kGlobalAddress}.frameId();
  frame.length = 8;
  frame.data = {1, 0xFF, 0xFF, 0xFF, to.value};
  writeBits(frame.data, little(6, 24), wanted);
  return frame;
}

Encoded encodedName(Name name) { return {std::bit_cast<Payload>(name.value), 8}; }

}  // namespace

Name nameOf(const ClaimSettings& settings) {
  constexpr std::uint64_t kNoManufacturer = 0x7FF;
  using j1939::kNameFields;
  Payload name{};
  writeBits(name, fieldOf(kNameFields, "identity_number").bits, settings.identityNumber);
  writeBits(name, fieldOf(kNameFields, "manufacturer_code").bits, kNoManufacturer);
  writeBits(name, fieldOf(kNameFields, "function_instance").bits, settings.functionInstance);
  writeBits(name, fieldOf(kNameFields, "function").bits, settings.function);
  writeBits(name, fieldOf(kNameFields, "arbitrary_address_capable").bits, 1);
  return {loadLittle(name)};
}

ClaimService::ClaimService(const ClaimSettings& settings, bool echoes)
    : m_settings(settings), m_echoes(echoes), m_spread(settings.identityNumber) {
  if (m_settings.isConsole && addressUse(m_settings.preferred) == AddressUse::Refused)
    m_settings.preferred = m_settings.second;
  m_status.name = nameOf(settings).value;
}

void ClaimService::linkChanged(Instant now, const Live& live, bool isOpen, Outgoing& out) {
  isOpen ? start(now, live, out) : stop(live, How::LinkLost, out);
}

void ClaimService::end(Instant, const Live& live, EndReason, Outgoing& out) { stop(live, How::Locked, out); }

void ClaimService::start(Instant now, const Live& live, Outgoing& out) {
  const std::uint64_t name = m_status.name;
  m_status = {};
  m_status.name = name;
  m_status.progress = Progress::Asking;
  m_lost.reset();
  m_conflict = kNotYet;
  m_hasSpoken = false;
  m_deadline = now + kListen;
  askNames(live, out);
}

void ClaimService::stop(const Live& live, How why, Outgoing& out) {
  if (address() != kNullAddress) noteAddress(live, kNullAddress, why, out);
  m_status.progress = Progress::Off;
  m_status.address = kNullAddress;
  m_status.isDisputed = false;
  m_deadline = kNever;
}

std::optional<Refusal> ClaimService::intentCame(Instant, const Live& live, const Intent& intent,
                                                Outgoing& out) {
  if (!m_settings.isConsole || !std::holds_alternative<intent::RequestNames>(intent)) return {};
  askNames(live, out);
  return Refusal::None;
}

void ClaimService::status(const Live&, ServiceStatus& into) const {
  if (m_settings.isConsole) into.claim = m_status;
}

void ClaimService::noteAddress(const Live& live, Address address, How how, Outgoing& out) const {
  if (m_settings.isConsole) out.note(note::OwnAddress{live.channel, address, how});
}

// From our address, or the null address before there is one.
void ClaimService::askNames(const Live& live, Outgoing& out) {
  Encoded data{.length = j1939::kRequestLength};
  writeBits(data.data, kRequested, pgn::kAddressClaimed);
  out.send(live, address(), MessageId::Request, kGlobalAddress, data);
}

FrameTag ClaimService::sendName(const Live& live, Address from, Outgoing& out) const {
  return out.send(live, from, MessageId::Name, kGlobalAddress, encodedName({m_status.name}), true);
}

// Neither taken by another NAME nor in use without one.
bool ClaimService::isFree(const Live& live, Address address) const {
  const AddressBook& book = live.bus().book;
  if (m_lost[address.value]) return false;
  if (book.isHeld(address) && book.holder(address).value != m_status.name) return false;
  if (!book.isHeard(address)) return true;
  // Rule 8: others may have sent from a monitor's address that was ours, while we did not listen.
  const bool wasOurs = m_ours[address.value] || book.holder(address).value == m_status.name ||
                       book.formerHolder(address).value == m_status.name;
  return wasOurs && !isDynamicAddress(address);
}

void ClaimService::claimNext(Instant now, const Live& live, Outgoing& out) {
  for (const Address candidate : {m_settings.preferred, m_settings.second, m_settings.third}) {
    if (isFree(live, candidate)) return claim(live, candidate, out);
  }
  for (unsigned a = m_settings.highest.value; a >= m_settings.lowest.value && a > 0; --a) {
    const Address candidate{static_cast<std::uint8_t>(a)};
    if (isFree(live, candidate)) return claim(live, candidate, out);
  }
  cannotClaim(now, live, out);
}

void ClaimService::claim(const Live& live, Address address, Outgoing& out) {
  m_status.progress = Progress::Claiming;
  m_status.address = address;
  m_ours.set(address.value);
  m_status.isOnBus = false;
  m_deadline = kNever;  // until it is known what became of the claim
  m_claim = sendName(live, address, out);
}

// J1939-81 spreads these over 153 ms, because all of them have the same identifier.
void ClaimService::cannotClaim(Instant now, const Live& live, Outgoing& out) {
  if (m_status.progress != Progress::CannotClaim) noteAddress(live, kNullAddress, How::CannotClaim, out);
  m_status.progress = Progress::CannotClaim;
  m_status.address = kNullAddress;
  m_spread = m_spread * 1'664'525u + 1'013'904'223u;
  m_deadline = now + (m_spread >> 24) * Duration(600us);
}

void ClaimService::writeEnded(Instant now, const Live&, FrameTag tag, WriteOutcome outcome, Outgoing&) {
  m_hasSpoken = m_hasSpoken || outcome == WriteOutcome::OnBus || outcome == WriteOutcome::CannotTell ||
                outcome == WriteOutcome::EchoLost;
  if (m_status.progress != Progress::Claiming || tag != m_claim) return;
  m_status.isOnBus = outcome == WriteOutcome::OnBus || outcome == WriteOutcome::CannotTell;
  if (m_status.isOnBus) {
    m_deadline = now + kClaimTime;
  } else if (outcome != WriteOutcome::Gone) {
    m_deadline = now + kClaimAgain;
  }
}

void ClaimService::timeCame(Instant now, const Live& live, Outgoing& out) {
  if (now < m_deadline) return;
  m_deadline = kNever;
  switch (m_status.progress) {
    case Progress::Asking: return claimNext(now, live, out);
    case Progress::Claiming:
      if (!m_status.isOnBus) return claimNext(now, live, out);
      m_status.progress = Progress::Claimed;
      noteAddress(live, m_status.address, How::Claimed, out);
      if (m_conflict != kNotYet && now - m_conflict <= kConflictOver) dispute(live, out);
      return;
    case Progress::CannotClaim: sendName(live, kNullAddress, out); return;
    case Progress::Claimed: m_status.isDisputed = false; return;
    case Progress::Off:
    case Progress::SameName: return;
  }
}

void ClaimService::received(Instant now, const Live& live, const Frame& frame, Outgoing& out) {
  if (m_status.progress == Progress::Off || m_status.progress == Progress::SameName) return;
  if (!frame.isExtended() || frame.isRemote() || frame.isError() || (frame.flags & Frame::kSent) != 0) return;
  const J1939Id id = J1939Id::of(frame.identifier());
  const bool isClaim = id.pgn == pgn::kAddressClaimed && frame.length == 8;
  const bool isSameName = isClaim && Name::of(frame).value == m_status.name;
  if (id.source == m_status.address && isDynamicAddress(id.source) && !isSameName && (isClaim || m_echoes))
    return leave(now, live, isClaim ? How::Lost : How::InUse, out);
  if (isClaim) return claimHeard(now, live, id.source, Name::of(frame), out);
  const bool hasAddress = m_status.address != kNullAddress;
  if (m_echoes && hasAddress && id.source == m_status.address && id.pgn != pgn::kAddressClaimed)
    return strangerHeard(now, live, out);
  if (id.pgn == pgn::kRequest && frame.length >= j1939::kRequestLength)
    requestHeard(now, live, id, frame, out);
}

void ClaimService::requestHeard(Instant now, const Live& live, const J1939Id& id, const Frame& frame,
                                Outgoing& out) {
  const bool hasAddress = m_status.address != kNullAddress;
  const bool isToUs = hasAddress && id.destination == m_status.address;
  if (!isToUs && id.destination != kGlobalAddress) return;
  const auto wanted = static_cast<std::uint32_t>(readBits(frame.data, kRequested));
  if (wanted != pgn::kAddressClaimed) {
    if (!isToUs || address() == kNullAddress) return;
    if (m_declined != kNotYet && now - m_declined < kDeclineAgain) return;
    m_declined = now;
    out.send(live, negativeAcknowledgement(address(), id.source, wanted));
    return;
  }
  if (hasAddress) sendName(live, m_status.address, out);
  if (m_status.progress == Progress::CannotClaim) cannotClaim(now, live, out);
}

void ClaimService::claimHeard(Instant now, const Live& live, Address source, Name name, Outgoing& out) {
  if (source == kGlobalAddress || name.value == 0) return;
  if (name.value == m_status.name) {
    if (!m_hasSpoken) return;
    m_status.progress = Progress::SameName;
    out.left.push_back(std::exchange(m_status.address, kNullAddress));
    m_deadline = kNever;
    noteAddress(live, kNullAddress, How::SameName, out);
    return;
  }
  if (source == kNullAddress || m_status.address == kNullAddress || source != m_status.address) return;
  if (m_status.name < name.value) {
    ++m_status.won;
    // Who has the address already keeps using it while it defends it.
    sendName(live, m_status.address, out);
    return;
  }
  leave(now, live, How::Lost, out);
}

void ClaimService::leave(Instant now, const Live& live, How why, Outgoing& out) {
  ++m_status.lost;
  m_lost.set(m_status.address.value);
  out.left.push_back(m_status.address);
  m_conflict = kNotYet;
  m_status.isDisputed = false;
  noteAddress(live, kNullAddress, why, out);
  claimNext(now, live, out);
}

void ClaimService::dispute(const Live& live, Outgoing& out) {
  m_status.isDisputed = true;
  m_deadline = m_conflict + kConflictOver;
  noteAddress(live, m_status.address, How::Disputed, out);
}

// It may not have heard our claim; then our NAME tells it.
void ClaimService::strangerHeard(Instant now, const Live& live, Outgoing& out) {
  if (!m_hasSpoken) return;
  if (m_conflict == kNotYet || now - m_conflict > kConflictOver) {
    m_conflict = now;
    ++m_status.conflicts;
    if (m_status.progress == Progress::Claimed) dispute(live, out);
    sendName(live, m_status.address, out);
  } else if (now - m_conflict >= kClaimTime) {
    leave(now, live, How::InUse, out);
  }
}

}  // namespace deckpipe
