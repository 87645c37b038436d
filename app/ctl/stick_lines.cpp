// SPDX-License-Identifier: GPL-3.0-or-later
#include "stick_lines.h"

#include "counts.h"
#include "json_line.h"
#include "protocol/catalogue.h"
#include "protocol/decode.h"
#include "state/current.h"
#include "state/stick_watch.h"

namespace deckpipe::ctl {
namespace {

// Why what it asked for last does not hold any more. Null: it holds, or the log does not tell.
Value whyOld(const State& state, Channel channel, const Joystick& stick) {
  if (!stick.basic.isKnown() || state.isFiltered()) return {};
  if (isLinkDown(state, channel)) return Value::word("link_down");
  if (isCutOff(state, channel, stick.basic.at)) return Value::word("gap");
  return stick.timedOut ? Value::word("silence") : Value();
}

void addFields(JsonLine& line, MessageId id, const Frame& frame) {
  for (const Field& field : messageOf(id).fields) {
    if (!field.key.empty() && isPresent(field, frame)) line.add(field.key, valueOf(field, frame));
  }
}

std::string deflection(std::string_view axis, const StickAxis& stick) {
  const std::string percent = stick.tenths ? toText(Value::decimal(*stick.tenths, 1)) + " %" : "not valid";
  std::string text(", ");
  return text.append(axis).append(" ").append(percent);
}

std::string hexOf(Address address) {
  std::string text;
  appendHex(text, address.value, 2);
  return text;
}

}  // namespace

std::string stickJson(const State& state, Channel channel, const Joystick& stick,
                      std::string_view channelName, bool hasTimes) {
  JsonLine line;
  line.add("channel", channelName).add("address", stick.source).add("frames", stick.frames);
  line.add("timeouts", stick.timeouts).add("input_old", whyOld(state, channel, stick));
  const bool isAged = hasTimes && stick.basic.isKnown();
  line.add("input_age", isAged ? Value::decimal((state.cursor().time - stick.basic.at) / 100ms, 1) : Value());
  const auto before = whoGoesBefore(state.channel(channel).joysticks, stick);
  line.add("x_outranked_by", before[0]).add("y_outranked_by", before[1]);
  if (stick.basic.isKnown()) addFields(line, MessageId::BasicJoystick, stick.basic.frame());
  if (stick.extended.isKnown() && !isExtendedStale(state, channel, stick))
    addFields(line, MessageId::ExtendedJoystick, stick.extended.frame());
  return line.object();
}

std::string stickText(const State& state, Channel channel, const Joystick& stick,
                      std::string_view channelName, bool hasTimes) {
  std::string out = "joystick ";
  out.append(channelName).append("  address ").append(hexOf(stick.source)).append("  ");
  out += framesText(stick.frames);
  if (!stick.priority()) out += ", monitors do not listen to it by default";
  if (!stick.basic.isKnown()) return out;
  const BasicJoystick input = stick.basic.value();
  out += deflection("x", input.x) + deflection("y", input.y);
  for (std::size_t i = 0; i < input.switches.size(); ++i) {
    if (input.switches[i] == Status2::On) out += ", switch " + std::to_string(i + 1);
  }
  const auto before = whoGoesBefore(state.channel(channel).joysticks, stick);
  for (std::size_t axis = 0; axis < before.size(); ++axis) {
    if (before[axis] != kNullAddress)
      out.append(axis == 0 ? ", x" : ", y").append(" outranked by ").append(hexOf(before[axis]));
  }
  const Value why = whyOld(state, channel, stick);
  if (why.isNull()) return out;
  out += why.text() == "silence" ? ", stopped"
         : why.text() == "gap"   ? ", before the link went down"
                                 : ", link down since";
  if (hasTimes) out.append(" (").append(lengthText(state.cursor().time - stick.basic.at)).append(" old)");
  return out;
}

}  // namespace deckpipe::ctl
