// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/status_cell.h"

#include <QEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include "paint/app_style.h"
#include "paint/plain_tip.h"
#include "paint/spoken.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"

namespace deckpipe {

StatusCell::StatusCell(const char* name, const QString& label, QWidget* parent)
    : QWidget(parent), m_sign(new GlyphLabel(this)), m_words(new ElidedLabel(this)) {
  speakAs(*this, QAccessible::StaticText);
  setObjectName(QLatin1String(name) + QStringLiteral("Cell"));
  setAccessibleName(label);
  setFocusPolicy(Qt::TabFocus);
  named(m_words, name, label);
  inRow(this, {6, 4, 6, 4}, 6, {m_sign, {m_words, 1}});
  m_sign->hide();
}

void StatusCell::setWidestText(const QString& text) {
  m_widest = text;
  measure();
}

void StatusCell::setFixedText(const QString& text) {
  m_isFixed = true;
  QSizePolicy kept = m_sign->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  m_sign->setSizePolicy(kept);
  setWidestText(text);
}

void StatusCell::measure() {
  const int width = m_words->fontMetrics().horizontalAdvance(m_widest) + 2;
  m_words->setMinimumWidth(width);
  if (m_isFixed) m_words->setMaximumWidth(width);
}

bool StatusCell::setStatus(Severity tone, const QString& text, const QString& story,
                           std::optional<Glyph> glyph) {
  const bool isOtherSign = tone != m_tone || glyph != m_glyph;
  if (isOtherSign) {
    m_tone = tone;
    m_glyph = glyph;
    showSign();
  }
  const bool isOtherText = m_words->text() != text;
  if (isOtherText) {
    m_words->setText(text);
    setAccessibleDescription(text);
  }
  if (m_story != story) {
    m_story = story;
    setToolTip(plainTip(story));
  }
  return isOtherSign || isOtherText;
}

QString StatusCell::text() const { return m_words->text(); }

void StatusCell::showSign() {
  const auto glyph = m_glyph ? m_glyph : glyphOf(m_tone);
  m_sign->setVisible(glyph.has_value());
  m_sign->setGlyph(glyph, inkOf(m_tone));
  const bool isLoud = m_tone == Severity::Warning || m_tone == Severity::Fault;
  setInk(*m_words, isLoud ? inkOf(m_tone) : Ink::Text);
}

void StatusCell::showStory() { QToolTip::showText(mapToGlobal(QPoint(0, height())), toolTip(), this); }

void StatusCell::mousePressEvent(QMouseEvent*) { showStory(); }

void StatusCell::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) return showStory();
  QWidget::keyPressEvent(event);
}

void StatusCell::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange && !m_widest.isEmpty()) measure();
}

void StatusCell::paintEvent(QPaintEvent*) {
  if (!hasFocus()) return;
  QPainter p(this);
  drawFocusRing(p, coloursOf(this), rect());
}

}  // namespace deckpipe
