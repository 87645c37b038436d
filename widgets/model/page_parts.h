// SPDX-License-Identifier: GPL-3.0-or-later
// The parts that device_page_of.cpp puts a device's page together from. Each is a pure function of the state at its
// cursor.
#pragma once

#include "model/device_page_values.h"

namespace deckpipe {

// Who moves a monitor's axes now. Source: CAN Messaging manual, Appendix B: of the joystick sources 33..38
// hex the lowest number wins, axis by axis, and only while it deflects that axis; a gateway's node has one
// command, RPDO1, whose sender is not known. A controller forgets an input after 200 ms.
struct PageCommands {
  std::optional<DialAxis::Command> rotation, elevation;
};
// What one joystick asks for, whoever comes before it.
PageCommands commandsOf(const Joystick& stick);
// What the joysticks of a channel command together.
PageCommands joystickCommands(const State& state, Channel channel);
// "right at 50 %", for the rotation; up and down for the elevation.
QString commandText(const DialAxis::Command& command, bool isRotation);
PageCommands commandsTo(const State& state, const Device& monitor);

// What the dial of a monitor shows at the state's cursor: on its own page, on its tile of the overview.
DialValues dialOf(const State& state, const Device& monitor);

// Of a monitor that somebody commands: the joystick source that comes first among those that ask for something now; while none does, first among those
// that are heard. Nothing for a gateway's node, whose joysticks are on another bus.
std::optional<PageStick> leadingStick(const State& state, const Device& monitor);

// Sentences that say what in the log speaks against its moving as commanded: the axis stands at a hard stop or within 1.0° of its soft limit on the commanded side; another joystick
// asks for an axis and comes later in rank. `dial` is the monitor's own.
std::vector<PageReason> motionReasons(const State& state, const Device& monitor, const DialValues& dial);

// "45.0 % right", "neutral", "error", "not fitted"; `plus` and `minus` name the directions.
QString deflectionText(const StickAxis& axis, const QString& plus, const QString& minus);
// A joystick's stick as a page shows it.
PageStick stickOf(const State& state, Channel channel, const Joystick& stick);
// Of its extended message.
PageStick gripOf(const State& state, Channel channel, const Joystick& stick);

// Where a joystick source stands among those that are heard on its channel, and what it moves. Source: CAN
// Messaging manual, Appendix B: 33 hex comes first, 38 hex last, all after a 6032's own switches; a source
// overrides the others only where it asks for something.
PageFactGroup arbitrationOf(const State& state, Channel channel, const Joystick& stick,
                            const DeviceLabels& labels);
// For a control that is known by its PIN alone: which sources are heard on its channel, one of which may be
// its own.
PageFactGroup sourcesOf(const State& state, Channel channel);

// The hard stops by axis.
PageStops stopsOf(const State& state, const Device& device);
// Outputs of each kind of device, inputs, the permissive.
std::vector<PageLampGroup> lampsOf(const State& state, const Device& device);
// The switches that a joystick message carries.
std::vector<PageLampGroup> switchesOf(const State& state, Channel channel, const Joystick& stick);

// Faults and versions as answered, with their ages. Answers are drawn as old if the device restarted or fell silent after them, or the link went down.
PageFactGroup faultsOf(const State& state, const Device& device);
PageFactGroup versionsOf(const State& state, const Device& device);
// NMT state of a CANopen node.
PageFactGroup nodeOf(const State& state, const Device& device);
// What its timing is.
PageFactGroup joystickOf(const State& state, Channel channel, const Joystick& stick);
// Address, claim, contests and the NAME's parts of whatever has a J1939 address or lost it. `device` null: a
// node that is no Akron device.
PageFactGroup addressOf(const State& state, Channel channel, Address address, const Device* device);

}  // namespace deckpipe
