// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace/trace_panel.h"

#include <QDataStream>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QShortcut>
#include <QStackedWidget>
#include <utility>

#include "model/cell_filters.h"
#include "model/field_text.h"
#include "paint/app_style.h"
#include "panel/common/build.h"
#include "panel/trace/id_view.h"
#include "panel/trace/trace_bar.h"
#include "panel/trace/trace_filter_edit.h"
#include "panel/trace/trace_search_bar.h"
#include "text/plural.h"

namespace deckpipe {
namespace {

constexpr int kSearchMoreMs = 33;
constexpr int kStateVersion = 3;

}  // namespace

TracePanel::TracePanel(QWidget* parent) : QWidget(parent), m_model(new TraceModel(this)) {
  named(this, "tracePanel", tr("Trace"));
  m_view = new TraceView(this);
  m_view->setModel(m_model);
  m_view->setFrameShape(QFrame::NoFrame);
  m_bar = new TraceBar(this);
  m_ids = new IdView(this);
  m_search = makeSearch();
  m_search->hide();
  layOut();
  connectParts();
  makeShortcuts();
  showCount();
}

void TracePanel::connectParts() {
  TraceFilterEdit* filter = m_bar->filter();
  connect(filter, &TraceFilterEdit::filterTyped, this, &TracePanel::takeFilter);
  connect(filter, &TraceFilterEdit::mistyped, this, &TracePanel::showError);
  connect(filter, &TraceFilterEdit::left, this, [this] { m_pages->currentWidget()->setFocus(); });
  connect(m_bar, &TraceBar::orderChosen, this, &TracePanel::setOrder);
  connect(m_bar, &TraceBar::timeModeChosen, this, &TracePanel::setTimeMode);
  connect(m_bar, &TraceBar::followToggled, m_view, &TraceView::setFollowing);
  connect(m_bar, &TraceBar::findRequested, this, &TracePanel::find);
  m_bar->setFollowing(m_view->isFollowing());
  connect(m_view, &TraceView::followingChanged, m_bar, &TraceBar::setFollowing);
  connect(m_view, &TraceView::currentFrameChanged, this, [this](std::optional<std::uint64_t> frame) {
    if (!isById()) Q_EMIT currentFrameChanged(frame);
  });
  connect(m_view, &TraceView::detailRequested, this, &TracePanel::detailRequested);
  connect(m_ids, &IdView::detailRequested, this, &TracePanel::detailRequested);
  connect(m_view, &TraceView::cursorRequested, this, &TracePanel::cursorRequested);
  connect(m_view, &TraceView::menuRequested, this, &TracePanel::showCellMenu);
  for (FlatHeader* header : {m_view->header(), m_ids->header()}) {
    header->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header, &QWidget::customContextMenuRequested, this,
            [this, header](const QPoint& at) { showColumnMenu(*header, at); });
  }
  m_more.setInterval(kSearchMoreMs);
  connect(&m_more, &QTimer::timeout, this, &TracePanel::refresh);
  connect(m_ids, &IdView::currentFrameChanged, this, &TracePanel::currentFrameChanged);
  connect(m_ids, &IdView::filterRequested, this, [this](const QString& expression) {
    m_bar->setOrder(TraceBar::InOrder);
    m_row = Row{m_expression, narrowed(m_expression, expression)};
    setFilter(m_row->frames);
  });
}

void TracePanel::makeShortcuts() {
  const auto shortcut = [this](const QKeySequence& keys, auto what) {
    connect(new QShortcut(keys, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut),
            &QShortcut::activated, this, what);
  };
  shortcut(QKeySequence::Find, &TracePanel::find);
  shortcut(QKeySequence(QStringLiteral("F3")),
           [this] { m_search->isVisible() ? m_search->findNext() : find(); });
  shortcut(QKeySequence(QStringLiteral("Shift+F3")),
           [this] { m_search->isVisible() ? m_search->findPrevious() : find(); });
}

void TracePanel::find() {
  m_bar->setOrder(TraceBar::InOrder);
  m_search->open();
}

void TracePanel::goToFilter() {
  m_bar->filter()->setFocus(Qt::ShortcutFocusReason);
  m_bar->filter()->selectAll();
}

