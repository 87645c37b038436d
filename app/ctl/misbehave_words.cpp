// SPDX-License-Identifier: GPL-3.0-or-later
#include "misbehave_words.h"

#include <algorithm>
#include <array>

namespace deckpipe::ctl {
namespace {

using simulator::Misbehaviour;
using Takes = MisbehaveWord::Takes;
using W = WordValue;

constexpr unsigned kHour = 3'600'000;  // ms

constexpr MisbehaveWord kWords[] = {
    {"none", Takes::Nothing, 0, 0, "all is well again", [](Misbehaviour& m, const W&) { m = {}; }},
    // The device as a whole.
    {"silent", Takes::Nothing, 0, 0, "sends nothing, hears and moves on",
     [](Misbehaviour& m, const W&) { m.silent = true; }},
    {"wrong-lengths", Takes::Nothing, 0, 0, "every message is a byte short",
     [](Misbehaviour& m, const W&) { m.wrongLengths = true; }},
    {"rotation-sensor-error", Takes::Nothing, 0, 0, "monitor: rotation sensor error, code 11",
     [](Misbehaviour& m, const W&) { m.rotationSensorError = true; }},
    {"elevation-sensor-error", Takes::Nothing, 0, 0, "monitor: elevation sensor error",
     [](Misbehaviour& m, const W&) { m.elevationSensorError = true; }},
    {"not-fitted", Takes::Nothing, 0, 0, "monitor: no position feedback",
     [](Misbehaviour& m, const W&) { m.feedbackNotFitted = true; }},
    {"address-taken", Takes::Nothing, 0, 0, "a foreign NAME takes its address",
     [](Misbehaviour& m, const W&) { m.addressTaken = true; }},
    {"elsewhere", Takes::Nothing, 0, 0, "claims another address whenever it starts anew",
     [](Misbehaviour& m, const W&) { m.elsewhere = true; }},
    {"enable-off", Takes::Nothing, 0, 0, "monitor, riser: not enabled, nothing moves",
     [](Misbehaviour& m, const W&) { m.enableOff = true; }},
    {"late", Takes::Milliseconds, 150, kHour, "statuses come late",
     [](Misbehaviour& m, const W& v) { m.late = v.milliseconds(); }},
    {"jitter", Takes::Milliseconds, 80, kHour, "… and up to so much later still",
     [](Misbehaviour& m, const W& v) { m.jitter = v.milliseconds(); }},
    {"reset-takes", Takes::Milliseconds, 0, kHour, "time from a reset to the new claim",
     [](Misbehaviour& m, const W& v) { m.resetTakes = v.milliseconds(); }},
    {"reset-never", Takes::Nothing, 0, 0, "does not come back from a reset",
     [](Misbehaviour& m, const W&) { m.resetTakes = Misbehaviour::kForever; }},
    // What it says is wrong.
    {"fault", Takes::Fault, 0, 0, "a fault by its key (internal_fuse, motor_axis_1 …) or bit, 0 to 31",
     [](Misbehaviour& m, const W& v) { m.faultBits |= v.number; }},
    {"older-faults", Takes::Nothing, 0, 0, "bits 17-20 and 22, which only older manuals name",
     [](Misbehaviour& m, const W&) { m.faultBits |= simulator::kOlderFaultBits; }},
    {"fuse", Takes::Nothing, 0, 0, "fault=internal_fuse",
     [](Misbehaviour& m, const W&) { m.faultBits |= simulator::faultBit("internal_fuse"); }},
    {"motor-1", Takes::Nothing, 0, 0, "fault=motor_axis_1, which also stands still",
     [](Misbehaviour& m, const W&) { m.faultBits |= simulator::faultBit("motor_axis_1"); }},
    {"pcode", Takes::Number, 0, 65535, "pCode error code",
     [](Misbehaviour& m, const W& v) { m.pcodeError = static_cast<std::uint16_t>(v.number); }},
    // Its answers to polls and commands.
    {"answers-lost", Takes::Losses, 1, 1'000'000,
     "every N-th answer to a poll or command is lost, or K of every N",
     [](Misbehaviour& m, const W& v) { m.answers.lost = v.losses; }},
    {"answers-late", Takes::Milliseconds, 800, kHour, "answers come late",
     [](Misbehaviour& m, const W& v) { m.answers.late = v.milliseconds(); }},
    {"answers-twice", Takes::Nothing, 0, 0, "answers come twice",
     [](Misbehaviour& m, const W&) { m.answers.twice = true; }},
    {"answers-wrong-length", Takes::Nothing, 0, 0, "answers are a byte short",
     [](Misbehaviour& m, const W&) { m.answers.wrongLength = true; }},
    {"answers-wrong-source", Takes::Nothing, 0, 0, "answers come from the next address",
     [](Misbehaviour& m, const W&) { m.answers.wrongSource = true; }},
    {"older-firmware", Takes::Nothing, 0, 0, "5 bytes of fault status, without a pCode error code",
     [](Misbehaviour& m, const W&) { m.answers.shortFault = true; }},
    // Its end of the data pipe.
    {"acks-lost", Takes::Losses, 1, 1'000'000,
     "every N-th acknowledgement of the pipe is lost, or K of every N",
     [](Misbehaviour& m, const W& v) { m.pipe.acksLost = v.losses; }},
    {"ack-lost", Takes::Number, 0, 1'000'000, "the N-th acknowledgement alone is lost",
     [](Misbehaviour& m, const W& v) {
       m.pipe.acksLost = {1, v.number, true};
     }},
    {"acks-late", Takes::Milliseconds, 400, kHour, "acknowledgements of the pipe come late",
     [](Misbehaviour& m, const W& v) { m.pipe.ackLate = v.milliseconds(); }},
    {"acks-twice", Takes::Nothing, 0, 0, "acknowledgements of the pipe come twice",
     [](Misbehaviour& m, const W&) { m.pipe.ackTwice = true; }},
    {"packets-unheard", Takes::Losses, 1, 1'000'000, "packets that it neither takes nor acknowledges",
     [](Misbehaviour& m, const W& v) { m.pipe.packetsUnheard = v.losses; }},
    {"packets-lost", Takes::Losses, 1, 1'000'000, "packets of its own that never reach the bus",
     [](Misbehaviour& m, const W& v) { m.pipe.packetsLost = v.losses; }},
    {"vanish-after", Takes::Number, 0, 1'000'000, "loses its power after so many packets, once",
     [](Misbehaviour& m, const W& v) { m.pipe.vanishAfter = v.number; }},
    {"return-after", Takes::Milliseconds, 3000, kHour, "… and comes back so much later",
     [](Misbehaviour& m, const W& v) { m.pipe.returnAfter = v.milliseconds(); }},
};

std::optional<unsigned> numberIn(QStringView text, unsigned least, unsigned most) {
  bool ok = false;
  const unsigned number = text.toUInt(&ok);
  return ok && number >= least && number <= most ? std::optional(number) : std::nullopt;
}

std::optional<unsigned> faultMask(const QString& text) {
  for (const ValueName& fault : akron::kFaultBits) {
    if (text.toStdString() == fault.word) return 1u << fault.value;
  }
  const auto bit = numberIn(text, 0, 31);
  return bit ? std::optional(1u << *bit) : std::nullopt;
}

std::optional<simulator::Losses> lossesIn(const QString& text, unsigned most) {
  const qsizetype slash = text.indexOf(QLatin1Char('/'));
  const auto of = numberIn(QStringView(text).mid(slash + 1), 1, most);
  if (!of) return {};
  if (slash < 0) return simulator::Losses{1, *of};
  const auto lost = numberIn(QStringView(text).left(slash), 1, *of);
  return lost ? std::optional(simulator::Losses{*lost, *of}) : std::nullopt;
}

}  // namespace

std::span<const MisbehaveWord> misbehaveWords() { return kWords; }

const MisbehaveWord* misbehaveWord(QStringView word) {
  const auto found =
      std::ranges::find_if(kWords, [&](const MisbehaveWord& w) { return word == QLatin1String(w.word); });
  return found == std::end(kWords) ? nullptr : found;
}

std::optional<WordValue> valueFor(const MisbehaveWord& word, const QString& text) {
  WordValue value;
  if (word.takes == Takes::Nothing) return text.isNull() ? std::optional(value) : std::nullopt;
  if (text.isNull()) {
    if (word.leftOut == 0) return {};
    value.number = word.leftOut;
    value.losses = {1, word.leftOut};
    return value;
  }
  if (word.takes == Takes::Losses) {
    const auto losses = lossesIn(text, word.max);
    if (losses) value.losses = *losses;
    return losses ? std::optional(value) : std::nullopt;
  }
  const auto number = word.takes == Takes::Fault ? faultMask(text) : numberIn(text, 1, word.max);
  if (number) value.number = *number;
  return number ? std::optional(value) : std::nullopt;
}

QString valueHelp(const MisbehaveWord& word) {
  QString value;
  switch (word.takes) {
    case Takes::Nothing: return {};
    case Takes::Number: value = QStringLiteral("=N"); break;
    case Takes::Milliseconds: value = QStringLiteral("=MS"); break;
    case Takes::Losses: value = QStringLiteral("=[K/]N"); break;
    case Takes::Fault: value = QStringLiteral("=FAULT"); break;
  }
  return word.leftOut == 0 ? value : QLatin1Char('[') + value + QLatin1Char(']');
}

}  // namespace deckpipe::ctl
