// SPDX-License-Identifier: GPL-3.0-or-later
#include "info_report.h"

#include <cstdio>
#include <utility>

#include "counts.h"
#include "node_lines.h"
#include "output.h"
#include "protocol/device_types.h"
#include "report/json.h"
#include "report/trace_text.h"
#include "state/advance.h"
#include "state/current.h"
#include "state/health.h"

namespace deckpipe::ctl {
namespace {

std::string versionText(std::uint16_t version) {
  return std::to_string(version >> 8) + "." + std::to_string(version & 0xFF);
}

std::string hex(unsigned value, unsigned digits) {
  std::string text;
  appendHex(text, value, digits);
  return text;
}

// Why an answer may not hold any more; empty if it does.
std::string_view ageWord(AnswerAge age) {
  switch (age) {
    case AnswerAge::Current: break;
    case AnswerAge::BeforeRestart: return "restarted since";
    case AnswerAge::BeforeSilence: return "silent since";
    case AnswerAge::BeforeLinkDown: return "link down since";
  }
  return {};
}

// The device's last answer about faults, how long ago it came, and why it is old: "no faults, asked 93 s ago, silent since".
std::string faultsText(const State& state, const Device& device, bool hasTimes) {
  if (!device.faults().isKnown()) return {};
  const FaultStatus faults = device.faults().value();
  std::string out;
  for (const ValueName& bit : akron::kFaultBits) {
    if ((faults.map >> bit.value & 1u) != 0) out.append(out.empty() ? "" : " + ").append(bit.word);
  }
  if (out.empty()) out = faults.map == 0 ? "no faults" : "fault bits " + hex(faults.map, 8);
  if (faults.pcodeError.value_or(0) != 0) out += ", pCode error " + std::to_string(*faults.pcodeError);
  if (hasTimes) {
    out += ", asked " + lengthText(state.cursor().time - device.faults().at) + " ago";
  }
  const std::string_view why = ageWord(ageOfAnswer(state, device, device.faults().at));
  if (!why.empty()) out.append(", ").append(why);
  return out;
}

void appendAngle(std::string& out, const PositionReading& reading) {
  appendJsonValue(out, reading.state == PositionState::Ok ? Value::decimal(reading.tenths, 1) : Value());
}

// One device as a JSON object: what it is, and the last of each thing it said.
void appendDeviceJson(std::string& out, const State& state, const Device& device, std::string_view channel,
                      std::string_view label, bool hasTimes) {
  const auto key = [&](std::string_view name) {
    out += ",\"";
    out += name;
    out += "\":";
  };
  out += "{\"pin\":";
  appendJsonValue(out, device.kind == Device::Kind::Pin ? Value::text(device.pin.text()) : Value());
  if (!label.empty()) {
    key("label");
    appendJsonString(out, label);
  }
  key("channel");
  appendJsonString(out, channel);
  if (device.kind == Device::Kind::Pin) {
    key("device_type");
    appendJsonNumber(out, device.pin.deviceType());
  }
  if (device.kind == Device::Kind::Node) {
    key("node");
    appendJsonNumber(out, device.node.value);
  } else {
    key("address");
    appendJsonValue(out, device.address == kNullAddress ? Value() : Value::integer(device.address.value));
    key("address_changes");
    appendJsonNumber(out, device.addressChanges);
  }
  key("health");
  const Health health = healthOf(state, device);
  appendJsonString(out, health.key());
  key("causes");
  out += '[';
  for (bool isFirst = true; const HealthCause cause : kAllOf<HealthCause>) {
    if (!health.has(cause)) continue;
    if (!std::exchange(isFirst, false)) out += ',';
    appendJsonString(out, kHealthCauses[cause].key);
  }
  out += ']';
  key("frames");
  appendJsonNumber(out, device.frames);
  key("malformed");
  appendJsonNumber(out, device.malformed);
  if (device.position().isKnown()) {
    key("rotation_deg");
    appendAngle(out, device.position().value().rotation);
    key("rotation_state");
    appendJsonString(out, kPositionStateKeys[device.position().value().rotation.state]);
    key("elevation_deg");
    appendAngle(out, device.position().value().elevation);
    key("elevation_state");
    appendJsonString(out, kPositionStateKeys[device.position().value().elevation.state]);
    key("position_old");
    out += isStale(state, device, MessageId::PositionLimitStatus) ? "true" : "false";
  }
  if (device.faults().isKnown()) {
    key("faults");
    std::uint32_t named = 0;
    for (const ValueName& bit : akron::kFaultBits) named |= 1u << bit.value;
    appendJsonValue(out, Value::names(device.faults().value().map & named, akron::kFaultBits));
    key("reserved_bits");
    appendJsonValue(out, Value::numbers(device.faults().value().map & ~named));
    key("pcode_error");
    appendJsonValue(out, device.faults().value().pcodeError
                             ? Value::integer(*device.faults().value().pcodeError)
                             : Value());
    key("faults_age");
    const Duration ago = state.cursor().time - device.faults().at;
    appendJsonValue(out, hasTimes ? Value::decimal(ago / 100ms, 1) : Value());
    key("faults_old");
    const std::string_view why = ageWord(ageOfAnswer(state, device, device.faults().at));
    appendJsonValue(out, why.empty() ? Value() : Value::text(why));
  }
  if (device.firmware().isKnown()) {
    key("system");
    appendJsonString(out, versionText(device.firmware().value().system));
  }
  if (device.pcode().isKnown()) {
    key("style");
    appendJsonNumber(out, device.pcode().value().style);
    key("pcode_version");
    appendJsonString(out, versionText(device.pcode().value().version));
  }
  if (device.config().isKnown()) {
    key("config_type");
    appendJsonNumber(out, device.config().value().type);
  }
  if (device.partNumber.isKnown()) {
    key("part_number");
    appendJsonNumber(out, device.partNumber.value);
  }
  out += '}';
}

std::string deviceText(const State& state, const Device& device, std::string_view channel,
                       std::string_view label, bool hasTimes) {
  std::string out;
  if (device.kind == Device::Kind::Pin) {
    out += device.pin.text();
    const std::string_view type = deviceTypeName(device.pin.deviceType());
    out += "  ";
    out += type.empty() ? std::string_view("type not known") : type;
    if (!label.empty()) out.append(", ").append(printable(label));
  } else {
    out += "no PIN         ";
  }
  out += "  ";
  out += channel;
  if (device.kind == Device::Kind::Node) {
    out += "  node " + hex(device.node.value, 2);
  } else {
    out += device.address == kNullAddress ? "  address lost" : "  address " + hex(device.address.value, 2);
  }
  out += "  " + framesText(device.frames);
  if (device.malformed != 0) out += ", " + std::to_string(device.malformed) + " malformed";
  if (device.position().isKnown()) {
    const auto angle = [](const PositionReading& reading) {
      return reading.state == PositionState::Ok ? toText(Value::decimal(reading.tenths, 1)) + " deg"
                                                : std::string(kPositionStateKeys[reading.state]);
    };
    out += ", rotation " + angle(device.position().value().rotation);
    out += ", elevation " + angle(device.position().value().elevation);
    if (isStale(state, device, MessageId::PositionLimitStatus)) out += " (old)";
  }
  if (const std::string faults = faultsText(state, device, hasTimes); !faults.empty()) out += ", " + faults;
  return out.append(", ").append(healthOf(state, device).key());
}

}  // namespace

void InfoReport::countNew() {
  const std::uint64_t count = m_frames.count();
  if (m_withDevices) advance(m_state, m_frames, m_notes, cursorAfter(m_frames, count));
  while (m_next < count) {
    for (const Frame& frame : m_frames.run(m_next)) {
      if (m_next == count) break;
      ++m_byId[{frame.channel, frame.id}];
      if ((frame.flags & Frame::kTimeJump) != 0) ++m_timeJumps;
      ++m_next;
    }
  }
}

// Notes at the end too, which stand before no frame.
void InfoReport::takeNotes(Times times) {
  m_times = m_frames.hasTimes() ? times : Times::None;
  if (m_withDevices) advance(m_state, m_frames, m_notes, endOfRecording());
  for (const Note& note : m_notes.all()) {
    m_missed += framesMissed(note.value);
    if (std::holds_alternative<note::Mark>(note.value)) ++m_marks;
    if (const auto* added = std::get_if<note::Added>(&note.value)) m_added += added->count;
    if (const auto* label = std::get_if<note::Label>(&note.value)) m_labels[label->pin] = label->text.str();
    if (const auto* up = std::get_if<note::LinkUp>(&note.value); up != nullptr && !up->adapter.isEmpty())
      m_adapters.insert({up->channel.value, up->adapter.str(), up->bitRate});
  }
}

// A recording ends with its links closed. The report judges devices as they were before that, not as unknown since.
Cursor InfoReport::endOfRecording() const {
  Cursor end = endOf(m_frames, m_notes);
  for (const Note& note : m_notes.between(m_frames.count(), m_frames.count() + 1)) {
    const auto* down = std::get_if<note::LinkDown>(&note.value);
    if (down != nullptr && down->fault == LinkFault::None) end.time = std::min(end.time, note.time - 1ns);
  }
  return end;
}

std::string_view InfoReport::labelOf(const Device& device) const {
  const auto label = m_labels.find(device.pin);
  return label == m_labels.end() ? std::string_view() : label->second;
}

void InfoReport::appendNotes(std::string& out) const {
  for (const Adapter& at : m_adapters)
    out += "  " + std::string(m_frames.channelName(at.channel)) + " was " + printable(at.words) + "\n";
  if (m_added != 0)
    out += "  " + framesThat(m_added, "was", "were") + " added when it was saved: who held which address\n";
  if (m_missed != 0) out += "  " + framesThat(m_missed, "came and is", "came and are") + " not in it\n";
  if (m_marks != 0) out += "  " + counted(m_marks, "mark", "marks") + "\n";
}

void InfoReport::appendNotesJson(std::string& out) const {
  out += ",\"adapters\":[";
  for (const Adapter& at : m_adapters) {
    if (out.back() == '}') out += ',';
    out += "{\"channel\":";
    appendJsonString(out, m_frames.channelName(at.channel));
    out += ",\"adapter\":";
    appendJsonString(out, at.words);
    out += ",\"bit_rate\":";
    appendJsonValue(out, at.bitRate == 0 ? Value() : Value::integer(at.bitRate));
    out += '}';
  }
  out += "],\"added\":" + std::to_string(m_added) + ",\"missed\":" + std::to_string(m_missed) +
         ",\"marks\":" + std::to_string(m_marks);
}

Frame InfoReport::frameOf(const Key& key) const {
  Frame frame;
  frame.id = key.id;
  return frame;
}

std::string InfoReport::spanText() const {
  switch (m_times) {
    case Times::None: return "without times";
    case Times::Deltas:
      return "over a time that is not known, as their times look like differences ("
             "--deltas adds them up),";
    case Times::Known: break;
  }
  char text[40];
  std::snprintf(text, sizeof text, "over %.6f s", spanSeconds());
  return text;
}

double InfoReport::spanSeconds() const {
  if (m_frames.count() == 0) return 0;
  return std::chrono::duration<double>(m_frames.lastTime() - m_frames.timeAt(0)).count();
}

std::string InfoReport::text(const std::string& file, const SkippedPlaces& skipped) const {
  std::string out = file + "\n";
  char line[160];
  out += "  " + framesText(m_frames.count()) + " " + spanText() + " on " +
         counted(m_frames.channelCount(), "channel", "channels") + "\n";
  appendNotes(out);
  if (m_timeJumps != 0) out += "  " + framesText(m_timeJumps) + " whose time goes back or leaps\n";
  if (skipped.unreadable() != 0)
    out += "  " + counted(skipped.unreadable(), "unreadable line", "unreadable lines") + "\n";
  for (const Skipped reason : kAllOf<Skipped>) {
    if (isUnreadable(reason) || skipped.count(reason) == 0) continue;
    out += "  " + std::to_string(skipped.count(reason)) + " not kept: " + std::string(skippedText(reason)) +
           "\n";
  }
  for (const auto& [key, count] : m_byId) {
    std::string id;
    appendIdentifier(id, frameOf(key));
    const std::string channel(m_frames.channelName(key.channel));
    std::snprintf(line, sizeof line, "  %-10.40s %-8s %s %12llu\n", channel.c_str(), id.c_str(),
                  (key.id & kRemoteBit) != 0 ? "remote" : "      ", static_cast<unsigned long long>(count));
    out += line;
  }
  if (m_withDevices) {
    for (const std::string& what : untrackedLines(m_state)) out += "  " + what + "\n";
    out += "devices\n";
    for (const Device& device : m_state.devices().all()) {
      if (device.kind == Device::Kind::Free) continue;
      out += "  " +
             deviceText(m_state, device, m_frames.channelName(device.channel.value), labelOf(device),
                        m_times == Times::Known) +
             "\n";
    }
  }
  return out;
}

std::string InfoReport::json(const std::string& file, const SkippedPlaces& skipped) const {
  std::string out = "{\"file\":";
  appendJsonString(out, file);
  out += ",\"frames\":" + std::to_string(m_frames.count());
  char span[40] = ",\"span\":null";
  if (m_times == Times::Known) std::snprintf(span, sizeof span, ",\"span\":%.6f", spanSeconds());
  out += span;
  out += ",\"delta_times\":";
  out += m_times == Times::Deltas ? "true" : "false";
  appendNotesJson(out);
  out += ",\"time_jumps\":" + std::to_string(m_timeJumps);
  out += ",\"unreadable\":" + std::to_string(skipped.unreadable());
  out += ",\"not_kept\":{";
  bool first = true;
  const auto comma = [&] {
    if (!first) out += ',';
    first = false;
  };
  for (const Skipped reason : kAllOf<Skipped>) {
    if (isUnreadable(reason) || skipped.count(reason) == 0) continue;
    comma();
    appendJsonString(out, skippedText(reason));
    out += ':' + std::to_string(skipped.count(reason));
  }
  out += "},\"ids\":[";
  first = true;
  for (const auto& [key, count] : m_byId) {
    comma();
    out += "{\"channel\":";
    appendJsonString(out, m_frames.channelName(key.channel));
    out += ",\"id\":\"";
    appendIdentifier(out, frameOf(key));
    out += '"';
    if ((key.id & kRemoteBit) != 0) out += ",\"remote\":true";
    if ((key.id & kErrorBit) != 0) out += ",\"error\":true";
    out += ",\"frames\":" + std::to_string(count) + '}';
  }
  out += ']';
  if (m_withDevices) {
    out += ",\"untracked_frames\":" + std::to_string(m_state.untrackedFrames());
    out += ",\"untracked_devices\":" + std::string(m_state.devices().untracked() != 0 ? "true" : "false");
    out += ",\"devices\":[";
    first = true;
    for (const Device& device : m_state.devices().all()) {
      if (device.kind == Device::Kind::Free) continue;
      comma();
      appendDeviceJson(out, m_state, device, m_frames.channelName(device.channel.value), labelOf(device),
                       m_times == Times::Known);
    }
    out += ']';
  }
  return out + "}\n";
}

}  // namespace deckpipe::ctl