void TracePanel::layOut() {
  m_error = makeWords(this, "traceFilterError", tr("What is wrong with the filter"), Ink::Fault);
  m_error->setFrameShape(QFrame::Box);
  m_error->setMargin(6);
  m_error->setAutoFillBackground(true);
  m_error->setBackgroundRole(QPalette::Base);
  m_error->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_error->hide();
  m_pages = new QStackedWidget(this);
  m_pages->addWidget(m_view);
  m_pages->addWidget(m_ids);
  inColumn(this, {0, 0, 0, 0}, 0, {m_bar, {m_pages, 1}, m_search});
}

TraceSearchBar* TracePanel::makeSearch() {
  auto* search = new TraceSearchBar(
      [this](TraceSearchBar::Way way) {
        TraceSearch::Question question;
        question.log = m_model->view().document;
        question.frames = m_model->view().frameCount;
        question.shown = m_model->filter();
        const auto here = m_view->currentFrame();
        const std::uint64_t top = m_model->frameOf(m_view->topRow()).value_or(0);
        question.from = !here ? top : way.isBackwards || way.isHereToo ? *here : *here + 1;
        return question;
      },
      this);
  connect(search, &TraceSearchBar::frameFound, this, [this](quint64 frame) {
    m_view->setFollowing(false);
    m_view->setCurrentFrame(frame);
  });
  connect(search, &TraceSearchBar::closed, this, &TracePanel::closeSearch);
  return search;
}

void TracePanel::closeSearch() {
  m_search->forget();
  m_search->hide();
  m_view->setFocus();
}

void TracePanel::setView(const PanelView& shown) {
  const LogView& view = shown.log;
  if (view.document != m_model->view().document) {
    m_search->forget();
    if (!m_search->edit()->text().isEmpty()) m_search->edit()->selectAll();
  }
  m_model->setView(view);
  if (isById()) m_ids->setView(view);
  if (view.document && view.document->frames.channelCount() != m_channels) {
    m_channels = view.document->frames.channelCount();
    QStringList channels;
    for (std::size_t i = 0; i < m_channels; ++i)
      channels += toQString(view.document->frames.channelName(static_cast<std::uint8_t>(i)));
    m_bar->filter()->setChannels(channels);
  }
  showCount();
}

void TracePanel::setFilter(const QString& expression) { m_bar->filter()->setExpression(expression); }

QString TracePanel::filter() const { return m_bar->filter()->text(); }

void TracePanel::takeFilter(const TraceFilter& filter) {
  const bool wasFiltered = m_model->isFiltered();
  m_expression = m_bar->filter()->text().trimmed();
  m_model->setFilter(filter);
  m_ids->rows()->setFilter(filter);
  if (isById()) m_ids->setView(m_model->view());
  showCount();
  showError();
  if (m_model->isFiltered() != wasFiltered) Q_EMIT filteredChanged(!wasFiltered);
}

void TracePanel::refresh() {
  if (m_model->isFiltering()) m_model->refresh();
  if (isById()) m_ids->setView(m_model->view());
  showCount();
}

// How much passes the filter, how far it has looked, or what is wrong with it.
void TracePanel::showCount() {
  const bool isMore = m_model->isFiltering() || (isById() && m_ids->rows()->isBehind());
  if (isMore != m_more.isActive()) {
    if (m_more.isActive()) {
      m_more.stop();
    } else {
      m_more.start();
    }
  }
  const QLocale locale;
  const std::uint64_t frames = m_model->view().frameCount;
  QString text;
  if (isById()) {
    text = idCount();
  } else if (!m_model->isFiltered()) {
    text = frames == 0 ? QString() : tr("All frames");
  } else if (m_model->isFiltering()) {
    const int percent =
        static_cast<int>(100 * m_model->filteredFrames() / std::max<std::uint64_t>(frames, 1));
    text = tr("%1 so far, %2 %").arg(locale.toString(m_model->rows())).arg(percent);
  } else {
    text = tr("%1 of %2").arg(locale.toString(m_model->rows()), locale.toString(frames));
  }
  m_bar->setCount(text);
}

// How many rows, and of how many frames they tell.
QString TracePanel::idCount() const {
  const QLocale locale;
  const IdModel& ids = *m_ids->rows();
  QString text = tr("%Ln rows", nullptr, ids.rowCount());
  if (m_model->isFiltered())
    text = tr("%1 of %Ln frames, %2", nullptr, forPlural(ids.lookedAt()))
               .arg(locale.toString(static_cast<qulonglong>(ids.passed())), text);
  if (ids.otherFrames() > 0)
    text = tr("%1; %Ln frames of further identifiers have none", nullptr, forPlural(ids.otherFrames()))
               .arg(text);
  return text;
}

