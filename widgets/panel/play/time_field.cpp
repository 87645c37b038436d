// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/time_field.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <algorithm>

#include "model/typed_place.h"
#include "paint/app_style.h"
#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kBesideSentence = 8;

}  // namespace

TimeField::TimeField(QWidget* clock, QWidget* bar) : QLineEdit(bar), m_clock(clock) {
  named(this, "timeField", tr("Go to a time"));
  setAlignment(Qt::AlignRight);
  m_sentence = makeWords(bar, "timeFieldSentence", tr("About the time that is typed"));
  m_sentence->setFrameShape(QFrame::Box);
  m_sentence->setMargin(6);
  m_sentence->setAutoFillBackground(true);
  m_sentence->setBackgroundRole(QPalette::Base);
  hide();
  m_sentence->hide();
  connect(this, &QLineEdit::returnPressed, this, &TimeField::take);
  connect(this, &QLineEdit::textEdited, this, [this] { say(placeHelp(m_view), false); });
}

TimeField::~TimeField() { delete m_sentence; }

void TimeField::open(const QString& text) {
  setText(text);
  show();
  raise();
  say(placeHelp(m_view), false);
  setFocus(Qt::ShortcutFocusReason);
  selectAll();
}

void TimeField::place() {
  setGeometry(m_clock->geometry());
  if (!m_sentence->isVisible()) return;
  const QPoint above = m_clock->mapTo(window(), QPoint(0, 0)),
               bar = parentWidget()->mapTo(window(), QPoint(0, 0));
  const int width = std::min(m_sentence->sizeHint().width(), window()->width() - above.x() - kBesideSentence);
  const int height = m_sentence->heightForWidth(width);
  m_sentence->setGeometry(above.x(), std::max(0, bar.y() - height), width, height);
  m_sentence->raise();
}

void TimeField::say(const QString& sentence, bool isWrong) {
  setInk(*m_sentence, isWrong ? Ink::Warning : Ink::Text);
  m_sentence->setText(sentence);
  setAccessibleDescription(sentence);
  if (m_sentence->parentWidget() != window()) m_sentence->setParent(window());
  m_sentence->show();
  place();
}

void TimeField::take() {
  if (!text().trimmed().isEmpty()) {
    const auto typed = placeOf(text(), m_view);
    if (!typed) return say(typed.error(), true);
    if (const auto* frames = std::get_if<std::uint64_t>(&typed.value())) {
      Q_EMIT framesTyped(*frames);
    } else {
      Q_EMIT timeTyped(std::get<Instant>(typed.value()));
    }
  }
  hide();
  Q_EMIT done();
}

void TimeField::hideEvent(QHideEvent* event) {
  QLineEdit::hideEvent(event);
  if (m_sentence != nullptr) m_sentence->hide();
}

void TimeField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    hide();
    Q_EMIT done();
    return;
  }
  QLineEdit::keyPressEvent(event);
}

void TimeField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  const bool isLeft = event->reason() == Qt::MouseFocusReason || event->reason() == Qt::TabFocusReason ||
                      event->reason() == Qt::BacktabFocusReason;
  if (isLeft) hide();
}

}  // namespace deckpipe
