// SPDX-License-Identifier: GPL-3.0-or-later
// The line under a list of devices that says what was heard and is not listed, as there is too much of it.
// Hidden where there is nothing to say.
#pragma once

#include <QLabel>

#include "state/log_view.h"

namespace deckpipe {

class UntrackedLabel : public QLabel {
  Q_OBJECT
 public:
  UntrackedLabel(const QString& objectName, QWidget* parent);
  void setView(const LogView& view);
};

}  // namespace deckpipe
