// SPDX-License-Identifier: GPL-3.0-or-later
// WHAT[=VALUE] of `--misbehave DEVICE:WHAT[=VALUE][@SECONDS]`: every word for what can go wrong on a device
// of the simulator, what its value is, and what it changes. MisbehavePlan asks for them.
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <span>

#include "simulator/misbehaviour.h"

namespace deckpipe::ctl {

struct WordValue {
  unsigned number = 0;  // a count, milliseconds, a code, a fault's mask
  simulator::Losses losses{};
  Duration milliseconds() const { return std::chrono::milliseconds(number); }
};

struct MisbehaveWord {
  enum class Takes : std::uint8_t { Nothing, Number, Milliseconds, Losses, Fault };

  const char* word;
  const char* help;
  void (*change)(simulator::Misbehaviour&, const WordValue&);
  Takes takes = Takes::Nothing;
  unsigned leftOut = 0;  // the number if none is given; 0: one must be given
  unsigned max = 0;      // of the number, in the unit of `takes`
};

std::span<const MisbehaveWord> misbehaveWords();
const MisbehaveWord* misbehaveWord(QStringView word);
// Parses the VALUE of "=VALUE"; a null text means that none was given. nullopt if the word does not take it.
std::optional<WordValue> valueFor(const MisbehaveWord& word, const QString& text);
// "=MS", "[=MS]", ""
QString valueHelp(const MisbehaveWord& word);

}  // namespace deckpipe::ctl
