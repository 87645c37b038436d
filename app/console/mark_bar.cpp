// SPDX-License-Identifier: GPL-3.0-or-later
#include "mark_bar.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>

#include "panel/common/build.h"
#include "text/time_text.h"

namespace deckpipe {

MarkBar::MarkBar(QWidget* parent)
    : QWidget(parent),
      m_label(named(new QLabel(this), "markLabel", tr("Where the mark stands"))),
      m_text(named(new QLineEdit(this), "markText", tr("Words of the mark"))) {
  named(this, "markBar", tr("Mark"));
  m_text->setPlaceholderText(tr("What happens here?"));
  m_text->setMaxLength(static_cast<int>(NoteText::kMaxBytes));
  auto* keep = makeButton(this, "markKeep", tr("Mark"), tr("Keep the mark"));
  auto* leave = makeButton(this, "markCancel", tr("Cancel"), tr("No mark"));
  inRow(this, {14, 4, 8, 4}, 8, {m_label, {m_text, 1}, keep, leave});
  setFocusProxy(m_text);
  connect(keep, &QPushButton::clicked, this, &MarkBar::keep);
  connect(leave, &QPushButton::clicked, this, &MarkBar::leave);
  connect(m_text, &QLineEdit::returnPressed, this, &MarkBar::keep);
  hide();
}

void MarkBar::open(const LogView& view) {
  m_at = view.cursor;
  m_label->setText(tr("Mark at %1:").arg(elapsedText(view.cursor.time - view.begin)));
  m_text->clear();
  show();
  m_text->setFocus();
}

void MarkBar::keep() {
  hide();
  Q_EMIT marked(m_at, m_text->text().trimmed());
}

void MarkBar::leave() { hide(); }

void MarkBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return leave();
  QWidget::keyPressEvent(event);
}

}  // namespace deckpipe
