// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/page_parts.h"

#include <QCoreApplication>
#include <utility>

#include "model/page_sources.h"
#include "protocol/device_types.h"
#include "state/current.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

struct Lamps {
  Q_DECLARE_TR_FUNCTIONS(Lamps)
};

// A group from one message whose flags are plain bits.
class FlagGroup {
 public:
  FlagGroup(PageGroup group, const QString& title, const State& state, const Device& d, MessageId message) {
    m_group.key = pageGroupKey(group);
    m_group.title = title;
    m_group.age = ageOf(state, d.channel, d.report(message).at);
    m_group.isStale = isStale(state, d, message);
    m_isKnown = d.report(message).isKnown();
  }
  FlagGroup& add(const QString& label, bool isOn, Severity whenOn = Severity::Plain,
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

std::optional<PageLampGroup> statusOf(const State& state, const Device& d) {
  if (!isMonitor(d)) return {};
  PageLampGroup group;
  group.key = pageGroupKey(PageGroup::Status);
  group.title = Lamps::tr("Status");
  group.age = ageOf(state, d.channel, d.position().at);
  group.isStale = isStale(state, d, MessageId::PositionLimitStatus);
  std::optional<Status2> error, calibrated;
  if (d.position().isKnown()) {
    error = d.position().value().operationalError;
    calibrated = d.position().value().calibrated;
  }
  group.lamps = {{Lamps::tr("Operational error"), {}, error, Severity::Fault},
                 {Lamps::tr("Calibrated"), {}, calibrated, Severity::Fine}};
  return group;
}

std::optional<PageLampGroup> outputsOf(const State& state, const Device& d) {
  if (!isMonitor(d)) return {};
  const DigitalOutputs o = d.outputs().value();
  FlagGroup group(PageGroup::Outputs, Lamps::tr("Outputs"), state, d, MessageId::DigitalOutputs);
  group.add(Lamps::tr("Enabled"), o.enable, Severity::Fine, Lamps::tr("Enabled: motion allowed"))
      .add(Lamps::tr("Active (not stowed)"), o.active)
      .add(Lamps::tr("Stowed"), o.stowed)
      .add(Lamps::tr("Permissive required"), o.soeMode, Severity::Warning,
           Lamps::tr("SOE mode: a permissive is required to move"))
      .add(Lamps::tr("Point-aim mode"), o.pointAimMode)
      .add(Lamps::tr("Remote mode"), o.remoteMode)
      .add(Lamps::tr("Outside exclusion zone"), o.outsideExclusionZone)
      .add(Lamps::tr("Discharge valve"), o.dischargeValve)
      .add(Lamps::tr("High flow"), o.highFlow)
      .add(Lamps::tr("Aux agent"), o.auxAgent, Severity::Plain,
           Lamps::tr("Aux agent dispense; the gateway manual calls it dry chemical"))
      .add(Lamps::tr("Panel LED"), o.panelLed)
      .add(Lamps::tr("Point-aim LED"), o.pointAimLed)
      .add(Lamps::tr("Wireless LED"), o.wirelessLed, Severity::Plain, Lamps::tr("Wireless hand-held LED"));
  // What its numbers mean is nowhere given.
  if (d.outputs().isKnown()) group.remark(Lamps::tr("electric riser command %1").arg(o.riserCommand));
  return group.group();
}

std::optional<PageLampGroup> riserOf(const State& state, const Device& d) {
  const bool sendsThem = typeOf(d).pinDigits() == soleSenderOf(MessageId::MiniDigitalOutputs);
  if (!d.miniOutputs().isKnown() && !sendsThem) return {};
  const MiniOutputs o = d.miniOutputs().value();
  return FlagGroup(PageGroup::Riser, Lamps::tr("Riser"), state, d, MessageId::MiniDigitalOutputs)
      .add(Lamps::tr("Riser extended"), o.riserExtended)
      .add(Lamps::tr("Riser retracted"), o.riserRetracted)
      .add(Lamps::tr("Device active"), o.deviceActive, Severity::Fine)
      .add(Lamps::tr("Device faulted"), o.deviceFaulted, Severity::Fault)
      .group();
}

std::optional<PageLampGroup> inputsOf(const State& state, const Device& d) {
  if (!d.inputs().isKnown()) return {};
  const DigitalInputs i = d.inputs().value();
  return FlagGroup(PageGroup::Inputs, Lamps::tr("Inputs"), state, d, MessageId::DigitalInputs)
      .add(Lamps::tr("Allowed in collision zone"), i.allowedInCollisionZone)
      .add(Lamps::tr("Deploy"), i.deploy)
      .add(Lamps::tr("Stow"), i.stow)
      .group();
}

std::optional<PageLampGroup> permissiveOf(const State& state, const Device& d) {
  const bool isRequired = d.outputs().isKnown() && d.outputs().value().soeMode;
  if (!d.permissive().isKnown() && !isRequired) return {};
  const Permissive p = d.permissive().value();
  FlagGroup group(PageGroup::Permissive, Lamps::tr("Permissive"), state, d, MessageId::SoePermissive);
  group.add(Lamps::tr("Left"), p.axis1Minus, Severity::Fine, Lamps::tr("May rotate left"))
      .add(Lamps::tr("Right"), p.axis1Plus, Severity::Fine, Lamps::tr("May rotate right"))
      .add(Lamps::tr("Down"), p.axis2Minus, Severity::Fine, Lamps::tr("May elevate down"))
      .add(Lamps::tr("Up"), p.axis2Plus, Severity::Fine, Lamps::tr("May elevate up"));
  if (!d.permissive().isKnown()) return group.remark(Lamps::tr("required, none heard")).group();
  const QString sender = addressText(d.permissiveFrom);
  const bool isStale = d.isStale(MessageId::SoePermissive);
  const QString remark = !isStale ? Lamps::tr("from %1")
                         : state.isFiltered()
                             ? Lamps::tr("last from %1 in this log, which was saved through a filter")
                             : Lamps::tr("timed out, last from %1");
  return group.remark(remark.arg(sender)).group();
}

// Draws a group of a device's lamps; nothing where the device has no such group.
using Drawing = std::optional<PageLampGroup> (*)(const State&, const Device&);
constexpr EnumTable<PageGroup, Drawing> kDrawings{{
    {PageGroup::Health, nullptr},  // DevicePageValues::reasons
    {PageGroup::Dial, nullptr},    // dialOf()
    {PageGroup::Stops, nullptr},   // stopsOf()
    {PageGroup::Status, statusOf},
    {PageGroup::Outputs, outputsOf},
    {PageGroup::Riser, riserOf},
    {PageGroup::Inputs, inputsOf},
    {PageGroup::Permissive, permissiveOf},
    {PageGroup::Switches, nullptr},  // switchesOf(), as are the next two
    {PageGroup::Detents, nullptr},
    {PageGroup::Grip, nullptr},
    {PageGroup::Joystick, nullptr},  // page_facts.cpp, as are the rest
    {PageGroup::Faults, nullptr},
    {PageGroup::Versions, nullptr},
    {PageGroup::Node, nullptr},
    {PageGroup::Address, nullptr},
}};

}  // namespace

PageStops stopsOf(const State& state, const Device& d) {
  PageStops stops;
  if (!isMonitor(d)) return stops;
  stops.age = ageOf(state, d.channel, d.position().at);
  stops.isStale = isStale(state, d, MessageId::PositionLimitStatus);
  const std::optional<unsigned> type = typeOf(d).pinDigits();
  for (int axis = 1; axis <= kAxes; ++axis) {
    const AxisText text = axisText(type, axis);
    const auto lamp = [&](const QString& side, const std::array<Status2, 5>& states) {
      std::optional<Status2> stop;
      if (d.position().isKnown()) stop = states[static_cast<std::size_t>(axis - 1)];
      return PageLamp{side, Lamps::tr("%1, %2 stop").arg(text.name, side), stop, Severity::Plain,
                      Glyph::Stop};
    };
    stops.axes.push_back({text.name, text.remark, lamp(text.minus, d.position().value().minusStop),
                          lamp(text.plus, d.position().value().plusStop)});
  }
  return stops;
}

std::vector<PageLampGroup> lampsOf(const State& state, const Device& d) {
  std::vector<PageLampGroup> groups;
  for (const auto draw : kDrawings) {
    if (draw == nullptr) continue;
    if (auto group = draw(state, d)) groups.push_back(std::move(*group));
  }
  return groups;
}

std::vector<PageLampGroup> switchesOf(const State& state, Channel channel, const Joystick& stick) {
  std::vector<PageLampGroup> groups;
  const BasicJoystick basic = stick.basic.value();
  const ExtendedJoystick extended = stick.extended.value();
  PageLampGroup switches{pageGroupKey(PageGroup::Switches),     Lamps::tr("Switches"),          {},
                         ageOf(state, channel, stick.basic.at), isStale(state, channel, stick), {}};
  const auto known = [](bool isKnown, Status2 status) {
    return isKnown ? std::optional(status) : std::nullopt;
  };
  const auto addSwitch = [&](PageLampGroup& group, std::size_t i, std::optional<Status2> position) {
    const int number = static_cast<int>(i) + 1;
    group.lamps.push_back(
        {Lamps::tr("%1 %2", "number and name of a switch").arg(QString::number(number), switchName(number)),
         Lamps::tr("Switch %1: %2").arg(QString::number(number), switchName(number)), position,
         Severity::Plain});
  };
  for (std::size_t i = 0; i < basic.switches.size(); ++i)
    addSwitch(switches, i, known(stick.basic.isKnown(), basic.switches[i]));
  groups.push_back(switches);

  PageLampGroup detents{
      pageGroupKey(PageGroup::Detents), Lamps::tr("Detents"), {}, switches.age, switches.isStale, {}};
  detents.lamps = {{Lamps::tr("X detent"), {}, known(stick.basic.isKnown(), basic.x.detent)},
                   {Lamps::tr("Y detent"), {}, known(stick.basic.isKnown(), basic.y.detent)}};
  groups.push_back(detents);
  if (!stick.extended.isKnown()) return groups;

  PageLampGroup grip{pageGroupKey(PageGroup::Grip),
                     Lamps::tr("Grip detents and switches"),
                     {},
                     ageOf(state, channel, stick.extended.at),
                     isExtendedStale(state, channel, stick),
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
