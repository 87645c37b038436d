// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/adapter_row.h"

#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QPainter>
#include <QPushButton>

#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"

namespace deckpipe {

AdapterRow::AdapterRow(QWidget* parent)
    : QWidget(parent),
      m_sign(new GlyphLabel(this)),
      m_title(named(new QLabel(this), "adapterTitle", tr("Interface"))),
      m_maker(makeWords(this, "adapterMaker", tr("Adapter"), Ink::Secondary)),
      m_state(makeWords(this, "adapterState", tr("State"))),
      m_problem(makeWords(this, "adapterProblem", tr("What to do first"), Ink::Secondary)),
      m_command(makeCommand(this, "adapterCommand", tr("Command for a terminal"))),
      m_copy(makeButton(this, "adapterCopy", tr("Copy"), tr("Copy the command"))),
      m_connect(makeButton(this, "adapterConnect", tr("Connect"))) {
  setObjectName(QStringLiteral("adapterRow"));
  m_title->setFont(strongFont(m_title->font()));
  m_title->setTextFormat(Qt::PlainText);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  grid->addWidget(m_sign, 0, 0, 2, 1, Qt::AlignVCenter);
  grid->addLayout(inRow(12, {m_title, {m_maker, 1}}), 0, 1);
  grid->addWidget(m_state, 1, 1);
  grid->addWidget(m_connect, 0, 2, 2, 1, Qt::AlignVCenter);
  grid->addWidget(m_problem, 2, 1, 1, 2);
  grid->addWidget(m_command, 3, 1);
  grid->addWidget(m_copy, 3, 2);
  connect(m_connect, &QPushButton::clicked, this, &AdapterRow::connectRequested);
  connect(m_copy, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(m_offer.command); });
}

void AdapterRow::setOffer(const AdapterOffer& offer) {
  m_offer = offer;
  setText(*m_title, offer.title);
  setText(*m_maker, offer.maker);
  setText(*m_state, offer.state);
  setText(*m_problem, offer.problem);
  setText(*m_command, offer.command);
  m_problem->setVisible(!offer.problem.isEmpty());
  m_command->setVisible(!offer.command.isEmpty());
  m_copy->setVisible(!offer.command.isEmpty());
  m_connect->setEnabled(offer.canConnect);
  m_connect->setAccessibleDescription(tr("%1, %2").arg(offer.title, offer.state));
  setAccessibleName(offer.title);
  setAccessibleDescription(offer.state);
  m_sign->setGlyph(glyphOf(offer.tone), inkOf(offer.tone));
}

void AdapterRow::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(c.outline, c.stroke));
  p.setBrush(c.surface);
  p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
}

}  // namespace deckpipe
