// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/stick_box.h"

#include <QGridLayout>
#include <QLabel>
#include <utility>

#include "paint/app_style.h"
#include "paint/stick_view.h"
#include "panel/common/dock_title.h"

namespace deckpipe {

StickBox::StickBox(const QString& key, QWidget* parent)
    : QWidget(parent),
      m_title(new SectionTitle(this)),
      m_view(new StickView(this)),
      m_x(new QLabel(this)),
      m_y(new QLabel(this)),
      m_theta(new QLabel(this)) {
  setObjectName(key);
  setFixedWidth(kWidth);
  m_view->setObjectName(key + QStringLiteral("View"));
  m_x->setObjectName(key + QStringLiteral("X"));
  m_y->setObjectName(key + QStringLiteral("Y"));
  m_theta->setObjectName(key + QStringLiteral("Theta"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(8);
  grid->addWidget(m_title, 0, 0, 1, 2);
  grid->addWidget(m_view, 1, 0, 1, 2, Qt::AlignHCenter);
  int row = 2;
  for (const auto& [value, name] : {std::pair(m_x, tr("X")), {m_y, tr("Y")}, {m_theta, tr("Theta")}}) {
    auto* axis = new QLabel(name, this);
    axis->setObjectName(value->objectName() + QStringLiteral("Name"));
    value->setMinimumWidth(value->fontMetrics().horizontalAdvance(tr("100.0 % forward")));
    setInk(*axis, Ink::Secondary);
    if (value == m_theta) m_thetaName = axis;
    grid->addWidget(axis, row, 0, Qt::AlignRight);
    grid->addWidget(value, row++, 1);
  }
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 2);
  grid->setRowStretch(row, 1);
}

void StickBox::setStick(const PageStick& stick) {
  m_title->setTitle(stick.title);
  setAccessibleName(stick.title);
  m_title->setAge(stick.age, stick.isStale);
  m_view->setValues(stick);
  const auto show = [&](QLabel& label, const QString& name, const QString& text) {
    if (label.text() == text) return;
    label.setText(text);
    label.setAccessibleName(tr("%1: %2").arg(name, text));
  };
  show(*m_x, tr("X"), stick.xText);
  show(*m_y, tr("Y"), stick.yText);
  show(*m_theta, tr("Theta"), stick.thetaText);
  const bool hasTheta = !stick.thetaText.isEmpty();
  m_theta->setVisible(hasTheta);
  m_thetaName->setVisible(hasTheta);
  m_view->setAccessibleName(stick.title);
  m_view->setAccessibleDescription(tr("X %1, Y %2").arg(stick.xText, stick.yText));
  const Ink ink = stick.isStale ? Ink::Stale : Ink::Text;
  for (QLabel* label : {m_x, m_y, m_theta}) setInk(*label, ink);
}

}  // namespace deckpipe
