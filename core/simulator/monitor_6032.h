// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated 6032 Universal II on a Trident monitor: what it says on the bus and which messages it obeys.
// What moves it is MonitorControl's. A control loop runs every 10 ms, so a time-out (200 ms of a joystick,
// 300 ms of the permissive) takes effect within the 10 ms after it.
// Source: CAN Messaging manual, message types 01, 81-83, A1, 02, 21, 22, 41, 45, 46 and Appendices A-C.
#pragma once

#include <array>

#include "protocol/typed.h"
#include "simulator/axis.h"
#include "simulator/device.h"
#include "simulator/joystick_inputs.h"

namespace deckpipe::simulator {

// 0.1 degree, as the messages have it; mechanical zero is dead ahead and level.
struct MonitorSettings {
  int softLeft = -900, softRight = 900, softDown = -200, softUp = 800;
  int oscillationLeft = -300, oscillationRight = 450;
  bool startsStowed = true;   // else dead ahead and level
  bool soeMode = false;       // a permissive (A1) is required to move
  bool aimAtNeutral = false;  // see JoystickInputs
};

// What moves the simulated monitor: five axes, soft limits, and the functions that were started (oscillate,
// stow, deploy, discharge valve). Monitor6032 steps it every 10 ms with what the joysticks ask for and under
// which conditions it may move; nothing else moves it. No frames, no time but the steps.
// Sources: CAN Messaging manual, Appendices B and C; message A1. Speeds, travels and the stow position are
// ours, of the size of a real Trident.
//
// 1. A hand (stick or point aim) always wins over what was started, and ends it: oscillation by rotation,
//    stowing and deploying by either axis.
// 2. Enable off: nothing moves, and what was started is over; enabling starts nothing again.
// 3. Hard stops always hold. Soft limits hold where there is feedback, but not on the way to and from stow.
// 4. Without feedback there is no oscillation, stowing, deploying or point aim.
class MonitorControl {
 public:
  static constexpr Duration kStep = 10ms;
  // Mechanical range and stow position, 0.1 degree.
  static constexpr int kHardLeft = -1750, kHardRight = 1750, kHardDown = -450, kHardUp = 900;
  static constexpr int kStowRotation = 0, kStowElevation = -400;

  // Under which it may move in one step.
  struct Conditions {
    bool enabled = true;
    bool rotationFeedback = true, elevationFeedback = true;
    Permissive permissive{true, true, true, true};
    std::array<bool, 5> motorFault{};
  };

  explicit MonitorControl(const MonitorSettings& settings);

  void step(const Demand& demand, const Conditions& conditions);
  // The motors are off and what was started is over; everything stays where it is.
  void stop();
  // Both positions count from here on as zero (message 41). Soft limits keep their numbers.
  void zero();

  // As reported, 0.1 degree.
  int rotation() const;
  int elevation() const;
  SoftLimits rotationLimits() const;
  SoftLimits elevationLimits() const;
  const std::array<Axis, 5>& axes() const { return m_axes; }
  bool isStowed() const;
  bool isAiming() const { return m_aiming; }
  bool isDischargeOpen() const { return !m_axes[4].isAtLow(); }
  bool isHighFlow() const { return m_axes[3].travelled() > 500'000; }

 private:
  enum class Started : std::uint8_t { Nothing, Stow, Deploy };

  void start(const Functions& pressed, const Conditions& conditions);
  void handMoved(const Demand& demand);
  void limitAxes(const Conditions& conditions);
  void commandRotation(const Demand& demand, bool feedback);
  void commandElevation(const Demand& demand, bool feedback);
  void commandStow();
  void commandValves(const Functions& functions);

  MonitorSettings m_settings;
  std::array<Axis, 5> m_axes;  // Appendix C: rotation, elevation, pattern, flow, discharge valve
  int m_zeroRotation = 0, m_zeroElevation = 0;  // micro-degrees
  Oscillation m_oscillation;
  Started m_started = Started::Nothing;
  int m_valve = 0;  // started: +1 opening, -1 closing
  bool m_aiming = false;
  Functions m_before;
};

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
