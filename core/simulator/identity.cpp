// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/identity.h"

#include <bit>
#include <cassert>
#include <string>

#include "protocol/device_types.h"

namespace deckpipe::simulator {

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
                    encoded(MessageId::AddressAnnouncement, {{"pin", Value::text(pin.text())}}), source);
}

}  // namespace deckpipe::simulator
