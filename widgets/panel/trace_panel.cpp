// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/trace_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDataStream>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QShortcut>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "model/cell_filters.h"
#include "model/field_text.h"
#include "model/filter_keys.h"
#include "panel/id_view.h"
#include "panel/label_ink.h"
#include "panel/trace_filter_edit.h"
#include "panel/trace_search_bar.h"

namespace deckpipe {
namespace {

constexpr int kMoreMs = 33;
constexpr int kStateVersion = 1;

}  // namespace

TracePanel::TracePanel(QWidget* parent)
    : QWidget(parent), m_colours(coloursOf(Theme::Light)), m_model(new TraceModel(this)) {
  setObjectName(QStringLiteral("tracePanel"));
  setAccessibleName(tr("Trace"));
  m_view = new TraceView(this);
  m_view->setModel(m_model);
  m_view->setFrameShape(QFrame::NoFrame);
  m_search = makeSearch();
  m_search->hide();
  makeBar();
  connect(m_view, &TraceView::currentFrameChanged, this, [this](std::optional<std::uint64_t> frame) {
    if (!isById()) Q_EMIT currentFrameChanged(frame);
  });
  connect(m_view, &TraceView::cursorRequested, this, &TracePanel::cursorRequested);
  connect(m_view, &TraceView::followingChanged, m_follow, &QAbstractButton::setChecked);
  connect(m_view, &TraceView::menuRequested, this, &TracePanel::showCellMenu);
  m_view->header()->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(m_view->header(), &QWidget::customContextMenuRequested, this, &TracePanel::showColumnMenu);
  m_more.setInterval(kMoreMs);
  connect(&m_more, &QTimer::timeout, this, &TracePanel::refresh);
  const auto shortcut = [this](const QKeySequence& keys, auto what) {
    connect(new QShortcut(keys, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut),
            &QShortcut::activated, this, what);
  };
  const auto search = [this] {
    m_order->setCurrentIndex(0);
    m_search->open();
  };
  shortcut(QKeySequence::Find, search);
  shortcut(QKeySequence(QStringLiteral("Ctrl+L")), [this] {
    m_order->setCurrentIndex(0);
    m_filter->setFocus(Qt::ShortcutFocusReason);
    m_filter->selectAll();
  });
  shortcut(QKeySequence(QStringLiteral("F3")),
           [this, search] { m_search->isVisible() ? m_search->findNext() : search(); });
  shortcut(QKeySequence(QStringLiteral("Shift+F3")),
           [this, search] { m_search->isVisible() ? m_search->findPrevious() : search(); });
  showCount();
}

void TracePanel::makeBar() {
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(8, 4, 8, 4);
  bar->setSpacing(8);
  m_filter = new TraceFilterEdit(this);
  connect(m_filter, &TraceFilterEdit::filterTyped, this, &TracePanel::takeFilter);
  connect(m_filter, &TraceFilterEdit::mistyped, this, &TracePanel::showError);
  connect(m_filter, &TraceFilterEdit::left, m_view, qOverload<>(&QWidget::setFocus));
  m_help = new QToolButton(this);
  m_help->setObjectName(QStringLiteral("traceFilterHelp"));
  m_help->setText(QStringLiteral("?"));
  m_help->setAccessibleName(tr("How filters are written"));
  m_help->setMinimumWidth(32);
  m_help->setToolTip(filterHelp());
  m_help->setPopupMode(QToolButton::InstantPopup);
  auto* examples = new QMenu(m_help);
  for (const char* example : {"pgn=EF00 and sa=80", "type=01,83", "name~\"soft limits\"", "rotation_deg>30",
                              "data~\"01 1D\"", "dir=tx", "malformed or err", "t>=10 and t<20"}) {
    const QString text = QLatin1String(example);
    examples->addAction(text, this, [this, text] { setFilter(text); });
  }
  m_help->setMenu(examples);
  m_count = new QLabel(this);
  m_count->setObjectName(QStringLiteral("traceCount"));
  m_count->setTextFormat(Qt::PlainText);
  m_count->setMinimumWidth(fontMetrics().horizontalAdvance(
      tr("%1 of %2").arg(QLocale().toString(10'000'000), QLocale().toString(10'000'000))));
  m_error = new QLabel(this);
  m_error->setObjectName(QStringLiteral("traceFilterError"));
  m_error->setAccessibleName(tr("What is wrong with the filter"));
  m_error->setTextFormat(Qt::PlainText);
  m_error->setWordWrap(true);
  m_error->setFrameShape(QFrame::Box);
  m_error->setMargin(6);
  m_error->setAutoFillBackground(true);
  m_error->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_error->hide();
  m_time = new QComboBox(this);
  m_time->setObjectName(QStringLiteral("traceTime"));
  m_time->setAccessibleName(tr("How the Time column says time"));
  m_time->setToolTip(m_time->accessibleName());
  m_time->addItems({tr("Time of the log"), tr("Since the begin"), tr("Since the row before")});
  connect(m_time, &QComboBox::activated, this, &TracePanel::setTimeMode);
  m_follow = new QCheckBox(this);
  m_follow->setObjectName(QStringLiteral("traceFollow"));
  m_follow->setText(tr("Follow"));
  m_follow->setAccessibleName(tr("Follow the end of the log"));
  m_follow->setToolTip(m_follow->accessibleName());
  m_follow->setChecked(m_view->isFollowing());
  connect(m_follow, &QAbstractButton::toggled, m_view, &TraceView::setFollowing);
  m_order = new QTabBar(this);
  m_order->setObjectName(QStringLiteral("traceOrder"));
  m_order->setAccessibleName(tr("Rows of the trace"));
  m_order->setExpanding(false);
  m_order->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  m_order->setDrawBase(false);
  m_order->addTab(tr("In order"));
  m_order->addTab(tr("By ID"));
  m_order->setTabToolTip(0, tr("Every frame, as it came"));
  m_order->setTabToolTip(1, tr("The last frame of each identifier, how often and how regular it comes"));
  connect(m_order, &QTabBar::currentChanged, this, &TracePanel::setOrder);
  bar->addWidget(m_order);
  bar->addWidget(m_filter, 1);
  bar->addWidget(m_help);
  bar->addWidget(m_count);
  bar->addWidget(m_time);
  bar->addWidget(m_follow);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addLayout(bar);
  m_ids = new IdView(this);
  connect(m_ids, &IdView::currentFrameChanged, this, &TracePanel::currentFrameChanged);
  connect(m_ids, &IdView::filterRequested, this, [this](const QString& expression) {
    m_order->setCurrentIndex(0);
    setFilter(expression);
  });
  m_pages = new QStackedWidget(this);
  m_pages->addWidget(m_view);
  m_pages->addWidget(m_ids);
  all->addWidget(m_pages, 1);
  all->addWidget(m_search);
}

TraceSearchBar* TracePanel::makeSearch() {
  auto* search = new TraceSearchBar(
      [this](bool isBackwards, bool isHereToo) {
        TraceSearch::Question question;
        question.log = m_model->view().document;
        question.frames = m_model->view().frameCount;
        question.shown = m_model->filter();
        const auto here = m_view->currentFrame();
        const std::uint64_t top = m_model->frameOf(m_view->topRow()).value_or(0);
        question.from = !here ? top : isBackwards || isHereToo ? *here : *here + 1;
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

void TracePanel::setView(const LogView& view) {
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
    m_filter->setChannels(channels);
  }
  showCount();
}

void TracePanel::setColours(const Colours& colours) {
  m_colours = colours;
  m_view->setColours(colours);
  m_ids->setColours(colours);
  m_search->setColours(colours);
  showCount();
  showError();
  update();
}

void TracePanel::setFilter(const QString& expression) { m_filter->setExpression(expression); }

QString TracePanel::filter() const { return m_filter->text(); }

void TracePanel::takeFilter(const TraceFilter& filter) {
  const bool wasFiltered = m_model->isFiltered();
  m_expression = m_filter->text().trimmed();
  m_model->setFilter(filter);
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
  setInk(*m_count, m_colours.textSecondary);
  const QLocale locale;
  const std::uint64_t frames = m_model->view().frameCount;
  QString text;
  if (isById()) {
    text = tr("%1 rows").arg(locale.toString(m_ids->rows()->rowCount()));
    if (const std::uint64_t others = m_ids->rows()->otherFrames(); others > 0)
      text = tr("%1; %2 frames of further identifiers have none").arg(text, locale.toString(others));
  } else if (!m_model->isFiltered()) {
    text = frames == 0 ? QString() : tr("All frames");
  } else if (m_model->isFiltering()) {
    const int percent =
        static_cast<int>(100 * m_model->filteredFrames() / std::max<std::uint64_t>(frames, 1));
    text = tr("%1 so far, %2 %").arg(locale.toString(m_model->rows())).arg(percent);
  } else {
    text = tr("%1 of %2").arg(locale.toString(m_model->rows()), locale.toString(frames));
  }
  setText(*m_count, text);
}

// Over the first rows, so that nothing moves while one types.
void TracePanel::showError() {
  const auto& error = m_filter->error();
  m_error->setVisible(error.has_value() && !isById());
  if (!error || isById()) return;
  m_error->setText(tr("Character %1: %2").arg(error->at + 1).arg(error->text));
  QPalette inks = m_error->palette();
  inks.setColor(QPalette::Window, m_colours.surface);
  inks.setColor(QPalette::WindowText, m_colours.fault.ink);
  m_error->setPalette(inks);
  m_error->setFixedSize(m_filter->width(), m_error->heightForWidth(m_filter->width()));
  m_error->move(m_filter->x(), m_filter->geometry().bottom());
  m_error->raise();
}

void TracePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showError();
}

// Filter, time and search are about frames one by one.
void TracePanel::setOrder(int order) {
  const bool isById = order == 1;
  if (isById && m_search->isVisible()) closeSearch();
  m_pages->setCurrentIndex(order);
  for (QWidget* widget : std::initializer_list<QWidget*>{m_filter, m_help, m_time, m_follow})
    widget->setVisible(!isById);
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

void TracePanel::setTimeMode(int mode) {
  m_model->setTimeMode(static_cast<TraceModel::TimeMode>(mode));
  const QSignalBlocker blocker(m_time);
  m_time->setCurrentIndex(mode);
}

void TracePanel::showCellMenu(std::optional<TraceView::Cell> cell, const QPoint& global) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("traceMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (cell) {
    QMenu* hide = new QMenu(tr("Hide"), menu);
    menu->addSection(tr("Show only"));
    for (const CellFilter& filter : cellFilters(*m_model->view().document, cell->frame, cell->column)) {
      QString what = filter.what;
      what.replace(u'&', QLatin1String("&&"));
      menu->addAction(what, this, [this, filter] { setFilter(narrowed(m_expression, filter.expression)); });
      hide->addAction(what, this, [this, filter] { setFilter(reduced(m_expression, filter.expression)); });
    }
    menu->addMenu(hide);
    if (m_model->isFiltered()) menu->addAction(tr("Show all"), this, [this] { setFilter({}); });
    menu->addSeparator();
    menu->addAction(tr("Put the cursor here"), this,
                    [this, frame = cell->frame] { Q_EMIT cursorRequested(frame); });
    if (cell->column >= 0) {
      const QModelIndex at = m_view->indexOfFrame(cell->frame, cell->column);
      if (const QString text = at.data().toString(); !text.isEmpty())
        menu->addAction(tr("Copy the cell"), this, [text] { QApplication::clipboard()->setText(text); });
    }
  }
  QAction* copy = menu->addAction(tr("Copy as candump text"), m_view, &TraceView::copy);
  copy->setShortcut(QKeySequence::Copy);
  copy->setEnabled(!m_view->selection().isEmpty());
  menu->popup(global);
}

void TracePanel::showColumnMenu(const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("traceColumnMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  FlatHeader* header = m_view->header();
  const bool isLast = header->count() - header->hiddenSectionCount() == 1;
  for (int column = 0; column < header->count(); ++column) {
    QAction* action = menu->addAction(m_model->headerData(column, Qt::Horizontal).toString());
    action->setCheckable(true);
    action->setChecked(!header->isSectionHidden(column));
    action->setEnabled(!isLast || header->isSectionHidden(column));  // one at least stays
    connect(action, &QAction::toggled, m_view,
            [this, column](bool isShown) { m_view->setColumnShown(column, isShown); });
  }
  menu->addSeparator();
  menu->addAction(tr("Columns as they were"), m_view, &TraceView::resetColumns);
  menu->popup(header->mapToGlobal(at));
}

QByteArray TracePanel::saveState() const {
  QByteArray state;
  QDataStream out(&state, QIODevice::WriteOnly);
  out << kStateVersion << m_view->saveState() << static_cast<int>(m_model->timeMode());
  return state;
}

bool TracePanel::restoreState(const QByteArray& state) {
  QDataStream in(state);
  int version = 0, mode = 0;
  QByteArray columns;
  in >> version >> columns >> mode;
  if (in.status() != QDataStream::Ok || version != kStateVersion) return false;
  if (mode >= 0 && mode < m_time->count()) setTimeMode(mode);
  return m_view->restoreState(columns);
}

void TracePanel::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), m_colours.window);
}

}  // namespace deckpipe
