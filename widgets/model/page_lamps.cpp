// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_lamps.h"

#include <QCoreApplication>

#include "text/axis_text.h"
#include "text/device_text.h"
#include "text/joystick_text.h"

namespace deckpipe {
namespace {

struct Lamps {
  Q_DECLARE_TR_FUNCTIONS(Lamps)
};

std::optional<Duration> ageAt(Instant at, Instant now) {
  if (at == kNotYet) return {};
  return now - at;
}

// A group from one message whose flags are plain bits.
class FlagGroup {
 public:
  FlagGroup(const QString& key, const QString& title, Instant at, bool isStale, Instant now) {
    m_group.key = key;
    m_group.title = title;
    m_group.age = ageAt(at, now);
    m_group.isStale = isStale;
    m_isKnown = at != kNotYet;
  }
  FlagGroup& add(const QString& label, bool isOn, LampTone whenOn = LampTone::Plain,
                 const QString& spoken = {}) {
    std::optional<Status2> state;
    if (m_isKnown) state = isOn ? Status2::On : Status2::Off;
    m_group.lamps.push_back({label, spoken, state, whenOn});
    return *this;
  }
  FlagGroup& remark(const QString& text) {
    m_group.remark = text;
    return *this;
  }
  PageLampGroup group() const { return m_group; }

