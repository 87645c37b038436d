// SPDX-License-Identifier: GPL-3.0-or-later
#include "info_report.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "counts.h"
#include "event_lines.h"
#include "json_line.h"
#include "link_words.h"
#include "log/time_grain.h"
#include "node_lines.h"
#include "output.h"
#include "report/trace_text.h"
#include "state/advance.h"
#include "state/current.h"
#include "state/health.h"
#include "stick_lines.h"

namespace deckpipe::ctl {
namespace {

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
    case AnswerAge::BeforeGap: return "before the link went down";
  }
  return {};
}

// The same for a script. Frozen contract.
Value ageKey(AnswerAge age) {
  switch (age) {
    case AnswerAge::Current: break;
    case AnswerAge::BeforeRestart: return Value::word("restart");
    case AnswerAge::BeforeSilence: return Value::word("silence");
    case AnswerAge::BeforeLinkDown: return Value::word("link_down");
    case AnswerAge::BeforeGap: return Value::word("gap");
  }
  return {};
}

// The PIN that was at its address before the link was down; null if somebody has said since who is there.
Pin formerPinOf(const State& state, const Device& device) {
  const bool isAddress = device.kind == Device::Kind::Address;
  return isAddress ? state.channel(device.channel).book.formerPin(device.address) : Pin();
}

// The device's last answer about faults, how long ago it came, and why it is old: "no faults, asked 93 s ago, restarted
// since". That it is silent its health says.
std::string faultsText(const State& state, const Device& device, const Health& health, bool hasTimes) {
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
  const AnswerAge age = ageOfAnswer(state, device, device.faults().at);
  const bool isSaid = age == AnswerAge::BeforeSilence && health.has(HealthCause::Silent);
  if (const std::string_view why = ageWord(age); !why.empty() && !isSaid) out.append(", ").append(why);
  return out;
}

void addAngle(JsonLine& line, const char* number, const char* state, const PositionReading& reading) {
  line.add(number, reading.state == PositionState::Ok ? Value::decimal(reading.tenths, 1) : Value());
  line.add(state, kPositionStateKeys[reading.state]);
}

// How long ago an answer came, and why it may not hold any more.
void addAge(JsonLine& line, const char* age, const char* old, const State& state, const Device& device,
            Instant at, bool hasTimes) {
  line.add(age, hasTimes ? Value::decimal((state.cursor().time - at) / 100ms, 1) : Value());
  line.add(old, ageKey(ageOfAnswer(state, device, at)));
}

// One device as a JSON object: what it is, and the last of each thing it said.
std::string deviceJson(const State& state, const Device& device, std::string_view channel,
                       std::string_view label, bool hasTimes) {
  JsonLine line;
  line.add("pin", device.pin);
  if (const Pin former = formerPinOf(state, device); !former.isNull()) line.add("former_pin", former);
  if (!label.empty()) line.add("label", label);
  line.add("channel", channel);
  if (device.kind == Device::Kind::Pin) line.add("device_type", device.pin.deviceType());
  if (device.kind == Device::Kind::Node) {
    line.add("node", device.node.value);
  } else {
    line.add("address", device.address).add("address_changes", device.addressChanges);
  }
  const Health health = healthOf(state, device);
  line.add("health", health.key()).add("causes", causesOf(health));
  line.add("frames", device.frames).add("malformed", device.malformed);
  if (device.position().isKnown()) {
    addAngle(line, "rotation_deg", "rotation_state", device.position().value().rotation);
    addAngle(line, "elevation_deg", "elevation_state", device.position().value().elevation);
    line.add("position_old", isStale(state, device, MessageId::PositionLimitStatus));
    const Duration ago = state.cursor().time - device.position().at;
    line.add("position_age", hasTimes ? Value::decimal(ago / 100ms, 1) : Value());
  }
  if (device.faults().isKnown()) {
    const FaultStatus faults = device.faults().value();
    std::uint32_t named = 0;
    for (const ValueName& bit : akron::kFaultBits) named |= 1u << bit.value;
    line.add("faults", Value::names(faults.map & named, akron::kFaultBits));
    line.add("reserved_bits", Value::numbers(faults.map & ~named));
    line.add("pcode_error", faults.pcodeError ? Value::integer(*faults.pcodeError) : Value());
    addAge(line, "faults_age", "faults_old", state, device, device.faults().at, hasTimes);
  }
  if (device.firmware().isKnown()) {
    line.add("system", Value::version(device.firmware().value().system));
    addAge(line, "system_age", "system_old", state, device, device.firmware().at, hasTimes);
  }
  if (device.pcode().isKnown()) {
    line.add("style", device.pcode().value().style);
    line.add("pcode_version", Value::version(device.pcode().value().version));
    addAge(line, "pcode_age", "pcode_old", state, device, device.pcode().at, hasTimes);
  }
  if (device.config().isKnown()) {
    line.add("config_type", device.config().value().type);
    addAge(line, "config_age", "config_old", state, device, device.config().at, hasTimes);
  }
  if (device.part() != 0) line.add("part_number", device.part());
  return line.object();
}

