// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_search_bar.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QToolButton>

#include "paint/app_style.h"
#include "panel/common/build.h"

namespace deckpipe {
namespace {

constexpr int kTickMs = 100;

}  // namespace

TraceSearchBar::TraceSearchBar(Where where, QWidget* parent) : QWidget(parent), m_where(std::move(where)) {
  named(this, "traceSearchBar", tr("Search in the trace"));
  m_edit = named(new QLineEdit(this), "traceSearch", tr("Search for"));
  m_edit->setPlaceholderText(tr("Find: text of a row, or an expression such as rotation_deg>30"));
  m_edit->setWhatsThis(tr(
      "Finds the next frame whose row shows this text, or that passes an expression of the filter language. "
      "F3 goes on, Shift+F3 back; Escape gives a search up and then closes this line."));
  m_edit->setClearButtonEnabled(true);
  m_previous = makeToolButton(this, "traceSearchPrevious", tr("Previous"), tr("Previous match (Shift+F3)"));
  m_next = makeToolButton(this, "traceSearchNext", tr("Next"), tr("Next match (F3)"));
  m_close = makeToolButton(this, "traceSearchClose", tr("Close"), tr("Close the search (Esc)"));
  m_said = new QLabel(this);
  m_said->setObjectName(QStringLiteral("traceSearchSaid"));
  m_said->setTextFormat(Qt::PlainText);
  m_said->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Found, on from the begin of the log")) + 8);
  inRow(this, {8, 4, 8, 4}, 4, {{m_edit, 1}, m_previous, m_next, LayoutPart::gap(8), m_said, m_close});
  m_tick.setInterval(kTickMs);
  connect(&m_tick, &QTimer::timeout, this, &TraceSearchBar::sayProgress);
  connect(m_edit, &QLineEdit::textChanged, this, [this] { find({.isHereToo = true}); });
  connect(m_previous, &QToolButton::clicked, this, &TraceSearchBar::findPrevious);
  connect(m_next, &QToolButton::clicked, this, &TraceSearchBar::findNext);
  connect(m_close, &QToolButton::clicked, this, &TraceSearchBar::closed);
  connect(&m_search, &TraceSearch::found, this, [this](quint64 frame, bool wrapped) {
    say(!wrapped        ? tr("Found")
        : m_isBackwards ? tr("Found, on from the end of the log")
                        : tr("Found, on from the begin of the log"));
    Q_EMIT frameFound(frame);
  });
  connect(&m_search, &TraceSearch::notFound, this, [this] { say(tr("Not found"), true); });
}

void TraceSearchBar::open() {
  show();
  m_edit->setFocus(Qt::ShortcutFocusReason);
  m_edit->selectAll();
}

void TraceSearchBar::forget() {
  m_search.cancel();
  say({});
}

QString TraceSearchBar::said() const { return m_said->text(); }

void TraceSearchBar::say(const QString& text, bool isWarning) {
  setInk(*m_said, isWarning ? Ink::Warning : Ink::Secondary);
  setText(*m_said, text);
}

// What is an expression is one; everything else is text, and so is what stands in quotes.
void TraceSearchBar::find(Way way) {
  const QString text = m_edit->text().trimmed();
  if (text.isEmpty()) {
    forget();
    return;
  }
  TraceSearch::Question question = m_where(way);
  if (!question.log || question.frames == 0) {
    say(tr("No frames"));
    return;
  }
  const bool isQuoted = text.size() > 2 && text.startsWith(u'"') && text.endsWith(u'"');
  auto expression = TraceFilter::parse(text);
  question.wanted = isQuoted     ? TraceFilter::containing(text.mid(1, text.size() - 2))
                    : expression ? expression.value()
                                 : TraceFilter::containing(text);
  question.isBackwards = m_isBackwards = way.isBackwards;
  m_search.find(std::move(question));
  m_tick.start();
  sayProgress();
}

void TraceSearchBar::sayProgress() {
  if (m_search.isSearching()) {
    say(tr("Searching… %1 %").arg(static_cast<int>(m_search.fraction() * 100)));
  } else {
    m_tick.stop();
  }
}

void TraceSearchBar::giveUpOrClose() {
  if (m_search.isSearching()) {
    m_search.cancel();
    say(tr("Search given up"));
  } else {
    Q_EMIT closed();
  }
}

void TraceSearchBar::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape: giveUpOrClose(); return;
    case Qt::Key_Return:
    case Qt::Key_Enter: find({.isBackwards = (event->modifiers() & Qt::ShiftModifier) != 0}); return;
    default: QWidget::keyPressEvent(event);
  }
}

}  // namespace deckpipe
