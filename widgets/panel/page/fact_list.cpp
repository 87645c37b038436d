// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/fact_list.h"

#include <QEvent>
#include <QGridLayout>
#include <algorithm>

#include "model/page_sources.h"
#include "paint/app_style.h"
#include "paint/severity_look.h"
#include "panel/common/build.h"
#include "panel/common/labels.h"
#include "panel/common/section_title.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

// A count that runs, for instance: everything else that a person reads is the same.
bool differInFiguresOnly(const PageFactGroup& a, const PageFactGroup& b) {
  const auto words = [](QString text) {
    text.removeIf([](QChar c) { return !c.isLetter(); });
    return text;
  };
  const auto isAlike = [&](const PageFact& x, const PageFact& y) {
    PageFact same = y;
    same.value = x.value;
    same.age = x.age;
    return same == x && x.age.has_value() == y.age.has_value() && words(x.value) == words(y.value);
  };
  return a.key == b.key && a.title == b.title && std::ranges::equal(a.facts, b.facts, isAlike);
}

// Figures that change more often cannot be read, and each change lays the page out anew.
constexpr std::chrono::milliseconds kFiguresCalm{250};

}  // namespace

FactList::FactList(QWidget* parent)
    : QWidget(parent), m_title(new SectionTitle(this)), m_grid(new QGridLayout(this)) {
  m_grid->setContentsMargins(0, 0, 0, 0);
  m_grid->setHorizontalSpacing(8);
  m_grid->setVerticalSpacing(8);
  m_grid->setColumnStretch(2, 1);
  m_grid->addWidget(m_title, 0, 0, 1, 4);
  m_calm.setSingleShot(true);
  connect(&m_calm, &QTimer::timeout, this, [this] {
    if (m_heldBack) setGroup(PageFactGroup(*m_heldBack));
  });
}

void FactList::addLine() {
  const int row = static_cast<int>(m_lines.size()) + 1;
  Line line{new GlyphLabel(this), new QLabel(this), new QLabel(this), new QLabel(this)};
  line.value->setWordWrap(true);
  line.value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  line.age->setAlignment(Qt::AlignRight);
  fitAge(*line.age);
  for (QLabel* label : {line.label, line.age}) setInk(*label, Ink::Secondary);
  m_grid->addWidget(line.sign, row, 0, Qt::AlignTop);
  m_grid->addWidget(line.label, row, 1, Qt::AlignTop | Qt::AlignLeft);
  m_grid->addWidget(line.value, row, 2, Qt::AlignTop);
  m_grid->addWidget(line.age, row, 3, Qt::AlignTop | Qt::AlignRight);
  m_lines.push_back(line);
}

// Room for every age, and that alone: a running one lays nothing out anew.
void FactList::fitAge(QLabel& age) { age.setFixedSize(widestAge(age.font()), age.fontMetrics().height()); }

void FactList::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  for (const Line& line : m_lines) fitAge(*line.age);
}

void FactList::setGroup(const PageFactGroup& group) {
  if (m_calm.isActive() && differInFiguresOnly(group, m_group)) {
    m_heldBack = group;
    return;
  }
  m_heldBack.reset();
  if (group == m_group) return;
  m_calm.start(kFiguresCalm);
  if (group.key != m_group.key) {
    setObjectName(group.key + QStringLiteral("Facts"));
    for (std::size_t i = 0; i < m_lines.size(); ++i)
      m_lines[i].value->setObjectName(QStringLiteral("%1Fact%2").arg(group.key).arg(i + 1));
  }
  setAccessibleName(group.title);
  setToolTip(pageSourceText(group.key));
  m_title->setTitle(group.title);
  while (m_lines.size() < group.facts.size()) {
    addLine();
    m_lines.back().value->setObjectName(QStringLiteral("%1Fact%2").arg(group.key).arg(m_lines.size()));
  }
  const bool hasAges = std::ranges::any_of(group.facts, [](const PageFact& f) { return f.age.has_value(); });
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    const Line& line = m_lines[i];
    const bool isUsed = i < group.facts.size();
    line.sign->setVisible(isUsed);
    line.label->setVisible(isUsed);
    line.value->setVisible(isUsed);
    line.age->setVisible(isUsed && hasAges);
    if (isUsed) show(line, group.facts[i]);
  }
  // The page may lay itself out before this list's own layout gets to know of its labels.
  const bool hasOtherLines =
      !std::ranges::equal(group.facts, m_group.facts, {}, &PageFact::value, &PageFact::value);
  m_group = group;
  if (hasOtherLines) updateGeometry();
}

void FactList::show(const Line& line, const PageFact& fact) {
  line.sign->setGlyph(glyphOf(fact.tone), inkOf(fact.tone));
  setText(*line.label, fact.label);
  setText(*line.value, fact.value);
  setText(*line.age, fact.age ? calmAge(*fact.age) : QString());
  setInk(*line.value, inkOf(fact.tone));
  line.value->setAccessibleName(tr("%1: %2").arg(fact.label, fact.value));
}

}  // namespace deckpipe
