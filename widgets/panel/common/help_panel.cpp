// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/common/help_panel.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QItemSelectionModel>
#include <QTextDocumentFragment>

#include "panel/common/build.h"
#include "panel/trace/trace_view.h"

namespace deckpipe {
namespace {

constexpr int kAgainMs = 500;

QString plain(const QString& tip) {
  return Qt::mightBeRichText(tip) ? QTextDocumentFragment::fromHtml(tip).toPlainText() : tip;
}

// The nearest that says what it is: a view's viewport and a box's inner field do not.
QWidget* speaker(QWidget* widget) {
  while (widget != nullptr && widget->accessibleName().isEmpty() && !widget->isWindow())
    widget = widget->parentWidget();
  return widget;
}

}  // namespace

HelpPanel::HelpPanel(QWidget* parent) : QWidget(parent) {
  named(this, "helpPanel", tr("Explanation"));
  auto* inside = new QWidget;
  inside->setAutoFillBackground(true);
  inside->setBackgroundRole(QPalette::Base);
  m_title = makeWords(inside, "helpTitle", {});
  m_title->setFont(strongFont(m_title->font()));
  m_now = makeWords(inside, "helpNow", {});
  m_story = makeWords(inside, "helpStory", {}, Ink::Secondary);
  for (QLabel* label : {m_title, m_now, m_story}) label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  inColumn(inside, {12, 8, 12, 8}, 6, {m_title, m_now, m_story, LayoutPart::rest()});
  fillScrolled(this, inside, "helpScroll");
  m_again.setInterval(kAgainMs);
  connect(&m_again, &QTimer::timeout, this, &HelpPanel::showExplanation);
  explain(nullptr);
}

void HelpPanel::explain(QWidget* widget) {
  disconnect(m_rows);
  m_widget = speaker(widget);
  if (auto* view = qobject_cast<QAbstractItemView*>(m_widget.data());
      view != nullptr && view->selectionModel())
    m_rows = connect(view->selectionModel(), &QItemSelectionModel::currentChanged, this,
                     &HelpPanel::showExplanation);
  if (const auto* trace = qobject_cast<TraceView*>(m_widget.data()))
    m_rows = connect(trace, &TraceView::currentFrameChanged, this, &HelpPanel::showExplanation);
  showExplanation();
}

void HelpPanel::showExplanation() {
  if (m_widget == nullptr || m_widget->isWindow()) {
    setText(*m_title, tr("Nothing is chosen"));
    setText(*m_now, {});
    setText(*m_story, tr("Choose something by mouse, or by Tab and F6: it is explained here."));
    return;
  }
  QString title = m_widget->accessibleName(), now = m_widget->accessibleDescription();
  QString story = plain(m_widget->whatsThis().isEmpty() ? m_widget->toolTip() : m_widget->whatsThis());
  if (const auto* view = qobject_cast<QAbstractItemView*>(m_widget.data());
      view != nullptr && view->currentIndex().isValid()) {
    const QModelIndex row = view->currentIndex().siblingAtColumn(0);
    const QString said = row.data(Qt::AccessibleTextRole).toString();
    now = said.isEmpty() ? row.data().toString() : said;
    const QString tip = plain(view->currentIndex().data(Qt::ToolTipRole).toString());
    const QString rowTip = plain(row.data(Qt::ToolTipRole).toString());
    const QString rowStory = plain(row.data(Qt::WhatsThisRole).toString());
    for (const QString& better : {rowTip, tip, rowStory}) {
      if (!better.isEmpty()) story = better;
    }
  }
  setText(*m_title, title);
  setText(*m_now, now == story ? QString() : now);
  setText(*m_story, story);
  m_now->setVisible(!m_now->text().isEmpty());
}

QString HelpPanel::text() const {
  return QStringList{m_title->text(), m_now->text(), m_story->text()}.join(QLatin1Char('\n'));
}

// What was explained may have changed while this was closed.
bool HelpPanel::event(QEvent* event) {
  if (event->type() == QEvent::Show) {
    showExplanation();
    m_again.start();
  } else if (event->type() == QEvent::Hide) {
    m_again.stop();
  }
  return QWidget::event(event);
}

}  // namespace deckpipe
