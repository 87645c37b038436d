// SPDX-License-Identifier: GPL-3.0-or-later
// --misbehave DEVICE:WHAT[@SECONDS]: what a device of the bench twin does wrong, from when on.
#pragma once

#include <QString>
#include <vector>

#include "simulator/standard_bench.h"

namespace deckpipe::ctl {

QString misbehaveHelp();

// Options of one device add up in the order of their times.
class MisbehavePlan {
 public:
  // False where the text is not of the form, or names no device or no such thing.
  bool add(const QString& text);
  void apply(simulator::StandardBench& bench) const;

 private:
  struct Entry {
    Duration at;
    std::size_t device;
    void (*change)(simulator::Misbehaviour&);
  };
  std::vector<Entry> m_entries;
};

}  // namespace deckpipe::ctl