 private:
  PageLampGroup m_group;
  bool m_isKnown = false;
};

PageLampGroup statusOf(const Device& d, Instant now) {
  PageLampGroup group;
  group.key = QStringLiteral("status");
  group.title = Lamps::tr("Status");
  group.age = ageAt(d.position.at, now);
  group.isStale = d.isStale(Periodic::Position);
  std::optional<Status2> error, calibrated;
  if (d.position.isKnown()) {
    error = d.position.value().operationalError;
    calibrated = d.position.value().calibrated;
  }
  group.lamps = {{Lamps::tr("Operational error"), {}, error, LampTone::Stop},
                 {Lamps::tr("Calibrated"), {}, calibrated, LampTone::Fine}};
  return group;
}

PageLampGroup outputsOf(const Device& d, Instant now) {
  const DigitalOutputs o = d.outputs.value();
  FlagGroup group(QStringLiteral("outputs"), Lamps::tr("Outputs"), d.outputs.at, d.isStale(Periodic::Outputs),
                  now);
  group.add(Lamps::tr("Enabled"), o.enable, LampTone::Fine, Lamps::tr("Enabled: motion allowed"))
      .add(Lamps::tr("Active (not stowed)"), o.active)
      .add(Lamps::tr("Stowed"), o.stowed)
      .add(Lamps::tr("Permissive required"), o.soeMode, LampTone::Attend,
           Lamps::tr("SOE mode: a permissive is required to move"))
      .add(Lamps::tr("Point-aim mode"), o.pointAimMode)
      .add(Lamps::tr("Remote mode"), o.remoteMode)
      .add(Lamps::tr("Outside exclusion zone"), o.outsideExclusionZone)
      .add(Lamps::tr("Discharge valve"), o.dischargeValve)
      .add(Lamps::tr("High flow"), o.highFlow)
      .add(Lamps::tr("Aux agent"), o.auxAgent, LampTone::Plain,
           Lamps::tr("Aux agent dispense; the gateway manual calls it dry chemical"))
      .add(Lamps::tr("Panel LED"), o.panelLed)
      .add(Lamps::tr("Point-aim LED"), o.pointAimLed)
      .add(Lamps::tr("Wireless LED"), o.wirelessLed, LampTone::Plain, Lamps::tr("Wireless hand-held LED"));
  // What its numbers mean is nowhere given.
  if (d.outputs.isKnown()) group.remark(Lamps::tr("electric riser command %1").arg(o.riserCommand));
  return group.group();
}

PageLampGroup riserOf(const Device& d, Instant now) {
  const MiniOutputs o = d.miniOutputs.value();
  return FlagGroup(QStringLiteral("riser"), Lamps::tr("Riser"), d.miniOutputs.at,
                   d.isStale(Periodic::MiniOutputs), now)
      .add(Lamps::tr("Riser extended"), o.riserExtended)
      .add(Lamps::tr("Riser retracted"), o.riserRetracted)
      .add(Lamps::tr("Device active"), o.deviceActive, LampTone::Fine)
      .add(Lamps::tr("Device faulted"), o.deviceFaulted, LampTone::Stop)
      .group();
}

PageLampGroup inputsOf(const Device& d, Instant now) {
  const DigitalInputs i = d.inputs.value();
  return FlagGroup(QStringLiteral("inputs"), Lamps::tr("Inputs"), d.inputs.at, d.isStale(Periodic::Inputs),
                   now)
      .add(Lamps::tr("Allowed in collision zone"), i.allowedInCollisionZone)
      .add(Lamps::tr("Deploy"), i.deploy)
      .add(Lamps::tr("Stow"), i.stow)
      .group();
}

PageLampGroup permissiveOf(const Device& d, Instant now) {
  const Permissive p = d.permissive.value();
  FlagGroup group(QStringLiteral("permissive"), Lamps::tr("Permissive"), d.permissive.at,
                  d.isStale(Periodic::Permissive), now);
  group.add(Lamps::tr("Left"), p.axis1Minus, LampTone::Fine, Lamps::tr("May rotate left"))
      .add(Lamps::tr("Right"), p.axis1Plus, LampTone::Fine, Lamps::tr("May rotate right"))
      .add(Lamps::tr("Down"), p.axis2Minus, LampTone::Fine, Lamps::tr("May elevate down"))
      .add(Lamps::tr("Up"), p.axis2Plus, LampTone::Fine, Lamps::tr("May elevate up"));
  if (!d.permissive.isKnown()) return group.remark(Lamps::tr("required, none heard")).group();
  const QString sender = addressText(d.permissiveFrom);
  return group
      .remark(d.isStale(Periodic::Permissive) ? Lamps::tr("timed out, last from %1").arg(sender)
                                              : Lamps::tr("from %1").arg(sender))
      .group();
}

}  // namespace

PageStops stopsOf(const Device& d, Instant now) {
  PageStops stops;
  if (!isMonitor(d)) return stops;
  stops.age = ageAt(d.position.at, now);
  stops.isStale = d.isStale(Periodic::Position);
  const std::optional<unsigned> type = typeOf(d).pinDigits();
  for (int axis = 1; axis <= kAxes; ++axis) {
    const AxisText text = axisText(type, axis);
    const auto lamp = [&](const QString& side, const std::array<Status2, 5>& states) {
      std::optional<Status2> state;
      if (d.position.isKnown()) state = states[static_cast<std::size_t>(axis - 1)];
      return PageLamp{side, Lamps::tr("%1, %2 stop").arg(text.name, side), state, LampTone::Stop};
    };
    stops.axes.push_back({text.name, text.remark, lamp(text.minus, d.position.value().minusStop),
                          lamp(text.plus, d.position.value().plusStop)});
  }
  return stops;
}

std::vector<PageLampGroup> lampsOf(const Device& d, Instant now) {
  std::vector<PageLampGroup> groups;
  const bool monitor = isMonitor(d);
  if (monitor) groups.push_back(statusOf(d, now));
  if (monitor) groups.push_back(outputsOf(d, now));
  if (d.miniOutputs.isKnown() || typeOf(d).pinDigits() == 1033u) groups.push_back(riserOf(d, now));
  if (d.inputs.isKnown()) groups.push_back(inputsOf(d, now));
  const bool isRequired = d.outputs.isKnown() && d.outputs.value().soeMode;
  if (d.permissive.isKnown() || isRequired) groups.push_back(permissiveOf(d, now));
  return groups;
}

std::vector<PageLampGroup> switchesOf(const Joystick& stick, Instant now) {
  std::vector<PageLampGroup> groups;
  const BasicJoystick basic = stick.basic.value();
  const ExtendedJoystick extended = stick.extended.value();
  PageLampGroup switches{QStringLiteral("switches"), Lamps::tr("Switches"), {},
                         ageAt(stick.basic.at, now), stick.timedOut,        {}};
  const auto known = [](bool isKnown, Status2 status) {
    return isKnown ? std::optional(status) : std::nullopt;
  };
  const auto addSwitch = [&](PageLampGroup& group, std::size_t i, std::optional<Status2> state) {
    const int number = static_cast<int>(i) + 1;
    group.lamps.push_back(
        {Lamps::tr("%1 %2", "number and name of a switch").arg(QString::number(number), switchName(number)),
         Lamps::tr("Switch %1: %2").arg(QString::number(number), switchName(number)), state,
         LampTone::Plain});
  };
  for (std::size_t i = 0; i < basic.switches.size(); ++i)
    addSwitch(switches, i, known(stick.basic.isKnown(), basic.switches[i]));
  groups.push_back(switches);

  PageLampGroup detents{
      QStringLiteral("detents"), Lamps::tr("Detents"), {}, switches.age, switches.isStale, {}};
  detents.lamps = {{Lamps::tr("X detent"), {}, known(stick.basic.isKnown(), basic.x.detent)},
                   {Lamps::tr("Y detent"), {}, known(stick.basic.isKnown(), basic.y.detent)}};
  groups.push_back(detents);
  if (!stick.extended.isKnown()) return groups;

  const bool isOld = stick.timedOut || now - stick.extended.at >= kInputTimeout;
  PageLampGroup grip{QStringLiteral("grip"),
                     Lamps::tr("Grip detents and switches"),
                     {},
                     ageAt(stick.extended.at, now),
                     isOld,
                     {}};
  grip.lamps = {{Lamps::tr("Grip X detent"), {}, extended.gripX.detent},
                {Lamps::tr("Grip Y detent"), {}, extended.gripY.detent},
                {Lamps::tr("Grip theta detent"), {}, extended.gripTheta.detent}};
  for (std::size_t i = 0; i < extended.switches.size(); ++i)
    grip.lamps.push_back({switchName(static_cast<int>(i) + 13), {}, extended.switches[i]});
  groups.push_back(grip);
  return groups;
}

}  // namespace deckpipe
