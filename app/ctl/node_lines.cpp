// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_lines.h"

#include <cstdio>
#include <optional>

#include "bus_follower.h"
#include "counts.h"
#include "json_line.h"
#include "protocol/decode.h"
#include "protocol/device_types.h"
#include "protocol/j1939.h"
#include "state/device_type.h"

namespace deckpipe::ctl {
namespace {

struct Row {
  Address address = kNullAddress;
  NodeId node{};  // 0: none
  std::optional<NodeCount>
      heard{};  // from who holds the address; nothing: not on J1939, or without an address
  ClaimState claim = ClaimState::NoClaim;
  std::uint64_t name = 0;
  std::uint64_t formerName = 0;  // of before the link was down, if nobody has said since who is there
  Pin formerPin{};
  const Device* device = nullptr;  // null: nothing known but the address
  const char* what = "unknown";
  bool sendsJoystick = false;

  std::uint32_t frames() const { return heard ? heard->frames : device->frames; }
  std::uint32_t malformed() const { return device != nullptr ? device->malformed : heard->malformed; }
  Instant lastHeard() const { return heard ? heard->lastHeard : device->lastHeard; }
  Health health{};

  Pin pin() const { return device != nullptr ? device->pin : Pin(); }
};

const char* claimWord(ClaimState claim) {
  switch (claim) {
    case ClaimState::NoClaim: return "no_claim";
    case ClaimState::Claiming: return "claiming";
    case ClaimState::Claimed: return "claimed";
    case ClaimState::Contested: return "contested";
    case ClaimState::CannotClaim: return "cannot_claim";
  }
  return "no_claim";
}

const char* whatIsAt(const ChannelState& bus, Address address, bool sendsJoystick, bool speaksAkron) {
  if (bus.ownAddress == address) return "own";
  if (bus.book.isDrive(address)) return "drive";
  if (bus.book.isAkron(address)) return "akron";
  if (sendsJoystick) return "joystick";
  if (bus.book.isForeign(address)) return "foreign";
  if (speaksAkron) return "presumed";
  return "unknown";
}

std::vector<Row> rowsOf(const State& state, const NodeCounts& counts, Channel channel) {
  std::vector<Row> rows;
  const ChannelState& bus = state.channel(channel);
  for (unsigned a = 0; a < kNullAddress.value; ++a) {
    const Address address{static_cast<std::uint8_t>(a)};
    if (!bus.book.isHeard(address)) continue;
    Row row{.address = address,
            .heard = counts.at(address, bus.book.lastHolder(address)),
            .claim = bus.book.claim(address, state.cursor().time),
            .name = bus.book.lastHolder(address).value,
            .formerName = bus.book.formerHolder(address).value,
            .formerPin = bus.book.formerPin(address),
            .device = state.devices().byAddress(channel, address)};
    row.sendsJoystick = bus.joysticks.find(address) != nullptr;
    row.what = whatIsAt(bus, address, row.sendsJoystick, row.device != nullptr);
    row.health = row.device != nullptr ? healthOf(state, *row.device) : healthOf(state, channel, address);
    rows.push_back(row);
  }
  for (const Device& device : state.devices().all()) {
    if (device.kind == Device::Kind::Free || device.channel != channel) continue;
    if (device.kind == Device::Kind::Node) {
      rows.push_back({.node = device.node,
                      .device = &device,
                      .what = "canopen_node",
                      .health = healthOf(state, device)});
    } else if (device.address == kNullAddress) {
      rows.push_back({.device = &device, .what = "akron", .health = healthOf(state, device)});
    }
  }
  return rows;
}

std::string healthWords(const Health& health) {
  if (health.isFine()) return std::string(health.key());
  std::string words;
  for (const std::string_view key : causesOf(health)) words.append(words.empty() ? "" : ", ").append(key);
  return words;
}

std::string jsonLine(const Row& row, std::string_view channelName) {
  JsonLine line;
  line.add("channel", channelName);
  row.node.value != 0 ? line.add("node", row.node.value) : line.add("address", row.address);
  line.add("what", row.what);
  if (row.sendsJoystick) line.add("sends_joystick", true);
  line.add("pin", row.pin()).addTypeOf(row.pin());
  if (!row.formerPin.isNull()) line.add("former_pin", row.formerPin);
  if (row.formerName != 0) line.addHex("former_name", row.formerName, 16);
  if (row.heard) line.add("claim", claimWord(row.claim));
  if (row.name != 0) {
    line.addHex("name", row.name, 16);
    Frame frame;
    frame.data = std::bit_cast<Payload>(row.name);
    frame.length = 8;
    for (const Field& field : j1939::kNameFields) {
      if (!field.key.empty()) line.add(field.key, valueOf(field, frame));
    }
  }
  if (row.device != nullptr && row.device->part() != 0) line.add("part_number", row.device->part());
  line.add("frames", row.frames()).add("malformed", row.malformed());
  line.addTime("last_heard", wallTime(row.lastHeard())).add("health", row.health.key());
  line.add("causes", causesOf(row.health));
  return line.text();
}

std::string textLine(const Row& row, Instant now) {
  char text[200];
  const Pin pin = row.pin();
  const std::string_view type = row.device != nullptr ? typeName(*row.device) : std::string_view();
  char place[16] = "--";
  if (row.node.value != 0) {
    std::snprintf(place, sizeof place, "node %02X", static_cast<unsigned>(row.node.value));
  } else if (row.address != kNullAddress) {
    std::snprintf(place, sizeof place, "%02X", static_cast<unsigned>(row.address.value));
  }
  char name[20] = "";
  if (row.name != 0) std::snprintf(name, sizeof name, "%016llX", static_cast<unsigned long long>(row.name));
  std::snprintf(text, sizeof text, "%-7s  %-12s  %-15s  %-23s  %-16s %8u %s, last %s ago, ", place, row.what,
                std::string(pin.text()).c_str(), std::string(type).c_str(), name, row.frames(),
                row.frames() == 1 ? "frame" : "frames", lengthText(now - row.lastHeard()).c_str());
  std::string was;
  if (!row.formerPin.isNull())
    was.append(", was ").append(row.formerPin.text()).append(" before the link went down");
  return text + healthWords(row.health) + was + '\n';
}

}  // namespace

std::string nodeLines(const State& state, const NodeCounts& counts, Channel channel,
                      std::string_view channelName, NodeFormat format) {
  std::string out;
  for (const Row& row : rowsOf(state, counts, channel)) {
    out += format == NodeFormat::Text ? textLine(row, state.cursor().time) : jsonLine(row, channelName);
  }
  return out;
}

std::string_view typeName(const Device& device) {
  using From = DeviceType::From;
  const DeviceType type = typeOf(device);
  if (const auto digits = type.pinDigits()) return deviceTypeName(*digits);
  switch (type.from) {
    case From::Messages83:
    case From::MonitorNode: return "monitor";
    case From::Messages85: return "6039 CAN I/O module";
    case From::GatewayNode: return "6051 CAN Gateway";
    default: return {};
  }
}

std::vector<std::string_view> causesOf(const Health& health) {
  std::vector<std::string_view> keys;
  health.causes.forEach([&](HealthCause cause) { keys.push_back(kHealthCauses[cause].key); });
  return keys;
}

std::vector<std::string> untrackedLines(const State& state) {
  std::vector<std::string> lines;
  if (const std::uint64_t frames = state.untrackedFrames(); frames != 0) {
    lines.push_back(framesText(frames) + " on channels beyond the first " + std::to_string(kMaxChannels) +
                    ", which are not followed");
  }
  if (const std::uint64_t frames = state.devices().untracked(); frames != 0) {
    lines.push_back(framesText(frames) + " of devices beyond the first " + std::to_string(kMaxDevices) +
                    ", which are not followed");
  }
  return lines;
}

}  // namespace deckpipe::ctl
