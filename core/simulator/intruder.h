// SPDX-License-Identifier: GPL-3.0-or-later
// A foreign controller that claims one fixed address with a NAME lower than any of Akron's, and so takes it
// from whoever has it: Simulator puts one on the bus for Misbehaviour::addressTaken. It answers requests for its
// NAME and does nothing else: polls and the pipe are Akron's.
#pragma once

#include "simulator/device.h"

namespace deckpipe::simulator {

class Intruder : public Device {
 public:
  // `number` tells several apart.
  Intruder(Address address, std::uint32_t number)
      : Device(foreign(number), Duration{0}, number, {address, address}) {}

  // Not arbitrary address capable, so the highest bit is off and the NAME lower than theirs.
  static Identity foreign(std::uint32_t number) {
    const Encoded name = encoded(MessageId::Name, {{"identity_number", Value::integer(number)},
                                                   {"manufacturer_code", Value::integer(kSomebody)},
                                                   {"function", Value::integer(130)}});
    Identity result;
    result.name = {loadLittle(name.data)};
    return result;
  }

 private:
  static constexpr int kSomebody = 2000;  // any code but Akron's
};

}  // namespace deckpipe::simulator
