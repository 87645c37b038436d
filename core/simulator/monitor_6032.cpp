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

}  // namespace deckpipe::simulator
