// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/status_cell.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include "paint/plain_tip.h"
#include "panel/elided_label.h"
#include "panel/glyph_label.h"
#include "panel/label_ink.h"

namespace deckpipe {

std::optional<Glyph> glyphOf(StatusTone tone) {
  switch (tone) {
    case StatusTone::Plain: return {};
    case StatusTone::Idle: return Glyph::NoData;
    case StatusTone::Busy: return Glyph::Stale;
    case StatusTone::Fine: return Glyph::Fine;
    case StatusTone::Attend: return Glyph::Attend;
    case StatusTone::Fault: return Glyph::Fault;
  }
  return {};
}

QColor inkOf(StatusTone tone, const Colours& colours) {
  switch (tone) {
    case StatusTone::Plain: return colours.text;
    case StatusTone::Idle: return colours.stale.ink;
    case StatusTone::Busy: return colours.accent.ink;
    case StatusTone::Fine: return colours.fine.ink;
    case StatusTone::Attend: return colours.attend.ink;
    case StatusTone::Fault: return colours.fault.ink;
  }
  return colours.text;
}

StatusCell::StatusCell(const char* name, const QString& label, QWidget* parent)
    : QWidget(parent),
      m_colours(coloursOf(Theme::Light)),
      m_sign(new GlyphLabel(this)),
      m_words(new ElidedLabel(this)) {
  setObjectName(QLatin1String(name) + QStringLiteral("Cell"));
  setAccessibleName(label);
  setFocusPolicy(Qt::TabFocus);
  m_words->setObjectName(QLatin1String(name));
  m_words->setAccessibleName(label);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 4, 6, 4);
  row->setSpacing(6);
  row->addWidget(m_sign);
  row->addWidget(m_words, 1);
  m_sign->hide();
}

void StatusCell::setWidestText(const QString& text) {
  m_widest = text;
  m_words->setMinimumWidth(m_words->fontMetrics().horizontalAdvance(text) + 2);
}

void StatusCell::setColours(const Colours& colours) {
  m_colours = colours;
  showSign();
}

void StatusCell::setStatus(StatusTone tone, const QString& text, const QString& story,
                           std::optional<Glyph> glyph) {
  if (tone != m_tone || glyph != m_glyph) {
    m_tone = tone;
    m_glyph = glyph;
    showSign();
  }
  if (m_words->text() != text) {
    m_words->setText(text);
    setAccessibleDescription(text);
  }
  if (const QString tip = plainTip(story); toolTip() != tip) setToolTip(tip);
}

QString StatusCell::text() const { return m_words->text(); }

void StatusCell::showSign() {
  const auto glyph = m_glyph ? m_glyph : glyphOf(m_tone);
  m_sign->setVisible(glyph.has_value());
  m_sign->setGlyph(glyph, inkOf(m_tone, m_colours), m_colours.stroke);
  const bool isLoud = m_tone == StatusTone::Attend || m_tone == StatusTone::Fault;
  setInk(*m_words, isLoud ? inkOf(m_tone, m_colours) : m_colours.text);
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
  if (event->type() == QEvent::FontChange && !m_widest.isEmpty()) setWidestText(m_widest);
}

void StatusCell::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void StatusCell::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

void StatusCell::paintEvent(QPaintEvent*) {
  if (!hasFocus()) return;
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(m_colours.accent.ink, 2));
  p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
}

}  // namespace deckpipe
