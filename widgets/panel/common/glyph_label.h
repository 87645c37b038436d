// SPDX-License-Identifier: GPL-3.0-or-later
// One sign, as large as a line of text, beside the words that it belongs to. It says nothing by itself: the
// words beside it carry the same meaning for who does not see it.
#pragma once

#include <QWidget>
#include <optional>

#include "paint/glyph.h"
#include "paint/palette.h"

namespace deckpipe {

class GlyphLabel : public QWidget {
  Q_OBJECT

 public:
  explicit GlyphLabel(QWidget* parent = nullptr);

  // Nothing: the place stays empty, so that words beside it do not move.
  void setGlyph(std::optional<Glyph> glyph, Ink ink);

  QSize sizeHint() const override { return {16, 16}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<Glyph> m_glyph;
  Ink m_ink = Ink::Text;
};

}  // namespace deckpipe
