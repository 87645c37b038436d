// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated 6032 Universal II on a Trident monitor: what it says on the bus and which messages it obeys.
// What moves it is MonitorControl's. A control loop runs every 10 ms, so a time-out (200 ms of a joystick,
// 300 ms of the permissive) takes effect within the 10 ms after it.
// Source: CAN Messaging manual, message types 01, 81-83, A1, 02, 21, 22, 41, 45, 46 and Appendices A-C.
#pragma once

#include "simulator/device.h"
#include "simulator/monitor_control.h"

namespace deckpipe::simulator {

class Monitor6032 : public Device {
 public:
  static constexpr Duration kStatusPeriod = 100ms;
  static constexpr Duration kPermissiveTimeout = 300ms;
  // pCode error codes: 11 is the one the manual names; the other axis' is ours.
  static constexpr std::uint16_t kRotationSensorError = 11, kElevationSensorError = 12;

  Monitor6032(std::string_view pin, const MonitorSettings& settings, std::uint64_t seed);

  const MonitorControl& control() const { return m_control; }
  // Message 46 was taken; only a reset leaves it. What setup mode does the manual does not say.
  bool isInSetupMode() const { return m_setupMode; }

 protected:
  void started(Instant now) override;
  void tick(Instant now) override;
  void heard(Instant now, const J1939Id& id, const Frame& frame) override;
  std::uint16_t pcodeError() const override;
  std::string ownStatus() const override;

 private:
  MonitorControl::Conditions conditions(Instant now) const;
  void sendStatuses(Instant now);
  void heardRequest(Instant now, const J1939Id& id, const Frame& frame);
  void answerVista(Instant now, Address to);
  bool hasFeedback() const { return !misbehaviour().feedbackNotFitted; }
  bool isPanelLedOn(Instant now) const;

  MonitorSettings m_settings;
  MonitorControl m_control;
  JoystickInputs m_inputs;
  Permissive m_permissive;
  Instant m_permissiveHeard = kNotYet;
  Instant m_startedAt{};
  unsigned m_untilStatus = 1;  // steps
  bool m_setupMode = false;
};

}  // namespace deckpipe::simulator
