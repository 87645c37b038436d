// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/lamp_grid.h"

#include <algorithm>

#include "model/page_sources.h"
#include "paint/status_lamp.h"
#include "panel/common/section_title.h"

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

}  // namespace deckpipe
