// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/stops_grid.h"

#include <QGridLayout>
#include <algorithm>

#include "model/page_sources.h"
#include "paint/status_lamp.h"
#include "panel/common/build.h"
#include "panel/common/section_title.h"
#include "panel/page/lamp_grid.h"

namespace deckpipe {

StopsGrid::StopsGrid(QWidget* parent)
    : QWidget(parent), m_title(new SectionTitle(this)), m_grid(new QGridLayout(this)) {
  named(this, "stops", tr("Hard stops"));
  setToolTip(pageSourceText(QStringLiteral("stops")));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  m_title->setTitle(tr("Hard stops"));
  m_grid->setContentsMargins(0, 0, 0, 0);
  m_grid->setHorizontalSpacing(8);
  m_grid->setVerticalSpacing(0);
  m_grid->setColumnStretch(1, 1);
  m_grid->setColumnStretch(2, 1);
  m_grid->addWidget(m_title, 0, 0, 1, 3);
}

void StopsGrid::addLine() {
  const int number = static_cast<int>(m_lines.size()) + 1;
  Line line{new QLabel(this), new StatusLamp(this), new StatusLamp(this)};
  line.axis->setObjectName(QStringLiteral("stopAxis%1").arg(number));
  line.minus->setObjectName(QStringLiteral("stopMinus%1").arg(number));
  line.plus->setObjectName(QStringLiteral("stopPlus%1").arg(number));
  m_grid->addWidget(line.axis, number, 0);
  m_grid->addWidget(line.minus, number, 1);
  m_grid->addWidget(line.plus, number, 2);
  m_lines.push_back(line);
}

void StopsGrid::setStops(const PageStops& stops) {
  m_title->setAge(stops.age, stops.isStale);
  while (m_lines.size() < stops.axes.size()) addLine();
  const bool isSame = m_stops.axes == stops.axes && m_stops.isStale == stops.isStale;
  m_stops = stops;
  if (isSame) return;
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    const bool isUsed = i < stops.axes.size();
    m_lines[i].axis->setVisible(isUsed);
    m_lines[i].minus->setVisible(isUsed);
    m_lines[i].plus->setVisible(isUsed);
    if (!isUsed) continue;
    const PageStop& stop = stops.axes[i];
    m_lines[i].axis->setText(stop.axis);
    m_lines[i].axis->setToolTip(stop.remark);
    setLamp(*m_lines[i].minus, stop.minus, stops.isStale, QStringLiteral("stops"));
    setLamp(*m_lines[i].plus, stop.plus, stops.isStale, QStringLiteral("stops"));
  }
  // The side with the longer names has more of the width: its words need the room beside them.
  int minus = 1, plus = 1;
  for (std::size_t i = 0; i < stops.axes.size(); ++i) {
    minus = std::max(minus, m_lines[i].minus->sizeHint().width());
    plus = std::max(plus, m_lines[i].plus->sizeHint().width());
  }
  m_grid->setColumnStretch(1, minus);
  m_grid->setColumnStretch(2, plus);
}

}  // namespace deckpipe
