// SPDX-License-Identifier: GPL-3.0-or-later
#include "misbehave_words.h"

#include <algorithm>
#include <array>

namespace deckpipe::ctl {
namespace {

using M = simulator::Misbehaviour;
using Takes = MisbehaveWord::Takes;
using W = WordValue;

constexpr unsigned kHour = 3'600'000;  // ms

constexpr MisbehaveWord kWords[] = {
    {"none", "all is well again", [](M& m, const W&) { m = {}; }},
    // The device as a whole.
    {"silent", "sends nothing, hears and moves on", [](M& m, const W&) { m.silent = true; }},
    {"wrong-lengths", "every message is a byte short", [](M& m, const W&) { m.wrongLengths = true; }},
    {"rotation-sensor-error", "monitor: rotation sensor error, code 11",
     [](M& m, const W&) { m.rotationSensorError = true; }},
    {"elevation-sensor-error", "monitor: elevation sensor error",
     [](M& m, const W&) { m.elevationSensorError = true; }},
    {"not-fitted", "monitor: no position feedback", [](M& m, const W&) { m.feedbackNotFitted = true; }},
    {"address-taken", "a foreign NAME takes its address", [](M& m, const W&) { m.addressTaken = true; }},
    {"elsewhere", "claims another address whenever it starts anew",
     [](M& m, const W&) { m.elsewhere = true; }},
    {"enable-off", "monitor, riser: not enabled, nothing moves", [](M& m, const W&) { m.enableOff = true; }},
    {"late", "statuses come late", [](M& m, const W& v) { m.late = v.milliseconds(); }, Takes::Milliseconds,
     150, kHour},
    {"jitter", "… and up to so much later still", [](M& m, const W& v) { m.jitter = v.milliseconds(); },
     Takes::Milliseconds, 80, kHour},
    {"reset-takes", "time from a reset to the new claim",
     [](M& m, const W& v) { m.resetTakes = v.milliseconds(); }, Takes::Milliseconds, 0, kHour},
    {"reset-never", "does not come back from a reset", [](M& m, const W&) { m.resetTakes = M::kForever; }},
    // What it says is wrong.
    {"fault", "a fault by its key (internal_fuse, motor_axis_1 …) or bit, 0 to 31",
     [](M& m, const W& v) { m.faultBits |= v.number; }, Takes::Fault, 0, 0},
    {"older-faults", "bits 17-20 and 22, which only older manuals name",
     [](M& m, const W&) { m.faultBits |= simulator::kOlderFaultBits; }},
    {"fuse", "fault=internal_fuse",
     [](M& m, const W&) { m.faultBits |= simulator::faultBit("internal_fuse"); }},
    {"motor-1", "fault=motor_axis_1, which also stands still",
     [](M& m, const W&) { m.faultBits |= simulator::faultBit("motor_axis_1"); }},
    {"pcode", "pCode error code",
     [](M& m, const W& v) { m.pcodeError = static_cast<std::uint16_t>(v.number); }, Takes::Number, 0, 65535},
    // Its answers to polls and commands.
    {"answers-lost", "every N-th answer to a poll or command is lost, or K of every N",
     [](M& m, const W& v) { m.answers.lost = v.losses; }, Takes::Losses, 1, 1'000'000},
    {"answers-late", "answers come late", [](M& m, const W& v) { m.answers.late = v.milliseconds(); },
     Takes::Milliseconds, 800, kHour},
    {"answers-twice", "answers come twice", [](M& m, const W&) { m.answers.twice = true; }},
    {"answers-wrong-length", "answers are a byte short",
     [](M& m, const W&) { m.answers.wrongLength = true; }},
    {"answers-wrong-source", "answers come from the next address",
     [](M& m, const W&) { m.answers.wrongSource = true; }},
    {"older-firmware", "5 bytes of fault status, without a pCode error code",
     [](M& m, const W&) { m.answers.shortFault = true; }},
    // Its end of the data pipe.
    {"acks-lost", "every N-th acknowledgement of the pipe is lost, or K of every N",
     [](M& m, const W& v) { m.pipe.acksLost = v.losses; }, Takes::Losses, 1, 1'000'000},
    {"ack-lost", "the N-th acknowledgement alone is lost",
     [](M& m, const W& v) {
       m.pipe.acksLost = {1, v.number, true};
     },
     Takes::Number, 0, 1'000'000},
    {"acks-late", "acknowledgements of the pipe come late",
     [](M& m, const W& v) { m.pipe.ackLate = v.milliseconds(); }, Takes::Milliseconds, 400, kHour},
    {"acks-twice", "acknowledgements of the pipe come twice", [](M& m, const W&) { m.pipe.ackTwice = true; }},
    {"packets-unheard", "packets that it neither takes nor acknowledges",
     [](M& m, const W& v) { m.pipe.packetsUnheard = v.losses; }, Takes::Losses, 1, 1'000'000},
    {"packets-lost", "packets of its own that never reach the bus",
     [](M& m, const W& v) { m.pipe.packetsLost = v.losses; }, Takes::Losses, 1, 1'000'000},
    {"vanish-after", "loses its power after so many packets, once",
     [](M& m, const W& v) { m.pipe.vanishAfter = v.number; }, Takes::Number, 0, 1'000'000},
    {"return-after", "… and comes back so much later",
     [](M& m, const W& v) { m.pipe.returnAfter = v.milliseconds(); }, Takes::Milliseconds, 3000, kHour},
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
