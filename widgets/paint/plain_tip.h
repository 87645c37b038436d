// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of a log as tooltips. Qt takes a tooltip that looks like HTML for HTML, and what came over a bus or
// out of a file must be shown as it is, never interpreted.
#pragma once

#include <QString>

namespace deckpipe {

inline QString plainTip(const QString& text) {
  return QStringLiteral("<span style=\"white-space: pre\">%1</span>").arg(text.toHtmlEscaped());
}

}  // namespace deckpipe
