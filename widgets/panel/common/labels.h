// SPDX-License-Identifier: GPL-3.0-or-later
// Small labels of panels and bars.
#pragma once

#include <QLabel>
#include <QWidget>

#include <optional>

#include "paint/glyph.h"
#include "paint/palette.h"
#include "state/log_view.h"

namespace deckpipe {

// A label of one line that ends in an ellipsis where there is too little room, instead of in half a letter.
// Its text stays whole for tooltips, screen readers and tests.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr, Qt::TextElideMode mode = Qt::ElideRight);

  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Qt::TextElideMode m_mode;
};

// One sign, as large as a line of text, beside the words that it belongs to. It says nothing by itself: the
// words beside it carry the same meaning for who does not see it.
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

// The line under a list of devices that says what was heard and is not listed, as there is too much of it.
// Hidden where there is nothing to say.
class UntrackedLabel : public QLabel {
  Q_OBJECT
 public:
  UntrackedLabel(const QString& objectName, QWidget* parent);
  void setView(const LogView& view);
};

}  // namespace deckpipe
