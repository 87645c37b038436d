// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/monitor_control.h"

namespace deckpipe::simulator {
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
