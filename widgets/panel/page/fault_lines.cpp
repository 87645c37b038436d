// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/fault_lines.h"

#include <QEvent>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "model/page_sources.h"
#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/common/health_look.h"
#include "panel/common/labels.h"

namespace deckpipe {
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
    const int height = isOneLine ? lineHeight() : wrappedHeight(text, room);
    setText(*words,
            isOneLine ? fontMetrics().elidedText(text, Qt::ElideRight, room - kSignRoom - kSlack) : text);
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
