// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/untracked_label.h"

#include "model/device_rows.h"
#include "paint/app_style.h"
#include "panel/common/build.h"

namespace deckpipe {

UntrackedLabel::UntrackedLabel(const QString& objectName, QWidget* parent) : QLabel(parent) {
  setObjectName(objectName);
  setAccessibleName(tr("What is not listed"));
  setWordWrap(true);
  setMargin(8);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  setInk(*this, Ink::Warning);
  hide();
}

void UntrackedLabel::setView(const LogView& view) {
  const QString said = view.state == nullptr ? QString() : untrackedText(*view.state);
  deckpipe::setText(*this, said);
  setVisible(!said.isEmpty());
}

}  // namespace deckpipe
