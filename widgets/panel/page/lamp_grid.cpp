// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/lamp_grid.h"

#include <QGridLayout>

#include <algorithm>

#include "model/page_sources.h"
#include "paint/status_lamp.h"
#include "panel/common/build.h"
#include "panel/common/dock_title.h"

namespace deckpipe {
namespace {

constexpr int kColumnGap = 16;  // between columns
constexpr int kNarrowest = 168;
constexpr int kUsual = 208;  // the same for neighbouring groups, so that their words line up

}  // namespace

void setLamp(StatusLamp& lamp, const PageLamp& values, bool isStale, const QString& groupKey) {
  lamp.setLabel(values.label, values.spoken);
  const QString source = pageSourceText(groupKey);
  lamp.setToolTip(values.spoken.isEmpty() ? source : values.spoken + QStringLiteral("\n\n") + source);
  lamp.setWhenOn(values.whenOn, values.sign);
  lamp.setState(values.state, isStale);
}

LampGrid::LampGrid(QWidget* parent) : QWidget(parent), m_title(new SectionTitle(this)) {
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void LampGrid::setGroup(const PageLampGroup& group) {
  m_title->setTitle(group.title, group.remark);
  m_title->setAge(group.age, group.isStale);
  setObjectName(group.key + QStringLiteral("Lamps"));
  setAccessibleName(group.title);
  setToolTip(pageSourceText(group.key));
  const bool isOther = m_lamps.size() != group.lamps.size();
  while (m_lamps.size() > group.lamps.size()) {
    delete m_lamps.back();
    m_lamps.pop_back();
  }
  while (m_lamps.size() < group.lamps.size()) {
    auto* lamp = new StatusLamp(this);
    lamp->show();
    m_lamps.push_back(lamp);
  }
  for (std::size_t i = 0; i < m_lamps.size(); ++i) {
    if (!isOther && i < m_group.lamps.size() && m_group.lamps[i] == group.lamps[i] &&
        m_group.isStale == group.isStale)
      continue;
    setLamp(*m_lamps[i], group.lamps[i], group.isStale, group.key);
    m_lamps[i]->setObjectName(QStringLiteral("%1Lamp%2").arg(group.key).arg(i + 1));
  }
  m_group = group;
  if (!isOther) return;
  updateGeometry();
  layOut();
}

// As wide as the widest label with its word wants, so that columns of one group line up.
int LampGrid::columns(int width) const {
  int widest = kNarrowest;
  for (const StatusLamp* lamp : m_lamps) widest = std::max(widest, lamp->sizeHint().width() - 56);
  const int fitting = std::max(1, (width + kColumnGap) / (widest + kColumnGap));
  return std::min(fitting, std::max(1, static_cast<int>(m_lamps.size())));
}

int LampGrid::lampHeight() const { return m_lamps.empty() ? 32 : m_lamps.front()->sizeHint().height(); }

int LampGrid::heightForWidth(int width) const {
  const int count = static_cast<int>(m_lamps.size());
  const int perRow = columns(width);
  return m_title->sizeHint().height() + (count + perRow - 1) / perRow * lampHeight();
}

QSize LampGrid::sizeHint() const {
  return {2 * kNarrowest + kColumnGap, heightForWidth(2 * kNarrowest + kColumnGap)};
}

QSize LampGrid::minimumSizeHint() const { return {kNarrowest, m_title->sizeHint().height() + lampHeight()}; }

void LampGrid::resizeEvent(QResizeEvent*) { layOut(); }

void LampGrid::layOut() {
  const int perRow = columns(width());
  const int top = m_title->sizeHint().height();
  const int pitch = (width() + kColumnGap) / perRow;
  // A word far from its label is hard to follow.
  int widest = kUsual;
  for (const StatusLamp* lamp : m_lamps) widest = std::max(widest, lamp->sizeHint().width());
  const int lampWidth = std::min(pitch - kColumnGap, widest);
  m_title->setGeometry(0, 0, width(), top);
  // Down the columns: what belongs together stays together.
  const int count = static_cast<int>(m_lamps.size());
  const int rows = (count + perRow - 1) / perRow;
  for (int i = 0; i < count; ++i) {
    m_lamps[static_cast<std::size_t>(i)]->setGeometry(i / rows * pitch, top + i % rows * lampHeight(),
                                                      lampWidth, lampHeight());
  }
}

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
