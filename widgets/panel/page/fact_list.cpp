// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/fact_list.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

#include "model/page_sources.h"
#include "paint/app_style.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "panel/common/dock_title.h"
#include "panel/common/health_look.h"
#include "panel/common/labels.h"
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

namespace {

constexpr int kKept = 2;  // lines
constexpr int kSignRoom = 24;
constexpr int kSlack = 2;  // a label breaks a line a pixel before its end

}  // namespace

FaultLines::FaultLines(QWidget* parent)
    : QWidget(parent), m_more(makeToolButton(this, "moreReasons", {}, tr("All that is said of its health"))) {
  named(this, "faultLines", tr("Health in words"));
  setToolTip(pageSourceText(pageGroupKey(PageGroup::Health)));
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  connect(m_more, &QAbstractButton::clicked, this, [this] {
    m_isUnfolded = !m_isUnfolded;
    updateGeometry();
    arrange();
  });
}

void FaultLines::addLine() {
  Line line{new GlyphLabel(this), new QLabel(this)};
  line.words->setObjectName(QStringLiteral("reason%1").arg(m_lines.size() + 1));
  line.words->setTextFormat(Qt::PlainText);
  line.words->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  line.words->setWordWrap(true);
  line.words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_lines.push_back(line);
}

void FaultLines::setReasons(const std::vector<PageReason>& reasons) {
  if (reasons == m_reasons) return;
  const bool isAsHigh = reasons.size() == m_reasons.size() && !m_isUnfolded;
  m_reasons = reasons;
  while (m_lines.size() < reasons.size()) addLine();
  QStringList all;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    const Ink ink = inkOf(reasons[i].tone);
    m_lines[i].sign->setGlyph(healthGlyph(reasons[i].tone), ink);
    m_lines[i].words->setAccessibleName(reasons[i].text);
    m_lines[i].words->setToolTip(reasons[i].advice.isEmpty()
                                     ? reasons[i].text
                                     : reasons[i].text + QLatin1Char('\n') + reasons[i].advice);
    setInk(*m_lines[i].words, ink);
    all << reasons[i].text;
  }
  setAccessibleDescription(all.join(QLatin1Char(' ')));
  if (!isAsHigh) updateGeometry();
  arrange();
}

int FaultLines::lineHeight() const { return std::max(20, fontMetrics().height() + 2); }

int FaultLines::foldedHeight() const { return std::max(kKept * lineHeight(), targetHeight(this)); }

int FaultLines::wrappedHeight(const QString& text, int width) const {
  const QRect room(0, 0, std::max(1, width - kSignRoom - kSlack), 10'000);
  return std::max(lineHeight(), fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height());
}

// As much as both lines hold.
QString FaultLines::elidedLines(const QString& text, int width) const {
  qsizetype most = 0, beyond = text.size();
  const auto cut = [&text](qsizetype length) { return text.left(length).trimmed() + QChar(0x2026); };
  while (most + 1 < beyond) {
    const qsizetype middle = (most + beyond) / 2;
    (wrappedHeight(cut(middle), width) <= foldedHeight() ? most : beyond) = middle;
  }
  return cut(most);
}

bool FaultLines::fits(int width) const {
  int height = 0;
  for (const PageReason& reason : m_reasons) height += wrappedHeight(reason.text, width);
  return height <= foldedHeight();
}

int FaultLines::heightForWidth(int width) const {
  if (!m_isUnfolded || fits(width)) return foldedHeight();
  int height = 0;
  for (const PageReason& reason : m_reasons) height += wrappedHeight(reason.text, width - buttonWidth());
  return std::max(height, foldedHeight());
}

int FaultLines::buttonWidth() const { return m_more->sizeHint().width() + 8; }

void FaultLines::arrange() {
  const bool isWhole = fits(width());
  const int hidden = static_cast<int>(m_reasons.size()) - kKept;
  const QString more = m_isUnfolded ? tr("Less")
                       : hidden > 0 ? tr("and %n more", nullptr, hidden)
                                    : tr("All of it");
  if (m_more->text() != more) m_more->setText(more);
  m_more->setVisible(!isWhole);
  const int room = isWhole ? width() : width() - buttonWidth();
  m_more->setGeometry(room + 8, 0, buttonWidth() - 8, foldedHeight());
  int y = 0;
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    const auto& [sign, words] = m_lines[i];
    const bool isShown = i < m_reasons.size() && (isWhole || m_isUnfolded || i < kKept);
    sign->setVisible(isShown);
    words->setVisible(isShown);
    if (!isShown) continue;
    const QString& text = m_reasons[i].text;
    const bool isOneLine = !isWhole && !m_isUnfolded;
    const bool isAlone = m_reasons.size() == 1;
    const int height = !isOneLine ? wrappedHeight(text, room) : isAlone ? foldedHeight() : lineHeight();
    setText(*words, !isOneLine ? text
                    : isAlone  ? elidedLines(text, room)
                               : fontMetrics().elidedText(text, Qt::ElideRight, room - kSignRoom - kSlack));
    sign->setGeometry(0, y + (lineHeight() - 16) / 2, 16, 16);
    words->setGeometry(kSignRoom, y, room - kSignRoom, height);
    y += height;
  }
}

void FaultLines::resizeEvent(QResizeEvent*) { arrange(); }

// In the letters of another density all is as high as they are.
void FaultLines::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange && event->type() != QEvent::StyleChange) return;
  updateGeometry();
  arrange();
}

}  // namespace deckpipe
