// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated 6039 CAN I/O module: message 85 with its three inputs. There is no 6039 among the device
// types of a PIN, so it has a NAME and makes no announcement. Its collision-zone input follows a seeded
// script until somebody sets the inputs. Source: CAN Messaging manual, message type 85 and Appendix A.
#pragma once

#include "simulator/device.h"

namespace deckpipe::simulator {

class IoModule6039 : public Device {
 public:
  static constexpr Duration kStatusPeriod = 100ms;

  IoModule6039(std::uint32_t identityNumber, std::uint64_t seed);

  const DigitalInputs& inputs() const { return m_inputs; }
  // From now on the inputs are these, and the script is over.
  void setInputs(const DigitalInputs& inputs);

 protected:
  void started(Instant now) override;
  void tick(Instant now) override;

 private:
  DigitalInputs m_inputs;
  Random m_random;
  Instant m_changeAt = kNever;
  bool m_scripted = true;
};

}  // namespace deckpipe::simulator
