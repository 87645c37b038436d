// SPDX-License-Identifier: GPL-3.0-or-later
// One fact of the status strip: a sign, a few words, and the whole story as a tooltip, which a click or the
// keyboard brings up too, for hands in gloves cannot hover. As wide as its widest words, so that nothing
// beside it moves.
#pragma once

#include <QWidget>
#include <optional>

#include "paint/glyph.h"

namespace deckpipe {

class ElidedLabel;
class GlyphLabel;

class StatusCell : public QWidget {
  Q_OBJECT

 public:
  // `name` for tests (the words are a label called that), `label` what the fact is, for who cannot see.
  StatusCell(const char* name, const QString& label, QWidget* parent);

  // Words that it may have to show later.
  void setWidestText(const QString& text);
  // As wide as these words and a sign, whatever it shows: longer ones end in an ellipsis.
  void setFixedText(const QString& text);
  // `glyph`: instead of the severity's own. True where the cell may want another width now.
  bool setStatus(Severity tone, const QString& text, const QString& story, std::optional<Glyph> glyph = {});
  QString text() const;

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void measure();
  void showSign();
  void showStory();

  GlyphLabel* m_sign;
  ElidedLabel* m_words;
  QString m_widest;
  bool m_isFixed = false;
  QString m_story;
  Severity m_tone = Severity::Plain;
  std::optional<Glyph> m_glyph;
};

}  // namespace deckpipe
