// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/address_claim.h"

#include <bit>
#include <cassert>
#include <string>

#include "protocol/catalogue.h"
#include "protocol/device_types.h"

namespace deckpipe::simulator {

void AddressClaim::start(Instant now, Outbox& out) { claim(now, m_range.first, out); }

void AddressClaim::startElsewhere(Instant now, Outbox& out) {
  m_address = m_last == kNullAddress ? m_range.first : m_last;
  claim(now, nextFree().value_or(m_range.first), out);
}

void AddressClaim::stop() {
  if (m_state == State::Claimed) m_last = m_address;
  m_state = State::Off;
  m_address = kNullAddress;
  m_deadline = kNever;
  m_holders.fill(0);
}

void AddressClaim::claim(Instant now, Address address, Outbox& out) {
  m_state = State::Contending;
  m_address = address;
  m_deadline = now + kContention;
  out.post(now, nameFrame(m_name, address));
}

// J1939-81 spreads these over 153 ms (0..255 times 0.6 ms), because all of them have the same identifier.
void AddressClaim::cannotClaim(Instant now, Outbox& out) {
  m_state = State::CannotClaim;
  m_address = kNullAddress;
  m_deadline = kNever;
  out.post(now + m_random.between(0, 255) * Duration(600us), nameFrame(m_name, kNullAddress));
}

std::optional<Address> AddressClaim::nextFree() const {
  const unsigned count = 1u + m_range.last.value - m_range.first.value;
  for (unsigned i = 1; i < count; ++i) {
    const unsigned offset = (m_address.value - m_range.first.value + i) % count;
    const Address candidate{static_cast<std::uint8_t>(m_range.first.value + offset)};
    if (m_holders[candidate.value] == 0) return candidate;
  }
  return {};
}

AddressClaim::Event AddressClaim::received(Instant now, const J1939Id& id, const Frame& frame, Outbox& out) {
  if (m_state == State::Off) return Event::None;
  if (id.pgn == pgn::kAddressClaimed && frame.length == 8)
    return claimHeard(now, id.source, Name::of(frame), out);
  constexpr BitRange kRequested = fieldOf(j1939::kRequestFields, "pgn").bits;
  if (id.pgn == pgn::kRequest && frame.length >= j1939::kRequestLength &&
      readBits(frame.data, kRequested) == pgn::kAddressClaimed)
    return requestHeard(now, id.destination, out);
  return Event::None;
}

AddressClaim::Event AddressClaim::claimHeard(Instant now, Address source, Name name, Outbox& out) {
  if (source == kGlobalAddress || name.value == 0 || name == m_name) return Event::None;
  for (std::uint64_t& holder : m_holders) {
    if (holder == name.value) holder = 0;  // it has moved, or could not claim
  }
  if (source == kNullAddress) return Event::None;
  const bool contested = source == m_address;
  if (contested && m_name.value < name.value) {
    const bool claimed = m_state == State::Claimed;
    claim(now + kThinking, m_address, out);
    // Who has the address already keeps using it while it defends it.
    if (claimed) {
      m_state = State::Claimed;
      m_deadline = kNever;
    }
    return Event::None;
  }
  m_holders[source.value] = name.value;
  if (!contested) return Event::None;
  out.clear();
  if (const auto next = nextFree()) {
    claim(now + kThinking, *next, out);
  } else {
    cannotClaim(now, out);
  }
  return Event::Lost;
}

AddressClaim::Event AddressClaim::requestHeard(Instant now, Address destination, Outbox& out) {
  if (destination != kGlobalAddress && (m_state != State::Claimed || destination != m_address))
    return Event::None;
  if (m_state == State::Contending) return Event::None;  // its claim was the answer
  if (m_state == State::CannotClaim) {
    cannotClaim(now, out);
  } else {
    out.post(now + kThinking, nameFrame(m_name, m_address));
  }
  return Event::Answered;
}

AddressClaim::Event AddressClaim::timeCame(Instant now, Outbox&) {
  if (now < m_deadline) return Event::None;
  m_deadline = kNever;
  m_state = State::Claimed;
  return Event::Claimed;
}

Name akronName(std::uint32_t identityNumber) {
  const Encoded name =
      encoded(MessageId::Name, {{"identity_number", Value::integer(identityNumber)},
                                {"manufacturer_code", Value::integer(j1939::kAkronManufacturer)},
                                {"function", Value::integer(66)},
                                {"industry_group", Value::integer(1)},
                                {"arbitrary_address_capable", Value::flag(true)}});
  return {loadLittle(name.data)};
}

Identity identityOf(std::string_view pin, PcodeVersion pcode, ConfigVersion config) {
  const auto parsed = Pin::parse(pin);
  assert(parsed);
  Identity identity;
  identity.pin = parsed.value_or(Pin());
  identity.name = akronName(deckpipe::identityOf(*identity.pin));
  identity.model = deviceTypeName(identity.pin->deviceType());
  identity.pcode = pcode;
  identity.config = config;
  return identity;
}

Encoded encoded(MessageId id, std::initializer_list<FieldValue> values) {
  const auto result = encode(messageOf(id), values);
  assert(result);
  return result ? result.value() : Encoded{};
}

Frame nameFrame(Name name, Address source) {
  return j1939Frame(messageOf(MessageId::Name), {std::bit_cast<Payload>(name.value), 8}, source);
}

Frame announcementFrame(const Pin& pin, Address source) {
  return j1939Frame(messageOf(MessageId::AddressAnnouncement),
                    encoded(MessageId::AddressAnnouncement, {{"pin", Value::pin(pin)}}), source);
}

}  // namespace deckpipe::simulator
