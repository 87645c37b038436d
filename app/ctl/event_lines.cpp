// SPDX-License-Identifier: GPL-3.0-or-later
#include "event_lines.h"

#include <algorithm>
#include <cstdio>

#include "base/part_state.h"
#include "counts.h"
#include "link_words.h"
#include "output.h"
#include "protocol/akron.h"
#include "protocol/field.h"
#include "protocol/name.h"
#include "request_words.h"

namespace deckpipe::ctl {
namespace {

constexpr EnumTable<EventKind, const char*> kMeanings{{
    {EventKind::Appeared,
     "a device is heard for the first time, 3 s or more after the channel's first frame, or behind a "
     "gap of the link by a new PIN"},
    {EventKind::Silent, "its periodic messages are missing for 3 s or three of its periods (since)"},
    {EventKind::Back, "they come again, after so long (ms)"},
    {EventKind::NotBack,
     "it repeated something before a gap of the link, and is not heard behind it for as long (since; pin: of "
     "before)"},
    {EventKind::Restarted, "it announced itself unasked, or a node booted"},
    {EventKind::NotOperational, "a CANopen node is not in the operational state (was, now)"},
    {EventKind::Operational, "... and is operational again (was, now)"},
    {EventKind::Malformed, "one of its periodic messages comes in a wrong length only (since)"},
    {EventKind::MalformedOver, "... all of them are well again"},
    {EventKind::MovedAddress, "a device has another address (was, now)"},
    {EventKind::AddressLost, "another NAME or PIN has its address (was, now: NAMEs)"},
    {EventKind::CannotClaim, "it said that it can claim no address (was: its NAME)"},
    {EventKind::TwoAtOneAddress, "two devices send from one address (other_pin)"},
    {EventKind::TwoAtOneAddressOver, "... one again"},
    {EventKind::Fault, "its answer names a fault (fault)"},
    {EventKind::FaultCleared, "... no longer (fault)"},
    {EventKind::DeviceFaulted, "a 6033 says that it is faulted (was, now)"},
    {EventKind::DeviceFaultedOver, "... no longer (was, now)"},
    {EventKind::OperationalError, "it reports an operational error (code: null until it is asked)"},
    {EventKind::OperationalErrorOver, "... no longer (code)"},
    {EventKind::ErrorCode, "its answer has another error code (code, was, now)"},
    {EventKind::ErrorCodeCleared, "... none any more (code, was, now)"},
    {EventKind::SensorError, "its position sensor fails (axis, was, now)"},
    {EventKind::SensorErrorOver, "... no longer (axis, was, now)"},
    {EventKind::Disabled, "enable is off: it cannot move (was, now)"},
    {EventKind::Enabled, "enable is on (was, now)"},
    {EventKind::PermissiveLost, "no permissive for 300 ms, or for no direction (was, now)"},
    {EventKind::PermissiveBack, "a permissive for a direction (was, now)"},
    {EventKind::RemoteMode, "remote mode is on (was, now)"},
    {EventKind::RemoteModeOver, "... off (was, now)"},
    {EventKind::Stowed, "it is stowed (was, now)"},
    {EventKind::NotStowed, "... no longer (was, now)"},
    {EventKind::StopReached, "an axis stands at a hard stop (axis, side, was, now)"},
    {EventKind::StopLeft, "... no longer (axis, side, was, now)"},
    {EventKind::StopError, "a hard stop reports an error (axis, side, was, now)"},
    {EventKind::SoftLimitChanged, "a soft limit is elsewhere (axis, side, was, now: degrees)"},
    {EventKind::JoystickBegan, "a source begins to send joystick messages"},
    {EventKind::JoystickEnded, "... sent none for 2 s (since)"},
    {EventKind::JoystickGap, "more than 100 ms between two of them (ms)"},
    {EventKind::JoystickTimedOut, "none for 200 ms: controllers clear its input (a malformed one is none)"},
    {EventKind::JoystickBack, "... they come again, after so long (ms)"},
    {EventKind::JoystickOutranked, "a source of higher priority deflects the same axis (axis, by)"},
    {EventKind::JoystickOutrankedOver, "... no longer (axis)"},
    {EventKind::LoadHigh,
     "80 % of its bit rate or more in a second (was, now: percent; bit_rate; rate_assumed)"},
    {EventKind::LoadNormal, "... below 60 % (was, now, bit_rate, rate_assumed)"},
    {EventKind::ErrorFrames, "error frames begin"},
    {EventKind::ErrorFramesOver, "... none for 1 s (frames)"},
    {EventKind::BusOff, "the adapter is bus-off"},
    {EventKind::ErrorPassive, "the adapter is error-passive"},
    {EventKind::ErrorActive, "... error-active again"},
    {EventKind::ClockJump, "the clock of the log jumps"},
}};

// The keys of notes. `deckpipectl watch` has the same ones.
constexpr const char* kNotesHelp =
    "mark (text), link_up (adapter, bit_rate), link_down (reason, words), dropped (frames), locked,\n"
    "unlocked, own_address (reason),\n"
    "drive_said, drive_unsaid, asked (ask), ask_ended (ask, end), ask_waits (ask), still_waits (frames), "
    "pipe (file),\n"
    "left_out (frames, lines or places; reason), label (text), filtered (text),\n"
    "angles_before (ask, rotation_deg, elevation_deg: where it stood before a command),\n"
    "motion_armed (limit_percent, echo_proven, platform), motion_ended (reason, disarmed, frames, "
    "period_us,\n"
    "worst_gap_us), motion_late: our joystick, and an old frame of it that went out late";

std::string faultKey(std::int64_t bit) {
  const auto found =
      std::ranges::find(akron::kFaultBits, static_cast<std::uint64_t>(bit),
                        [](const auto& name) { return static_cast<std::uint64_t>(name.value); });
  return found != akron::kFaultBits.end() ? std::string(found->word) : "reserved_bit_" + std::to_string(bit);
}

// "47.3", "-5.5"
std::string tenthsText(std::int64_t tenths) {
  char text[32];
  std::snprintf(text, sizeof text, tenths % 10 == 0 ? "%.0f" : "%.1f", static_cast<double>(tenths) / 10);
  return text;
}

// "12.300": cut to milliseconds, as the window cuts them (text/time_text.h). Below zero counts as zero.
std::string secondsText(Duration time) {
  const long long ms = std::max<std::int64_t>(0, time.count()) / 1'000'000;
  char text[32];
  std::snprintf(text, sizeof text, "%lld.%03lld", ms / 1000, ms % 1000);
  return text;
}

std::string_view status2Key(std::int64_t status) { return kStatus2Keys[static_cast<Status2>(status & 3)]; }

const char* sideOf(const Event& event) { return event.isPlus ? "plus" : "minus"; }

std::string detailText(const Event& event) {
  std::string text;
  const auto change = [&](const std::string& was, const std::string& now) {
    text += ": " + was + " -> " + now;
  };
  if (event.axis != 0) {
    text += ", axis " + std::to_string(event.axis);
    const EventDetail detail = kEvents[event.kind].detail;
    if (detail == EventDetail::Stop || detail == EventDetail::Degrees) text += event.isPlus ? " +" : " -";
  }
  char hex[16];
  switch (kEvents[event.kind].detail) {
    case EventDetail::None:
    case EventDetail::Flag: break;
    case EventDetail::Address:
      std::snprintf(hex, sizeof hex, "%02X -> %02X", static_cast<unsigned>(event.was & 0xFF),
                    static_cast<unsigned>(event.now & 0xFF));
      text += std::string(": ") + hex;
      break;
    case EventDetail::Percent:
      change(std::to_string(event.was) + " %", std::to_string(event.now) + " %");
      text += " of " + std::to_string(event.bitRate / 1000) + " kbit/s";
      if (event.isRateAssumed) text += ", which is assumed";
      break;
    case EventDetail::Name:
      if (event.now != 0) appendHex(text += " to NAME ", static_cast<std::uint64_t>(event.now), 16);
      break;
    case EventDetail::Fault: text += ": " + faultKey(event.now); break;
    case EventDetail::Code:
      if (event.now != 0 && event.was != 0) {
        change(std::to_string(event.was), std::to_string(event.now));
      } else if (event.now + event.was != 0) {
        text += ": " + std::to_string(event.now + event.was);
      }
      break;
    case EventDetail::Stop: break;
    case EventDetail::Degrees: change(tenthsText(event.was), tenthsText(event.now)); break;
    case EventDetail::Length: text += ", after " + lengthText(Duration(event.now)); break;
    case EventDetail::Source:
      std::snprintf(hex, sizeof hex, ", by %02X", static_cast<unsigned>(event.now & 0xFF));
      text += hex;
      break;
    case EventDetail::Frames: text += ": " + framesText(static_cast<std::uint64_t>(event.now)); break;
  }
  return text;
}

std::string spoken(std::string_view key) {
  std::string text(key);
  std::ranges::replace(text, '_', ' ');
  return text;
}

// The word says what a note counts.
template <typename Kind>
std::string_view countedIn(const Kind& n) {
  if constexpr (requires { n.why; }) {
    if (n.why == Kind::Why::Unreadable) return "lines";
    if (n.why == Kind::Why::RecorderLost || n.why == Kind::Why::NotWhole) return "places";
  }
  return "frames";
}

// The text behind the word for a note: ": fault, no answer"
std::string detailText(const NoteValue& value) {
  std::string text;
  const auto say = [&text](std::string_view what) {
    if (!what.empty()) text.append(text.empty() ? ": " : ", ").append(what);
  };
  std::visit(
      [&](const auto& n) {
        if constexpr (requires { n.text; }) say(n.text.str());
        if constexpr (requires { n.adapter; }) say(n.adapter.str());
        if constexpr (requires { n.fault; }) {
          if (n.fault != LinkFault::None)
            say(linkErrorText({.fault = n.fault, .detail = n.words.str()}).toStdString());
        }
        if constexpr (requires { n.request; }) say(requestWord(n.request));
        if constexpr (requires { n.rotation; }) {
          if (n.rotation.tenths) say("rotation " + tenthsText(*n.rotation.tenths));
          if (n.elevation.tenths) say("elevation " + tenthsText(*n.elevation.tenths));
        }
        if constexpr (requires { n.end; }) say(spoken(endWord(n.request, n.end)));
        if constexpr (requires { n.cause; }) say(spoken(kMotionCauseWords[n.cause].word));
        if constexpr (requires { n.count; }) {
          const std::string_view many = countedIn(n);
          say(counted(n.count, many.substr(0, many.size() - 1), many));
        }
        if constexpr (requires { n.why; }) say(spoken(leftOutWord(n.why)));
      },
      value);
  return text;
}

struct Whom {
  Pin pin;
  Address address = kNullAddress;
};
Whom whomOf(const NoteValue& value) {
  Whom whom;
  std::visit(
      [&](const auto& n) {
        if constexpr (requires { n.pin; }) whom.pin = n.pin;
        if constexpr (requires { n.address; }) whom.address = n.address;
      },
      value);
  return whom;
}

std::string whoText(const Pin& pin, Address address, NodeId node) {
  if (!pin.isNull()) return std::string(pin.text());
  char text[16];
  if (node.value != 0) {
    std::snprintf(text, sizeof text, "node %02X", node.value);
    return text;
  }
  if (address == kNullAddress) return "-";
  std::snprintf(text, sizeof text, "%02X", address.value);
  return text;
}

}  // namespace

std::int64_t EventLines::stampOf(Instant time, std::uint8_t channel, std::uint64_t frame) const {
  return m_frames[0].hasStamp() && m_frames.hasTimes()
             ? saturatedMinus(time.ns, m_frames.offsetOf(channel, frame))
             : kNoStamp;
}

// A frame at which the clock jumps may have a stamp that is no time.
std::int64_t EventLines::stampOf(const Event& event) const {
  const std::uint64_t frame = std::max<std::uint64_t>(event.frame, 1) - 1;
  if (event.kind == EventKind::ClockJump) return m_frames.hasTimes() ? m_frames[frame].stamp : kNoStamp;
  return stampOf(event.time, event.channel.value, frame);
}

// The clocks of a recording are one.
std::int64_t EventLines::stampOf(const Note& note) const {
  const std::uint64_t frame = std::max<std::uint64_t>(note.frame, 1) - 1;
  return stampOf(note.time, m_frames[frame].channel, frame);
}

void EventLines::append(std::string& out, const Event& event) const {
  out += m_asJson ? json(event) : text(event);
}

void EventLines::append(std::string& out, const Note& note) const {
  if (m_asJson) {
    out += json(note);
    return;
  }
  const auto channel = channelOf(note.value);
  const Whom whom = whomOf(note.value);
  out += begin(whoText(whom.pin, whom.address, {}), noteWeight(note.value), note.time,
               channel ? m_frames.channelName(channel->value) : "-") +
         printable(spoken(noteKey(note.value)) + detailText(note.value)) + "\n";
}

// "12.300", since the begin; a dash where the log has no times.
std::string EventLines::whenText(Instant time) const {
  return m_frames.hasTimes() ? secondsText(time - m_frames.timeAt(0)) : "-";
}

// "      12.300  can0   1032AE100801035  warning  "
std::string EventLines::begin(std::string_view who, Severity weight, Instant time,
                              std::string_view channel) const {
  char text[128];
  const std::string_view word = eventWeightKey(weight);
  std::snprintf(text, sizeof text, "%12s  %-6.*s %-15.*s  %-7.*s  ", whenText(time).c_str(),
                static_cast<int>(channel.size()), channel.data(), static_cast<int>(who.size()), who.data(),
                static_cast<int>(word.size()), word.data());
  return text;
}

std::string EventLines::text(const Event& event) const {
  std::string line = begin(whoText(event.pin, event.address, event.node), kEvents[event.kind].weight,
                           event.time, m_frames.channelName(event.channel.value)) +
                     spoken(kEvents[event.kind].key) + detailText(event);
  if (!event.other.isNull()) line += ", the other is " + std::string(event.other.text());
  if (event.since != kNotYet) line += ", since " + whenText(event.since);
  if (event.folded > 0) line += " (" + counted(event.folded, "change", "changes") + " before it left out)";
  return line + "\n";
}

std::string EventLines::json(const Event& event) const {
  const EventFacts& facts = kEvents[event.kind];
  JsonLine line;
  line.add("event", facts.key).addTime("t", stampOf(event));
  line.add("channel", m_frames.channelName(event.channel.value));
  if (!event.pin.isNull()) line.add("pin", event.pin);
  if (event.address != kNullAddress) line.add("address", event.address);
  if (event.node.value != 0) line.add("node", event.node.value);
  line.add("weight", eventWeightKey(facts.weight));
  addEventFields(line, event);
  if (!event.other.isNull()) line.add("other_pin", event.other);
  if (event.since != kNotYet)
    line.addTime("since", stampOf(event.since, event.channel.value, m_frames.firstAtOrAfter(event.since)));
  if (event.folded > 0) line.add("folded", event.folded);
  return line.text();
}

std::string EventLines::json(const Note& note) const {
  JsonLine line;
  line.add("event", noteKey(note.value)).addTime("t", stampOf(note));
  if (const auto channel = channelOf(note.value)) line.add("channel", m_frames.channelName(channel->value));
  const Whom whom = whomOf(note.value);
  if (!whom.pin.isNull()) line.add("pin", whom.pin);
  if (whom.address != kNullAddress) line.add("address", whom.address);
  line.add("weight", eventWeightKey(noteWeight(note.value)));
  addNoteFields(line, note.value);
  return line.text();
}

void addEventFields(JsonLine& line, const Event& event) {
  const EventDetail detail = kEvents[event.kind].detail;
  if (event.axis != 0) line.add("axis", event.axis);
  switch (detail) {
    case EventDetail::None: break;
    case EventDetail::Flag: line.add("was", event.was != 0).add("now", event.now != 0); break;
    case EventDetail::Address: line.add("was", event.was).add("now", event.now); break;
    case EventDetail::Percent:
      line.add("was", event.was).add("now", event.now).add("bit_rate", event.bitRate);
      line.add("rate_assumed", event.isRateAssumed);
      break;
    case EventDetail::Name:
      for (const auto& [key, name] : {std::pair("was", event.was), std::pair("now", event.now)})
        name == 0 ? line.add(key, Value()) : line.addHex(key, static_cast<std::uint64_t>(name), 16);
      break;
    case EventDetail::Fault: line.add("fault", faultKey(event.now)); break;
    case EventDetail::Code: {
      const std::int64_t code = event.now != 0 ? event.now : event.was;
      code == 0 ? line.add("code", Value()) : line.add("code", code);
      if (event.kind == EventKind::ErrorCode || event.kind == EventKind::ErrorCodeCleared)
        line.add("was", event.was).add("now", event.now);
      break;
    }
    case EventDetail::Stop:
      line.add("side", sideOf(event)).add("was", status2Key(event.was)).add("now", status2Key(event.now));
      break;
    case EventDetail::Degrees:
      line.add("side", sideOf(event));
      line.addJson("was", tenthsText(event.was)).addJson("now", tenthsText(event.now));
      break;
    case EventDetail::Length: line.add("ms", event.now / 1'000'000); break;
    case EventDetail::Source: line.add("by", event.now); break;
    case EventDetail::Frames: line.add("frames", event.now); break;
  }
}

void addNoteFields(JsonLine& line, const NoteValue& value) {
  const auto addText = [&line](const char* key, const NoteText& text) {
    if (!text.isEmpty()) line.add(key, text.str());
  };
  const auto addAngle = [&line](const char* key, const note::NotedAngle& angle) {
    line.addJson(key, angle.tenths ? tenthsText(*angle.tenths) : "null");
  };
  std::visit(
      [&](const auto& n) {
        if constexpr (requires { n.text; }) line.add("text", n.text.str());
        if constexpr (requires { n.adapter; }) addText("adapter", n.adapter);
        if constexpr (requires { n.bitRate; }) {
          if (n.bitRate != 0) line.add("bit_rate", n.bitRate);
        }
        if constexpr (requires { n.fault; }) line.add("reason", kLinkFaultKeys[n.fault]);
        if constexpr (requires { n.words; }) addText("words", n.words);
        if constexpr (requires { n.how; }) line.add("reason", ownAddressWord(n.how));
        if constexpr (requires { n.request; }) line.add("ask", requestWord(n.request));
        if constexpr (requires { n.rotation; }) {
          addAngle("rotation_deg", n.rotation);
          addAngle("elevation_deg", n.elevation);
        }
        if constexpr (requires { n.end; }) line.add("end", endWord(n.request, n.end));
        if constexpr (requires { n.file; }) addText("file", n.file);
        if constexpr (requires { n.platform; }) {
          line.addJson("limit_percent", tenthsText(n.limit));
          line.add("echo_proven", n.isProven);
          addText("platform", n.platform);
        }
        if constexpr (requires { n.cause; }) {
          line.add("reason", kMotionCauseWords[n.cause].word).add("disarmed", n.isDisarmed);
          line.add("frames", n.messages).add("period_us", n.period).add("worst_gap_us", n.worstGap);
        }
        if constexpr (requires { n.count; }) line.add(countedIn(n), n.count);
        if constexpr (requires { n.why; }) line.add("reason", leftOutWord(n.why));
      },
      value);
}

std::string eventKeysHelp() {
  std::string text = "Events:\n";
  for (const EventKind kind : kAllOf<EventKind>) {
    std::string key(kEvents[kind].key);
    key.resize(25, ' ');
    text += "  " + key + kMeanings[kind] + "\n";
  }
  return text + "Notes of a recording:\n" + kNotesHelp + "\n";
}

}  // namespace deckpipe::ctl