std::string deviceText(const State& state, const Device& device, std::string_view channel,
                       std::string_view label, bool hasTimes) {
  std::string out;
  if (device.kind == Device::Kind::Pin) {
    out += device.pin.text();
    const std::string_view type = typeName(device);
    out += "  ";
    out += type.empty() ? std::string_view("type not known") : type;
    if (!label.empty()) out.append(", ").append(printable(label));
  } else {
    out += "no PIN         ";
    if (const std::string_view type = typeName(device); !type.empty()) out.append("  ").append(type);
    if (const Pin former = formerPinOf(state, device); !former.isNull())
      out.append("  was ").append(former.text()).append(" before the link went down");
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
    if (isStale(state, device, MessageId::PositionLimitStatus))
      out += hasTimes ? " (" + lengthText(state.cursor().time - device.position().at) + " old)" : " (old)";
  }
  const Health health = healthOf(state, device);
  if (const std::string faults = faultsText(state, device, health, hasTimes); !faults.empty())
    out += ", " + faults;
  return out.append(", ").append(health.key());
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
  m_times = m_frames.hasTimes() || times == Times::Deltas ? times : Times::None;
  if (m_withDevices) advance(m_state, m_frames, m_notes, endOfRecording());
  for (const Note& note : m_notes.all()) {
    m_missed += framesMissed(note.value);
    if (const auto* leftOut = std::get_if<note::LeftOut>(&note.value)) {
      if (leftOut->why == note::LeftOut::Why::Unreadable) m_missedLines += leftOut->count;
      if (leftOut->why == note::LeftOut::Why::RecorderLost) m_missedPlaces += leftOut->count;
      if (leftOut->why == note::LeftOut::Why::NotWhole) m_placesNotWhole += leftOut->count;
    }
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
  for (const LinkGap& gap : linkGaps(m_notes.all())) {
    if (gap.isOpen() && gap.fault == LinkFault::None && gap.begin >= m_frames.lastTime())
      end.time = std::min(end.time, gap.begin - 1ns);
  }
  return end;
}

// A recording ends with its links closed: that is no gap.
std::vector<LinkGap> InfoReport::gaps() const {
  std::vector<LinkGap> all = linkGaps(m_notes.all());
  std::erase_if(all, [](const LinkGap& gap) { return gap.isOpen() && gap.fault == LinkFault::None; });
  return all;
}

std::string InfoReport::gapText(const LinkGap& gap) const {
  std::string text = "link of " + std::string(m_frames.channelName(gap.channel.value)) + " down";
  if (m_times == Times::Known) {
    if (!gap.isOpen()) text += " for " + lengthText(gap.end - gap.begin);
    const Instant first = m_frames.timeAt(0);
    text += gap.begin < first ? " before the first frame" : " from " + lengthText(gap.begin - first) + " on";
  }
  if (gap.isOpen()) text += ", to the end";
  if (gap.fault == LinkFault::None) return text + ": closed";
  return text + ": " +
         printable(linkErrorText({.fault = gap.fault, .detail = gap.words.str()}).toStdString());
}

std::string InfoReport::gapJson(const LinkGap& gap) const {
  const EventLines lines(m_frames, true);
  const auto stampOf = [&](Instant time) {
    const std::uint64_t frame = std::min(m_frames.firstAtOrAfter(time), m_frames.count() - 1);
    return m_times == Times::Known ? lines.stampOf(time, gap.channel.value, frame) : kNoStamp;
  };
  JsonLine line;
  line.add("channel", m_frames.channelName(gap.channel.value)).addTime("from", stampOf(gap.begin));
  line.addTime("to", gap.isOpen() ? kNoStamp : stampOf(gap.end)).add("reason", kLinkFaultKeys[gap.fault]);
  if (!gap.words.isEmpty()) line.add("words", gap.words.str());
  return line.object();
}

template <typename Take>
void InfoReport::eachStick(Take take) const {
  for (std::size_t c = 0; c < m_state.channelCount(); ++c) {
    const Channel channel{static_cast<std::uint8_t>(c)};
    for (const Joystick& stick : m_state.channel(channel).joysticks.all()) {
      if (stick.source != kNullAddress) take(channel, stick, m_frames.channelName(channel.value));
    }
  }
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
  for (const std::string& filter : m_notes.filters())
    out += "  saved through the filter '" + printable(filter) + "': what did not pass it is missing\n";
  if (m_missed != 0) out += "  " + framesThat(m_missed, "came and is", "came and are") + " not in it\n";
  if (m_missedPlaces != 0)
    out += "  the recorder lost frames at " + counted(m_missedPlaces, "place", "places") + "\n";
  if (m_placesNotWhole != 0)
    out += "  the file that it was saved from was not whole at " +
           counted(m_placesNotWhole, "place", "places") + "\n";
  if (m_missedLines != 0)
    out +=
        "  " + counted(m_missedLines, "line", "lines") + " of the file that it was saved from not readable\n";
  for (const LinkGap& gap : gaps()) out += "  " + gapText(gap) + "\n";
  if (m_marks != 0) out += "  " + counted(m_marks, "mark", "marks") + "\n";
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
  char text[80];
  const bool isCoarse = timeGrainOf(m_frames) == TimeGrain::Seconds;
  std::snprintf(text, sizeof text, isCoarse ? "over about %.0f s" : "over %.6f s", spanSeconds());
  return text;
}

// Counts the frames of channels beyond those that a store names.
std::uint64_t InfoReport::framesOfOthers() const {
  std::uint64_t frames = 0;
  for (const auto& [key, count] : m_byId) frames += key.channel == FrameStore::kOtherChannels ? count : 0;
  return frames;
}

double InfoReport::spanSeconds() const {
  if (m_frames.count() == 0) return 0;
  return std::chrono::duration<double>(endOf(m_frames, m_notes).time - m_frames.timeAt(0)).count();
}

std::string InfoReport::text(const std::string& file, const SkippedPlaces& skipped) const {
  std::string out = file + "\n";
  char line[160];
  constexpr std::size_t kNamed = FrameStore::kOtherChannels;
  out += "  " + framesText(m_frames.count()) + " " + spanText() + " on " +
         counted(std::min(m_frames.channelCount(), kNamed), "channel", "channels") + "\n";
  if (const std::uint64_t others = framesOfOthers(); others != 0)
    out += "  " + framesThat(others, "is", "are") + " of further channels, which are all taken for one: '" +
           std::string(FrameStore::kOtherChannelsName) + "'\n";
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
    eachStick([&](Channel channel, const Joystick& stick, std::string_view name) {
      out += "  " + stickText(m_state, channel, stick, name, m_times == Times::Known) + "\n";
    });
  }
  return out;
}

