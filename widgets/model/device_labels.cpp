// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/device_labels.h"

#include "model/field_text.h"
#include "text/device_text.h"

namespace deckpipe {

QString DeviceLabels::of(const Pin& pin) const { return m_byPin.value(pinText(pin)); }

QString DeviceLabels::of(const DeviceKey& key) const {
  return key.kind == DeviceKey::Kind::Pin ? of(key.pin) : QString();
}

bool DeviceLabels::set(const Pin& pin, const QString& label) {
  const QString text = label.simplified().left(kLongest);
  if (pin.isNull() || text == of(pin)) return false;
  if (text.isEmpty()) {
    m_byPin.remove(pinText(pin));
  } else {
    m_byPin.insert(pinText(pin), text);
  }
  return true;
}

void DeviceLabels::fillFrom(const DeviceLabels& others) {
  for (auto label = others.m_byPin.cbegin(); label != others.m_byPin.cend(); ++label) {
    if (!m_byPin.contains(label.key())) m_byPin.insert(label.key(), label.value());
  }
}

DeviceLabels labelsIn(const NoteStore& notes) {
  DeviceLabels labels;
  for (const Note& note : notes.all()) {
    if (const auto* label = std::get_if<note::Label>(&note.value))
      labels.set(label->pin, toQString(label->text.str()));
  }
  return labels;
}

}  // namespace deckpipe
