// SPDX-License-Identifier: GPL-3.0-or-later
// The sign, the tone and the words of a health, the same in the device table, on the tiles and on the page.
#pragma once

#include <QFontMetricsF>

#include "model/device_details.h"
#include "paint/glyph.h"

namespace deckpipe {

inline Glyph healthGlyph(Severity severity) {
  return severity == Severity::Unknown ? Glyph::NotAvailable : glyphOf(severity).value_or(Glyph::Unknown);
}

// As many words as have room, the worst first: "disabled, late +2".
inline QString wordsThatFit(const QStringList& words, const QFontMetricsF& metrics, double room) {
  for (qsizetype n = words.size(); n > 0; --n) {
    QString text = words.first(n).join(QStringLiteral(", "));
    if (n < words.size()) text += QStringLiteral(" +%1").arg(words.size() - n);
    if (metrics.horizontalAdvance(text) <= room) return text;
  }
  return words.isEmpty() ? QString() : metrics.elidedText(words.front(), Qt::ElideRight, room);
}

}  // namespace deckpipe