std::string InfoReport::json(const std::string& file, const SkippedPlaces& skipped, LastLine lastLine) const {
  char span[40] = "null";
  if (m_times == Times::Known) std::snprintf(span, sizeof span, "%.6f", spanSeconds());
  std::vector<std::string> adapters, linkGapList, ids, devices, sticks;
  for (const Adapter& at : m_adapters)
    adapters.push_back(JsonLine()
                           .add("channel", m_frames.channelName(at.channel))
                           .add("adapter", at.words)
                           .add("bit_rate", at.bitRate == 0 ? Value() : Value::integer(at.bitRate))
                           .object());
  for (const LinkGap& gap : gaps()) linkGapList.push_back(gapJson(gap));
  JsonLine notKept;
  for (const Skipped reason : kAllOf<Skipped>) {
    if (!isUnreadable(reason) && skipped.count(reason) != 0)
      notKept.add(skippedText(reason), skipped.count(reason));
  }
  for (const auto& [key, count] : m_byId) {
    std::string id;
    appendIdentifier(id, frameOf(key));
    JsonLine line;
    line.add("channel", m_frames.channelName(key.channel)).add("id", id);
    if ((key.id & kRemoteBit) != 0) line.add("remote", true);
    if ((key.id & kErrorBit) != 0) line.add("error", true);
    ids.push_back(line.add("frames", count).object());
  }
  JsonLine line;
  line.add("file", file).add("frames", m_frames.count()).addJson("span", span);
  line.add("of_further_channels", framesOfOthers());
  line.add("delta_times", m_times == Times::Deltas).addList("adapters", adapters);
  line.addList("link_gaps", linkGapList).add("added", m_added);
  const std::vector<std::string> filters = m_notes.filters();
  line.add("filters", std::vector<std::string_view>(filters.begin(), filters.end()));
  line.add("last_line", kLastLineKeys[lastLine])
      .add("missed", m_missed)
      .add("missed_lines", m_missedLines)
      .add("missed_places", m_missedPlaces)
      .add("places_not_whole", m_placesNotWhole)
      .add("marks", m_marks)
      .add("time_jumps", m_timeJumps);
  line.add("unreadable", skipped.unreadable()).addJson("not_kept", notKept.object()).addList("ids", ids);
  if (m_withDevices) {
    for (const Device& device : m_state.devices().all()) {
      if (device.kind != Device::Kind::Free)
        devices.push_back(deviceJson(m_state, device, m_frames.channelName(device.channel.value),
                                     labelOf(device), m_times == Times::Known));
    }
    eachStick([&](Channel channel, const Joystick& stick, std::string_view name) {
      sticks.push_back(stickJson(m_state, channel, stick, name, m_times == Times::Known));
    });
    line.add("untracked_frames", m_state.untrackedFrames());
    line.add("untracked_devices", m_state.devices().untracked() != 0).addList("devices", devices);
    line.addList("joysticks", sticks);
  }
  return line.text();
}

}  // namespace deckpipe::ctl
