// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/label_notes.h"

namespace deckpipe {

void LabelNotes::note(LogDocument& log, const State& state) {
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

}  // namespace deckpipe
