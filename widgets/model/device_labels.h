// SPDX-License-Identifier: GPL-3.0-or-later
// What a person calls the devices: a label a PIN, for it is the device that has a name, not its address. The
// console keeps one, gives it to whatever names a device and stores it when a label was edited.
#pragma once

#include <QMap>
#include <QString>

#include "base/ids.h"
#include "log/note_store.h"

namespace deckpipe {

class DeviceLabels {
 public:
  static constexpr int kLongest = 48;  // characters

  // Empty where there is none.
  QString of(const Pin& pin) const;
  // The same; what has no PIN has no label.
  QString of(const DeviceKey& key) const;
  // One line without space around it, at most kLongest; an empty one takes the label away. False where that
  // changes nothing.
  bool set(const Pin& pin, const QString& label);

  // Takes those of others where there is none.
  void fillFrom(const DeviceLabels& others);

  // By PIN text.
  const QMap<QString, QString>& all() const { return m_byPin; }
  friend bool operator==(const DeviceLabels&, const DeviceLabels&) = default;

 private:
  QMap<QString, QString> m_byPin;
};

// What a log's notes call its devices: labels of whoever saved it.
DeviceLabels labelsIn(const NoteStore& notes);

// Where labels stay between runs of the program. The console passes one in; a test its own.
class LabelStorage {
 public:
  virtual ~LabelStorage() = default;
  virtual DeviceLabels read() const = 0;
  virtual void write(const DeviceLabels& labels) = 0;
};

}  // namespace deckpipe
