// SPDX-License-Identifier: GPL-3.0-or-later
// What the first four digits of a PIN say a device is, and what follows from it: what it repeats, what it can be
// asked, what its axes are. One row a type; no other place knows a type by its number.
// Sources: CAN Messaging manual, Appendix A (numbers and names), message types 01, 21, 41, 45, 46, 81-84 (who
// sends and takes them) and Appendix B (axes); gateway manual, TPDO1 (the 6052's position).
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "protocol/lists.h"

namespace deckpipe {

enum class DeviceUse : std::uint8_t {
  Monitor,
  Control,  // sends joystick messages
  Other,
};

enum class AxisUse : std::uint8_t { Unnamed, Rotation, Elevation, Pattern, DependsOnMonitor, DischargeValve };
struct DeviceTypeFacts {
  unsigned number = 0;  // PIN digits 1-4
  std::string_view name{};
  DeviceUse use = DeviceUse::Other;
  EnumSet<MessageId> repeats{};    // always
  EnumSet<MessageId> mayRepeat{};  // only with analog position feedback, which nothing on the bus tells
  EnumSet<Request> takes{};        // besides what every device of Akron's takes
  std::array<AxisUse, 5> axes = {AxisUse::Rotation, AxisUse::Elevation};  // 1 to 5

  // Every status that it sends or may send.
  constexpr EnumSet<MessageId> sends() const {
    EnumSet<MessageId> all = repeats;
    return all |= mayRepeat;
  }
};

// Some 6041 carry 1035 and some 6035 carry 1041.
inline constexpr auto kDeviceTypes = [] {
  using enum MessageId;
  using enum AxisUse;
  constexpr EnumSet kMonitorRepeats(PositionLimitStatus, DigitalOutputs);
  constexpr EnumSet kMonitorTakes(Request::Reset, Request::SetupMode);
  constexpr auto monitor = [=](unsigned number, std::string_view name, std::array<AxisUse, 5> axes) {
    return DeviceTypeFacts{.number = number,
                           .name = name,
                           .use = DeviceUse::Monitor,
                           .repeats = kMonitorRepeats,
                           .takes = kMonitorTakes,
                           .axes = axes};
  };
  return std::array{
      DeviceTypeFacts{.number = 1032,
                      .name = "6032 Universal II",
                      .use = DeviceUse::Monitor,
                      .repeats = kMonitorRepeats,
                      .mayRepeat = EnumSet(RotationSoftLimits, ElevationSoftLimits),
                      .takes = EnumSet(Request::Vista, Request::ZeroAxes, Request::Reset, Request::SetupMode),
                      .axes = {Rotation, Elevation, Pattern, DependsOnMonitor, DischargeValve}},
      DeviceTypeFacts{.number = 1033, .name = "6033 Mini Universal", .repeats = EnumSet(MiniDigitalOutputs)},
      DeviceTypeFacts{.number = 1034, .name = "6034 Operator Station", .use = DeviceUse::Control},
      DeviceTypeFacts{.number = 1035, .name = "6035 Joystick", .use = DeviceUse::Control},
      DeviceTypeFacts{.number = 1036, .name = "6036 Direction Indicator"},
      DeviceTypeFacts{.number = 1037, .name = "6037 Wireless Interface", .use = DeviceUse::Control},
      monitor(1040, "6040 Forestry", {Rotation, Elevation, Pattern, DischargeValve}),
      DeviceTypeFacts{.number = 1041, .name = "6041 Switchbox", .use = DeviceUse::Control},
      monitor(1042, "6042 Global Platform", {Rotation, Elevation, Pattern}),
      DeviceTypeFacts{.number = 1051, .name = "6051 CAN Gateway"},
      monitor(1052, "6052 StreamMaster II", {Rotation, Elevation, Pattern}),
  };
}();

// Null where the manual names no such type.
constexpr const DeviceTypeFacts* deviceTypeOf(unsigned number) {
  const auto found = std::ranges::find(kDeviceTypes, number, &DeviceTypeFacts::number);
  return found == kDeviceTypes.end() ? nullptr : &*found;
}
// Empty where the manual names no such type.
constexpr std::string_view deviceTypeName(unsigned number) {
  const DeviceTypeFacts* type = deviceTypeOf(number);
  return type == nullptr ? std::string_view() : type->name;
}
constexpr bool isOfUse(unsigned number, DeviceUse use) {
  const DeviceTypeFacts* type = deviceTypeOf(number);
  return type != nullptr && type->use == use;
}

// What every device of Akron's takes, of whatever type.
inline constexpr EnumSet kTakenByAll(Request::Fault, Request::Firmware, Request::Pcode, Request::Config);

// What a device repeats that sent `heard` of what devices repeat: of those types that may send all of it, what
// all of them repeat. Nothing where no type does, as of the 6039 CAN I/O module, which has no number.
constexpr EnumSet<MessageId> repeatedBySenderOf(const EnumSet<MessageId>& heard) {
  EnumSet<MessageId> common;
  bool isFirst = true;
  for (const DeviceTypeFacts& type : kDeviceTypes) {
    if (!(heard - type.sends()).isEmpty()) continue;
    common = isFirst ? type.repeats : common & type.repeats;
    isFirst = false;
  }
  return common;
}

// The type that alone sends a status; 0 where several do, or none.
constexpr unsigned soleSenderOf(MessageId id) {
  unsigned number = 0;
  for (const DeviceTypeFacts& type : kDeviceTypes) {
    if (!type.sends().has(id)) continue;
    if (number != 0) return 0;
    number = type.number;
  }
  return number;
}

// PIN digits 1-4 of what has that part; 0 where the manuals do not name it.
constexpr unsigned deviceTypeOfPart(std::uint32_t part) {
  return nameOf(akron::kParts, part).empty() ? 0u : 1032u;
}

namespace checks {

constexpr bool typesRepeatWhatTheCatalogueCallsPeriodic() {
  for (const MessageId id : kAllOf<MessageId>) {
    const bool isSent = std::ranges::any_of(kDeviceTypes, [id](const auto& t) { return t.sends().has(id); });
    const bool isRepeated = isOwnPeriodicReport(messageOf(id)) && messageOf(id).family == Family::Akron &&
                            id != MessageId::DigitalInputs;  // the 6039's
    if (isSent != isRepeated) return false;
  }
  return true;
}
constexpr bool isTakenByAllOrBySome(Request request) {
  const bool isOfSome =
      std::ranges::any_of(kDeviceTypes, [request](const auto& t) { return t.takes.has(request); });
  return kTakenByAll.has(request) != isOfSome;
}
static_assert(std::ranges::all_of(kAllOf<Request>, isTakenByAllOrBySome),
              "a request is taken by every device, or by those types that name it");
static_assert(typesRepeatWhatTheCatalogueCallsPeriodic());
static_assert(std::ranges::is_sorted(kDeviceTypes, {}, &DeviceTypeFacts::number));

}  // namespace checks
}  // namespace deckpipe
