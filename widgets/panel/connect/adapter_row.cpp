// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/connect/adapter_row.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "paint/app_style.h"
#include "panel/common/glyph_label.h"
#include "panel/common/label_text.h"

namespace deckpipe {

AdapterRow::AdapterRow(QWidget* parent)
    : QWidget(parent),
      m_sign(new GlyphLabel(this)),
      m_title(new QLabel(this)),
      m_maker(new QLabel(this)),
      m_state(new QLabel(this)),
      m_problem(new QLabel(this)),
      m_command(new QLabel(this)),
      m_copy(new QPushButton(tr("Copy"), this)),
      m_connect(new QPushButton(tr("Connect"), this)) {
  setObjectName(QStringLiteral("adapterRow"));
  const auto name = [](QWidget* widget, const char* objectName, const QString& accessibleName) {
    widget->setObjectName(QLatin1String(objectName));
    widget->setAccessibleName(accessibleName);
  };
  name(m_title, "adapterTitle", tr("Interface"));
  name(m_maker, "adapterMaker", tr("Adapter"));
  name(m_state, "adapterState", tr("State"));
  name(m_problem, "adapterProblem", tr("What to do first"));
  name(m_command, "adapterCommand", tr("Command for a terminal"));
  name(m_copy, "adapterCopy", tr("Copy the command"));
  name(m_connect, "adapterConnect", tr("Connect"));
  QFont strong = m_title->font();
  strong.setWeight(QFont::DemiBold);
  m_title->setFont(strong);
  for (QLabel* label : {m_title, m_maker, m_state, m_problem, m_command}) label->setTextFormat(Qt::PlainText);
  for (QLabel* label : {m_maker, m_state, m_problem, m_command}) label->setWordWrap(true);
  for (QLabel* label : {m_maker, m_problem}) setInk(*label, Ink::Secondary);
  m_command->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_command->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  head->addWidget(m_title);
  head->addWidget(m_maker, 1);
  grid->addWidget(m_sign, 0, 0, 2, 1, Qt::AlignVCenter);
  grid->addLayout(head, 0, 1);
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
