// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/monitor_6032.h"

#include <cstdio>
#include <cstdlib>

namespace deckpipe::simulator {
namespace {

// The manual's own example: 3356 Trident, analog sensors; Novotechnik sensors.
constexpr PcodeVersion kTrident{3356, 14, 0x0204};
constexpr ConfigVersion kNovotechnik{60320014, 0x0204};

// The panel LED blinks the error code, one flash a unit; the timing is ours.
constexpr Duration kFlash = 300ms, kBetweenCodes = 2s;

Status2 statusOf(bool on) { return on ? Status2::On : Status2::Off; }

PositionReading readingOf(int tenths, bool fitted, bool error) {
  if (!fitted) return {PositionState::NotFitted, 0};
  if (error) return {PositionState::SensorError, 0};
  return {PositionState::Ok, static_cast<std::int16_t>(tenths)};
}

}  // namespace

Monitor6032::Monitor6032(std::string_view pin, const MonitorSettings& settings, std::uint64_t seed)
    : Device(identityOf(pin, kTrident, kNovotechnik), MonitorControl::kStep, seed),
      m_settings(settings),
      m_control(settings),
      m_inputs(settings.aimAtNeutral) {}

void Monitor6032::started(Instant now) {
  m_control.stop();
  m_inputs.clear();
  m_permissiveHeard = kNotYet;
  m_startedAt = now;
  m_untilStatus = 1;
  m_setupMode = false;
}

std::uint16_t Monitor6032::pcodeError() const {
  if (!hasFeedback()) return 0;
  if (misbehaviour().rotationSensorError) return kRotationSensorError;
  return misbehaviour().elevationSensorError ? kElevationSensorError : std::uint16_t{0};
}

MonitorControl::Conditions Monitor6032::conditions(Instant now) const {
  constexpr std::uint32_t kMotors[] = {faultBit("motor_axis_1"), faultBit("motor_axis_2"),
                                       faultBit("motor_axis_3"), faultBit("motor_axis_4"),
                                       faultBit("motor_axis_5")};
  MonitorControl::Conditions c;
  c.enabled = !misbehaviour().enableOff;
  c.rotationFeedback = hasFeedback() && !misbehaviour().rotationSensorError;
  c.elevationFeedback = hasFeedback() && !misbehaviour().elevationSensorError;
  if (m_settings.soeMode) {
    const bool heard = m_permissiveHeard != kNotYet && now - m_permissiveHeard < kPermissiveTimeout;
    c.permissive = heard ? m_permissive : Permissive{};
  }
  for (std::size_t i = 0; i < c.motorFault.size(); ++i)
    c.motorFault[i] = (misbehaviour().faultBits & kMotors[i]) != 0;
  return c;
}

void Monitor6032::tick(Instant now) {
  m_inputs.expire(now);
  m_control.step(m_inputs.demand(), conditions(now));
  if (--m_untilStatus == 0) {
    m_untilStatus = static_cast<unsigned>(kStatusPeriod / MonitorControl::kStep);
    sendStatuses(now);
  }
}

bool Monitor6032::isPanelLedOn(Instant now) const {
  const int code = errorCode();
  if (code == 0) return true;
  const Duration phase = (now - m_startedAt) % (2 * code * kFlash + kBetweenCodes);
  return phase < 2 * code * kFlash && phase % (2 * kFlash) < kFlash;
}

void Monitor6032::sendStatuses(Instant now) {
  PositionLimitStatus position;
  position.rotation = readingOf(m_control.rotation(), hasFeedback(), misbehaviour().rotationSensorError);
  position.elevation = readingOf(m_control.elevation(), hasFeedback(), misbehaviour().elevationSensorError);
  for (std::size_t i = 0; i < m_control.axes().size(); ++i) {
    position.plusStop[i] = statusOf(m_control.axes()[i].isAtHigh());
    position.minusStop[i] = statusOf(m_control.axes()[i].isAtLow());
  }
  position.operationalError = statusOf(errorCode() != 0);
  position.calibrated = statusOf(hasFeedback());
  broadcast(now, MessageId::PositionLimitStatus, position.encode());
  if (hasFeedback()) {
    broadcast(now, MessageId::RotationSoftLimits, m_control.rotationLimits().encodeRotation());
    broadcast(now, MessageId::ElevationSoftLimits, m_control.elevationLimits().encodeElevation());
  }
  DigitalOutputs outputs;
  outputs.panelLed = isPanelLedOn(now);
  outputs.pointAimLed = outputs.pointAimMode = m_control.isAiming();
  outputs.highFlow = m_control.isHighFlow();
  outputs.dischargeValve = m_control.isDischargeOpen();
  outputs.soeMode = m_settings.soeMode;
  outputs.stowed = m_control.isStowed();
  outputs.active = !outputs.stowed;
  outputs.enable = !misbehaviour().enableOff;
  broadcast(now, MessageId::DigitalOutputs, outputs.encode());
}

void Monitor6032::heard(Instant now, const J1939Id& id, const Frame& frame) {
  m_inputs.received(now, id, frame);
  if (!isForUs(id) || frame.length == 0) return;
  const auto is = [&](MessageId m) { return hasTypeOf(frame, m); };
  if (is(MessageId::SoePermissive) && frame.length == 3) {
    m_permissive = Permissive::of(frame);
    m_permissiveHeard = now;
  } else if (frame.length == 1) {
    heardRequest(now, id, frame);
  }
}

void Monitor6032::heardRequest(Instant now, const J1939Id& id, const Frame& frame) {
  const auto is = [&](MessageId m) { return hasTypeOf(frame, m); };
  if (is(MessageId::VistaPoll)) {
    answerVista(now, id.source);
  } else if (is(MessageId::ZeroAxesRequest) && hasFeedback()) {
    m_control.zero();
    answer(now, MessageId::ZeroAxesAck, encoded(MessageId::ZeroAxesAck), id.source);
  } else if (is(MessageId::SetupModeRequest)) {
    m_setupMode = true;
    answer(now, MessageId::SetupModeAck, encoded(MessageId::SetupModeAck), id.source);
  } else if (is(MessageId::ResetRequest)) {
    reset(now);
  }
}

std::string Monitor6032::ownStatus() const {
  const auto percent = [&](std::size_t axis) {
    return std::to_string(m_control.axes()[axis].travelled() / 10'000) + "%\r\n";
  };
  char position[48];
  std::snprintf(position, sizeof position, "ROTATION %.1f\r\nELEVATION %.1f\r\n", m_control.rotation() / 10.0,
                m_control.elevation() / 10.0);
  return (hasFeedback() ? position : "NO FEEDBACK\r\n") + ("PATTERN " + percent(2)) + "FLOW " + percent(3) +
         "VALVE " + percent(4) + (misbehaviour().enableOff ? "DISABLED\r\n" : "ENABLED\r\n") +
         (m_setupMode ? "SETUP MODE\r\n" : "");
}

// One 21 and one 22. The manual gives no scales: the voltage and the positions are of the simulator's own, a
// position counting from 0 at the left or low stop to FFFF at the other.
void Monitor6032::answerVista(Instant now, Address to) {
  constexpr int kVolts = 552;
  const Demand demand = m_inputs.demand();
  const auto raw = [](int tenths) { return Value::integer(std::abs(tenths)); };
  const auto on = [&](Function f) { return Value::flag(demand.functions.has(f)); };
  answer(now, MessageId::VistaStatus,
         encoded(MessageId::VistaStatus, {{"system_voltage_raw", Value::integer(kVolts)},
                                          {"digital_output_1", Value::flag(m_control.isDischargeOpen())},
                                          {"digital_output_2", Value::flag(m_control.isHighFlow())},
                                          {"digital_output_3", Value::flag(!m_control.isStowed())},
                                          {"joystick_x_raw", raw(demand.rotation)},
                                          {"joystick_y_raw", raw(demand.elevation)},
                                          {"joystick_x_right", Value::flag(demand.rotation > 0)},
                                          {"joystick_x_left", Value::flag(demand.rotation < 0)},
                                          {"joystick_y_back", Value::flag(demand.elevation > 0)},
                                          {"joystick_y_forward", Value::flag(demand.elevation < 0)},
                                          {"joystick_sw1", on(Function::Stream)},
                                          {"joystick_sw2", on(Function::Fog)},
                                          {"joystick_sw3", on(Function::DischargeOn)},
                                          {"joystick_sw10", on(Function::DischargeOff)}}),
         to);
  const auto scaled = [&](std::size_t axis) {
    return Value::integer(65'535LL * m_control.axes()[axis].travelled() / 1'000'000);
  };
  answer(now, MessageId::VistaPosition,
         encoded(MessageId::VistaPosition, {{"rotation_raw", scaled(0)}, {"elevation_raw", scaled(1)}}), to);
}

namespace {

constexpr int kTenth = 100'000;  // micro-degrees in 0.1 degree
// Point aim: 0.1 % of 175 and of 90 degrees (Appendix B, grip X and Y).
constexpr int kAimRotation = 175'000, kAimElevation = 90'000;
// Speed of what was started, 0.1 % of the full speed.
constexpr int kOscillating = 500, kStowing = 700, kAiming = 1000;
// Where deploying ends, 0.1 degree.
constexpr int kDeployElevation = 150;

// 12 and 8 degrees a second, reached in a quarter of a second.
constexpr Axis::Mechanics kRotation{MonitorControl::kHardLeft * kTenth, MonitorControl::kHardRight* kTenth,
                                    120'000, 4'800};
constexpr Axis::Mechanics kElevation{MonitorControl::kHardDown * kTenth, MonitorControl::kHardUp* kTenth,
                                     80'000, 3'200};
// Fog to stream in 4 s, low to high flow in 3 s, the valve in 5 s; millionths of the travel.
constexpr Axis::Mechanics kPattern{0, 1'000'000, 2'500, 2'500};
constexpr Axis::Mechanics kFlow{0, 1'000'000, 3'334, 3'334};
constexpr Axis::Mechanics kValve{0, 1'000'000, 2'000, 2'000};

int tenths(int microDegrees) {
  return (microDegrees + (microDegrees < 0 ? -kTenth / 2 : kTenth / 2)) / kTenth;
}
SoftLimits limits(int low, int high) {
  return {static_cast<std::int16_t>(low), static_cast<std::int16_t>(high), false};
}

}  // namespace

MonitorControl::MonitorControl(const MonitorSettings& settings)
    : m_settings(settings),
      m_axes{Axis(kRotation, settings.startsStowed ? kStowRotation * kTenth : 0),
             Axis(kElevation, settings.startsStowed ? kStowElevation * kTenth : 0), Axis(kPattern, 500'000),
             Axis(kFlow, 0), Axis(kValve, 0)},
      m_oscillation(settings.oscillationLeft * kTenth, settings.oscillationRight * kTenth) {}

int MonitorControl::rotation() const { return tenths(m_axes[0].position() - m_zeroRotation); }
int MonitorControl::elevation() const { return tenths(m_axes[1].position() - m_zeroElevation); }

SoftLimits MonitorControl::rotationLimits() const {
  SoftLimits result = limits(m_settings.softLeft, m_settings.softRight);
  if (m_oscillation.isOn()) {
    result = limits(tenths(m_oscillation.left()), tenths(m_oscillation.right()));
    result.oscillating = true;
  }
  return result;
}
SoftLimits MonitorControl::elevationLimits() const { return limits(m_settings.softDown, m_settings.softUp); }

bool MonitorControl::isStowed() const {
  return m_axes[0].position() == kStowRotation * kTenth && m_axes[1].position() == kStowElevation * kTenth;
}

void MonitorControl::stop() {
  for (Axis& axis : m_axes) axis.halt();
  m_oscillation.stop();
  m_started = Started::Nothing;
  m_valve = 0;
  m_aiming = false;
}

void MonitorControl::zero() {
  m_zeroRotation = m_axes[0].position();
  m_zeroElevation = m_axes[1].position();
}

void MonitorControl::step(const Demand& demand, const Conditions& conditions) {
  const Functions pressed = demand.functions - m_before;
  m_before = demand.functions;
  if (!conditions.enabled) {
    stop();
    return;
  }
  start(pressed, conditions);
  handMoved(demand);
  if (!conditions.rotationFeedback) m_oscillation.stop();
  if (!conditions.rotationFeedback || !conditions.elevationFeedback) m_started = Started::Nothing;
  limitAxes(conditions);

  m_aiming = (demand.aimRotation && conditions.rotationFeedback) ||
             (demand.aimElevation && conditions.elevationFeedback);
  if (m_started == Started::Nothing) {
    commandRotation(demand, conditions.rotationFeedback);
    commandElevation(demand, conditions.elevationFeedback);
  } else {
    commandStow();
  }
  commandValves(demand.functions);
  for (std::size_t i = 0; i < m_axes.size(); ++i) {
    if (conditions.motorFault[i]) m_axes[i].halt();
    m_axes[i].step();
  }
  if (demand.rotation != 0) m_oscillation.swept(m_axes[0].position() - m_zeroRotation);
}

void MonitorControl::start(const Functions& pressed, const Conditions& conditions) {
  if (pressed.has(Function::OscillateSet) && conditions.rotationFeedback) {
    m_started = Started::Nothing;
    m_oscillation.set(m_settings.softLeft * kTenth, m_settings.softRight * kTenth);
  }
  if (pressed.has(Function::OscillatePause)) m_oscillation.pauseOrResume();
  if (pressed.has(Function::Stow) || pressed.has(Function::Deploy)) {
    m_oscillation.stop();
    m_started = pressed.has(Function::Stow) ? Started::Stow : Started::Deploy;
  }
  if (pressed.has(Function::DischargeOn)) m_valve = 1;
  if (pressed.has(Function::DischargeOff)) m_valve = -1;
}

void MonitorControl::handMoved(const Demand& demand) {
  const bool rotates = demand.rotation != 0 || demand.aimRotation;
  const bool elevates = demand.elevation != 0 || demand.aimElevation;
  if (rotates) m_oscillation.stop();
  if (rotates || elevates) m_started = Started::Nothing;
}

void MonitorControl::limitAxes(const Conditions& conditions) {
  const bool free = m_started != Started::Nothing;
  if (free || !conditions.rotationFeedback) {
    m_axes[0].unlimit();
  } else {
    m_axes[0].limit(m_settings.softLeft * kTenth + m_zeroRotation,
                    m_settings.softRight * kTenth + m_zeroRotation);
  }
  if (free || !conditions.elevationFeedback) {
    m_axes[1].unlimit();
  } else {
    m_axes[1].limit(m_settings.softDown * kTenth + m_zeroElevation,
                    m_settings.softUp * kTenth + m_zeroElevation);
  }
  m_axes[0].permit(conditions.permissive.axis1Plus, conditions.permissive.axis1Minus);
  m_axes[1].permit(conditions.permissive.axis2Plus, conditions.permissive.axis2Minus);
}

void MonitorControl::commandRotation(const Demand& demand, bool feedback) {
  Axis& axis = m_axes[0];
  if (demand.rotation != 0) {
    axis.drive(demand.rotation);
  } else if (demand.aimRotation && feedback) {
    axis.seek(*demand.aimRotation * kAimRotation + m_zeroRotation, kAiming);
  } else if (m_oscillation.isOn() && !m_oscillation.isPaused()) {
    const int target = m_oscillation.target(axis.position() - m_zeroRotation);
    axis.seek(target + m_zeroRotation, kOscillating);
  } else {
    axis.drive(0);
  }
}

void MonitorControl::commandElevation(const Demand& demand, bool feedback) {
  Axis& axis = m_axes[1];
  if (demand.elevation != 0) {
    axis.drive(demand.elevation);
  } else if (demand.aimElevation && feedback) {
    axis.seek(*demand.aimElevation * kAimElevation + m_zeroElevation, kAiming);
  } else {
    axis.drive(0);
  }
}

// Stowing turns ahead before it lowers, deploying raises and then is where it is.
void MonitorControl::commandStow() {
  Axis& rotation = m_axes[0];
  Axis& elevation = m_axes[1];
  const int wanted = (m_started == Started::Stow ? kStowElevation : kDeployElevation) * kTenth;
  rotation.seek(kStowRotation * kTenth, kStowing);
  if (rotation.position() == kStowRotation * kTenth) {
    elevation.seek(wanted, kStowing);
  } else {
    elevation.drive(0);
  }
  if (rotation.position() == kStowRotation * kTenth && elevation.position() == wanted)
    m_started = Started::Nothing;
}

void MonitorControl::commandValves(const Functions& functions) {
  const auto held = [&](Function plus, Function minus) {
    return 1000 * (functions.has(plus) ? 1 : functions.has(minus) ? -1 : 0);
  };
  m_axes[2].drive(held(Function::Stream, Function::Fog));
  m_axes[3].drive(held(Function::FlowHigh, Function::FlowLow));
  if ((m_valve > 0 && m_axes[4].isAtHigh()) || (m_valve < 0 && m_axes[4].isAtLow())) m_valve = 0;
  m_axes[4].drive(1000 * m_valve);
}

}  // namespace deckpipe::simulator
