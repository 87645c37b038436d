// SPDX-License-Identifier: GPL-3.0-or-later
// The danger question about one device, kept true while it stands open: it names the device, shows where it stands and
// who commands it, and is withdrawn with a sentence once what it asks cannot be done any more. A panel that sends has
// one and gives it every view.
#pragma once

#include <QPointer>
#include <functional>

#include "panel/common/danger_dialog.h"
#include "panel/common/panel_view.h"

namespace deckpipe {

class DeviceQuestion {
 public:
  // Asks about the chosen device of `view`, named at the end of `question.title`. The dialog belongs to `panel`.
  void ask(QWidget* panel, const PanelView& view, DangerDialog::Question question,
           std::function<void(bool isTicked)> act);
  void setView(const PanelView& view);

 private:
  QPointer<DangerDialog> m_dialog;
  DeviceKey m_device;
  Address m_address;  // where it was when the question was put
};

}  // namespace deckpipe
