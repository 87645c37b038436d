// SPDX-License-Identifier: GPL-3.0-or-later
// The person's labels of devices in the program's settings, one key a PIN. MainWindow passes one to the
// workspace, which reads it at the start and writes it at every edit.
#pragma once

#include "model/device_labels.h"

namespace deckpipe {

class SettingsLabels : public LabelStorage {
 public:
  DeviceLabels read() const override;
  void write(const DeviceLabels& labels) override;
};

}  // namespace deckpipe