// Over the first rows, so that nothing moves while one types.
void TracePanel::showError() {
  const auto& error = m_bar->filter()->error();
  m_error->setVisible(error.has_value());
  if (!error) return;
  m_error->setText(tr("Character %1: %2").arg(error->at + 1).arg(error->text));
  const QRect line = m_bar->filter()->geometry();  // the bar begins where the panel does
  m_error->setFixedSize(line.width(), m_error->heightForWidth(line.width()));
  m_error->move(line.left(), line.bottom());
  m_error->raise();
}

void TracePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showError();
}

// Time and search are about frames one by one. Whoever comes back from the frames of one row finds the rows
// as they were.
void TracePanel::setOrder(int order) {
  const bool isById = order == TraceBar::ById;
  if (isById && m_search->isVisible()) closeSearch();
  m_pages->setCurrentIndex(order);
  if (const auto row = std::exchange(m_row, std::nullopt); row && m_expression == row->frames)
    setFilter(row->before);
  if (isById) m_ids->setView(m_model->view());
  showCount();
  showError();
  m_pages->currentWidget()->setFocus();
  Q_EMIT currentFrameChanged(currentFrame());
}

std::optional<std::uint64_t> TracePanel::currentFrame() const {
  return isById() ? m_ids->currentFrame() : m_view->currentFrame();
}

void TracePanel::setCurrentFrame(std::optional<std::uint64_t> frame) {
  if (!frame) m_ids->setCurrentIndex({});
  m_view->setCurrentFrame(frame);
}

bool TracePanel::isById() const { return m_pages->currentWidget() == m_ids; }

std::optional<std::uint64_t> TracePanel::cursorRowsOn(int rows) const {
  const std::uint64_t passed = m_model->rowOf(m_model->view().cursor.frames);
  const auto far = static_cast<std::uint64_t>(std::abs(rows));
  if (rows < 0 && passed < far) return {};
  const std::uint64_t wanted = rows < 0 ? passed - far : passed + far;
  if (wanted == 0) return 0;
  const auto frame = m_model->frameOf(wanted - 1);
  return frame ? std::optional(*frame + 1) : std::nullopt;
}

void TracePanel::stepCursor(int rows) {
  if (const auto cursor = cursorRowsOn(rows); cursor && *cursor > 0) Q_EMIT cursorRequested(*cursor - 1);
}

bool TracePanel::hasSelection() const { return !isById() && !m_view->selection().isEmpty(); }

void TracePanel::saveSelection() {
  if (!hasSelection()) return;
  const TraceView::FrameRange selection = m_view->selection();
  Q_EMIT saveRequested(selection.first, selection.end, m_model->filter());
}

// Also what the filter has still to look at.
void TracePanel::saveShown() { Q_EMIT saveRequested(0, m_model->view().frameCount, m_model->filter()); }

void TracePanel::setTimeMode(int mode) {
  m_model->setTimeMode(static_cast<TraceModel::TimeMode>(mode));
  m_bar->setTimeMode(mode);
}

QByteArray TracePanel::saveState() const {
  QByteArray state;
  QDataStream out(&state, QIODevice::WriteOnly);
  out << kStateVersion << m_view->saveState() << m_ids->saveState() << static_cast<int>(m_model->timeMode());
  return state;
}

bool TracePanel::restoreState(const QByteArray& state) {
  QDataStream in(state);
  int version = 0, mode = 0;
  QByteArray columns, idColumns;
  in >> version >> columns >> idColumns >> mode;
  if (in.status() != QDataStream::Ok || version != kStateVersion) return false;
  if (mode >= 0 && mode < static_cast<int>(TraceModel::TimeMode::Count)) setTimeMode(mode);
  const bool hasIds = m_ids->restoreState(idColumns);
  return m_view->restoreState(columns) && hasIds;
}

void TracePanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && m_search->isVisible()) {
    m_search->giveUpOrClose();
  } else {
    QWidget::keyPressEvent(event);
  }
}

void TracePanel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), coloursOf(this).window);
}

}  // namespace deckpipe
