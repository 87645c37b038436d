// SPDX-License-Identifier: GPL-3.0-or-later
// --misbehave DEVICE:WHAT[=VALUE][@SECONDS]: what a device of the simulator does wrong, or when it loses its
// power or is reset, from when on. simulateCommand collects the options and applies them before it starts.
#pragma once

#include <QString>
#include <vector>

#include "misbehave_words.h"
#include "simulator/standard_simulator.h"

namespace deckpipe::ctl {

// Everything that the option takes.
QString misbehaveTable();

// Options of one device add up in the order of their times; "none" ends them.
class MisbehavePlan {
 public:
  explicit MisbehavePlan(unsigned monitors) : m_monitors(monitors) {}

  // False where the text is not of the form, or names no device or no such thing.
  bool add(const QString& text);
  void apply(simulator::StandardSimulator& simulator) const;

 private:
  struct Entry {
    Duration at{0};
    std::vector<std::size_t> devices;
    const MisbehaveWord* word = nullptr;  // null: a button
    WordValue value{};
    simulator::Simulator::Button button{};
  };
  std::vector<std::size_t> devicesOf(const QString& name) const;
  bool addWhat(Entry entry, const QString& what, const QString& value);

  unsigned m_monitors;
  std::vector<Entry> m_entries;
};

}  // namespace deckpipe::ctl
