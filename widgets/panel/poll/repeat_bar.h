// SPDX-License-Identifier: GPL-3.0-or-later
// Every poll that is repeated, of whatever device, and the one button that ends them all: a repeated poll
// would otherwise be seen on its own device alone. Part of the request panel; hidden while there is none.
#pragma once

#include <QWidget>

#include "control/status.h"
#include "model/device_labels.h"

class QLabel;

namespace deckpipe {

class RepeatBar : public QWidget {
  Q_OBJECT

 public:
  explicit RepeatBar(QWidget* parent = nullptr);

  void setStatus(const ServiceStatus& services, const DeviceLabels& labels);

 Q_SIGNALS:
  void endRequested();

 private:
  QLabel* m_text;
};

}  // namespace deckpipe
