// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/poll/request_card.h"

#include <QGridLayout>
#include <QPushButton>

#include "paint/app_style.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "panel/common/tick_box.h"
#include "text/service_text.h"

namespace deckpipe {
namespace {

constexpr int kButtonWidth = 96, kCommandLines = 2;

}  // namespace

RequestCard::RequestCard(Request request, QWidget* parent)
    : QWidget(parent),
      m_request(request),
      m_answer(makeWords(this, "askAnswer", tr("Last answer: %1").arg(requestText(request)))),
      m_sign(new GlyphLabel(this)),
      m_state(makeWords(this, "askState", tr("State: %1").arg(requestText(request)))),
      m_button(isCommand(request) ? new WarningButton(tr("%1…").arg(requestText(request)), this)
                                  : new QPushButton(tr("Ask"), this)) {
  const QString name = requestText(request);
  setObjectName(QStringLiteral("askCard%1").arg(static_cast<int>(request)));
  setAccessibleName(name);
  auto* title = new QLabel(name, this);
  title->setFont(boldFont(title->font()));
  m_answer->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_state->setFont(secondaryFont(font()));
  named(m_button, "askButton", isCommand(request) ? m_button->text() : tr("Ask: %1").arg(name));
  m_verb = m_button->text();
  connect(m_button, &QPushButton::clicked, this, &RequestCard::pressed);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setHorizontalSpacing(8);
  layout->setVerticalSpacing(2);
  // A first answer, a longer state and another word on the button move nothing.
  if (isCommand(request)) {
    m_answer->hide();
    m_state->setMinimumHeight(kCommandLines * m_state->fontMetrics().lineSpacing());
    m_state->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    layout->addWidget(title, 0, 0, 1, 2);
    layout->addWidget(m_button, 1, 0, 1, 2);
  } else {
    m_answer->setMinimumHeight(m_answer->fontMetrics().lineSpacing());
    m_button->setMinimumWidth(kButtonWidth);
    layout->addWidget(title, 0, 0, 1, 2);
    layout->addWidget(m_answer, 1, 0, 1, 2);
    layout->addWidget(m_button, 0, 2, 2, 1, Qt::AlignTop);
  }
  layout->addWidget(m_sign, 2, 0, Qt::AlignTop);
  layout->addWidget(m_state, 2, 1);
  layout->setColumnStretch(1, 1);
  showState();
}

void RequestCard::setValues(const Values& values) {
  if (values == m_values) return;
  m_values = values;
  showState();
}

void RequestCard::showState() {
  const bool isPlain = m_values.tone == Severity::Plain;
  const Severity shown = isPlain && m_values.isOld ? Severity::Silent : m_values.tone;
  const Ink ink = shown == Severity::Plain ? Ink::Secondary : inkOf(shown);
  m_sign->setGlyph(glyphOf(shown), ink);
  m_sign->setVisible(glyphOf(shown).has_value());
  setInk(*m_state, ink);
  setText(*m_state, m_values.state);
  setText(*m_answer, m_values.answer);
  setInk(*m_answer, m_values.isOld ? Ink::Stale : m_values.isFault ? Ink::Fault : Ink::Text);
  const QString verb = m_values.isBehindLock ? tr("Unlock and ask: %1…").arg(requestText(m_request)) : m_verb;
  if (isCommand(m_request) && m_button->text() != verb) {
    m_button->setText(verb);
    m_button->setAccessibleName(verb);
  }
  m_button->setEnabled(m_values.isOffered || m_values.isBehindLock);
}

}  // namespace deckpipe
