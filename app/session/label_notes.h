// SPDX-License-Identifier: GPL-3.0-or-later
// Notes in the log of a link what the person calls its devices: a label once its device has said its PIN, and each edit
// of it from then on. So a recording has the labels from there on, whatever ends it. The session owns this.
#pragma once

#include "session/part_writer.h"
#include "state/log_view.h"

namespace deckpipe {

class LabelNotes {
 public:
  void set(LabelsByPin labels) { m_labels = std::move(labels); }
  // A log without a label yet is open from now on.
  void begin() { m_noted.clear(); }
  // Notes at the place of the log's live state what is not noted yet. No label any more is noted as an empty one.
  void note(LogDocument& log, const State& state) {
    if (m_labels.empty() && m_noted.empty()) return;
    for (const Device& device : state.devices().all()) {
      if (device.kind != Device::Kind::Pin) continue;
      const auto wanted = m_labels.find(device.pin);
      const std::string label = wanted == m_labels.end() ? std::string() : wanted->second;
      const auto noted = m_noted.try_emplace(device.pin).first;
      if (noted->second == label) continue;
      noted->second = label;
      const Cursor end = state.cursor();
      log.notes.append({.frame = end.frames, .time = end.time, .value = note::Label{device.pin, label}});
    }
  }

 private:
  LabelsByPin m_labels;  // the person's
  LabelsByPin m_noted;   // in the open log
};

}  // namespace deckpipe
