// SPDX-License-Identifier: GPL-3.0-or-later
#include "mark_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "text/time_text.h"

namespace deckpipe {

MarkBar::MarkBar(QWidget* parent) : QWidget(parent), m_label(new QLabel(this)), m_text(new QLineEdit(this)) {
  setObjectName(QStringLiteral("markBar"));
  setAccessibleName(tr("Mark"));
  m_label->setObjectName(QStringLiteral("markLabel"));
  m_label->setAccessibleName(tr("Where the mark stands"));
  m_text->setObjectName(QStringLiteral("markText"));
  m_text->setAccessibleName(tr("Words of the mark"));
  m_text->setPlaceholderText(tr("What happens here?"));
  m_text->setMaxLength(static_cast<int>(NoteText::kMaxBytes));
  auto* keep = new QPushButton(tr("Mark"), this);
  keep->setObjectName(QStringLiteral("markKeep"));
  keep->setAccessibleName(tr("Keep the mark"));
  auto* leave = new QPushButton(tr("Cancel"), this);
  leave->setObjectName(QStringLiteral("markCancel"));
  leave->setAccessibleName(tr("No mark"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 4, 8, 4);
  row->setSpacing(8);
  row->addWidget(m_label);
  row->addWidget(m_text, 1);
  row->addWidget(keep);
  row->addWidget(leave);
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
