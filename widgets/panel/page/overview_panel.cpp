// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/overview_panel.h"

#include <QKeyEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "panel/common/build.h"
#include "panel/common/untracked_label.h"
#include "panel/page/monitor_tile.h"

namespace deckpipe {
namespace {

constexpr double kDialAspect = 1.45;  // a dial is that much wider than high where it fills its tile best

int rowsOf(int count, int columns) { return (count + columns - 1) / columns; }

}  // namespace

int OverviewGrid::height(int count) const { return kGap + rowsOf(count, columns) * (tile.height() + kGap); }

OverviewGrid overviewGrid(int count, const QSize& room) {
  constexpr int kGap = OverviewGrid::kGap;
  const auto share = [](int all, int n) { return (all - (n + 1) * kGap) / n; };
  const int most = std::max(1, (room.width() - kGap) / (OverviewGrid::kMin.width() + kGap));
  OverviewGrid best;
  double bestScore = 0;
  for (int columns = 1; columns <= std::min(most, count); ++columns) {
    const QSize tile = QSize(share(room.width(), columns), share(room.height(), rowsOf(count, columns)))
                           .boundedTo(OverviewGrid::kMax);
    if (tile.height() < OverviewGrid::kMin.height()) continue;
    const double score = std::min(tile.width() / kDialAspect, static_cast<double>(tile.height()));
    if (score <= bestScore) continue;
    bestScore = score;
    best = {columns, tile};
  }
  if (bestScore > 0) return best;
  return {most, {std::max(share(room.width(), most), 1), OverviewGrid::kMin.height()}};
}

OverviewPanel::OverviewPanel(QWidget* parent)
    : QWidget(parent),
      m_empty(makeMessage(this, "noMonitors", {})),
      m_summary(named(new QLabel(this), "overviewSummary", tr("How many monitors have which trouble"))),
      m_untracked(new UntrackedLabel(QStringLiteral("untrackedMonitors"), this)),
      m_scroll(named(new QScrollArea(this), "overviewScroll", tr("Monitors"))),
      m_content(new QWidget) {
  named(this, "overviewPanel", tr("All monitors"));
  m_content->setObjectName(QStringLiteral("overviewContent"));
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_scroll->setFocusPolicy(Qt::NoFocus);  // the tiles have it
  m_scroll->setWidget(m_content);
  m_scroll->installEventFilter(this);
  m_content->installEventFilter(this);
  m_summary->setContentsMargins(OverviewGrid::kGap, OverviewGrid::kGap / 2, OverviewGrid::kGap, 0);
  m_summary->setWordWrap(true);
  inColumn(this, {0, 0, 0, 0}, 0, {m_summary, {m_empty, 1}, {m_scroll, 1}, m_untracked});
  refresh();
}

// Oscillating bands move by themselves unless the cursor stands still.
void OverviewPanel::setView(const PanelView& view) {
  m_view = view;
  if (isVisible()) refresh();
}

void OverviewPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

MonitorTile* OverviewPanel::newTile() {
  auto* tile = new MonitorTile(m_content);
  tile->installEventFilter(this);
  connect(tile, &QAbstractButton::clicked, this, [this, tile] { Q_EMIT pageRequested(tile->monitor().key); });
  return tile;
}

// A click lands on the tile that was aimed at.
void OverviewPanel::keepPlaces(std::vector<OverviewMonitor>& monitors) const {
  std::ranges::stable_sort(monitors, {}, [this](const OverviewMonitor& m) {
    return std::ranges::find(m_tiles, m.key, [](const MonitorTile* tile) { return tile->monitor().key; });
  });
}

void OverviewPanel::giveTiles(const std::vector<OverviewMonitor>& monitors) {
  std::vector<MonitorTile*> others = m_tiles;
  std::vector<MonitorTile*> tiles;
  for (const OverviewMonitor& m : monitors) {
    const auto own = std::ranges::find_if(
        others, [&](const MonitorTile* tile) { return tile != nullptr && tile->monitor().key == m.key; });
    tiles.push_back(own != others.end() ? std::exchange(*own, nullptr) : newTile());
    tiles.back()->setMonitor(m);
    tiles.back()->setChosen(m.key == m_view.device);
    tiles.back()->setAnimated(m_view.isMoving);
  }
  if (tiles == m_tiles) return;
  for (MonitorTile* gone : others) {
    if (gone == nullptr) continue;
    gone->hide();
    gone->deleteLater();
  }
  m_tiles = std::move(tiles);
  for (int i = 0; i < count(); ++i) {
    MonitorTile* tile = m_tiles[static_cast<std::size_t>(i)];
    tile->setObjectName(QStringLiteral("monitorTile%1").arg(i + 1));
    if (i > 0) setTabOrder(m_tiles[static_cast<std::size_t>(i) - 1], tile);
    tile->show();
  }
  layOut();
}

void OverviewPanel::refresh() {
  std::vector<OverviewMonitor> monitors = overviewOf(m_view.log, m_view.labels);
  const bool isEmpty = monitors.empty();
  setText(*m_summary, isEmpty ? QString() : overviewSummary(monitors));
  if (m_isPointed) keepPlaces(monitors);
  giveTiles(monitors);
  m_untracked->setView(m_view.log);
  if (isEmpty) setText(*m_empty, emptyText());
  m_empty->setVisible(isEmpty);
  m_summary->setVisible(!isEmpty);
  m_scroll->setVisible(!isEmpty);
}

QString OverviewPanel::emptyText() const {
  if (m_view.log.state == nullptr || m_view.log.document == nullptr)
    return tr("Nothing is open.\nConnect an adapter or open a log.");
  const int others = static_cast<int>(deviceRows(*m_view.log.state).size());
  if (others == 0) return tr("No monitor heard up to this place of the log.");
  return tr("No monitor heard up to this place of the log.\nOther devices in the list: %n.", nullptr, others);
}

// The scroll bar takes its width only where it is needed.
void OverviewPanel::layOut() {
  QSize room = m_scroll->size();
  OverviewGrid grid = overviewGrid(count(), room);
  if (grid.height(count()) > room.height()) {
    room.rwidth() -= m_scroll->verticalScrollBar()->sizeHint().width();
    grid = overviewGrid(count(), room);
  }
  m_columns = grid.columns;
  m_content->resize(room.width(), grid.height(count()));
  for (int i = 0; i < count(); ++i) m_tiles[static_cast<std::size_t>(i)]->setGeometry(grid.place(i));
}

bool OverviewPanel::moveFocus(int from, int key) {
  int to = from;
  switch (key) {
    case Qt::Key_Left: to = from - 1; break;
    case Qt::Key_Right: to = from + 1; break;
    case Qt::Key_Up: to = from - m_columns; break;
    case Qt::Key_Down: to = from + m_columns; break;
    case Qt::Key_Home: to = 0; break;
    case Qt::Key_End: to = count() - 1; break;
    default: return false;
  }
  if (to >= 0 && to < count()) {
    MonitorTile* tile = m_tiles[static_cast<std::size_t>(to)];
    tile->setFocus(Qt::OtherFocusReason);
    m_scroll->ensureWidgetVisible(tile, OverviewGrid::kGap, OverviewGrid::kGap);
  }
  return true;
}

bool OverviewPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_scroll && event->type() == QEvent::Resize) layOut();
  // A pointer that rests where the panel comes up points at nothing.
  if (event->type() == QEvent::HoverMove) m_isPointed = true;
  if (watched == m_content && event->type() == QEvent::Leave) m_isPointed = false;
  if (event->type() == QEvent::KeyPress) {
    const auto tile = std::ranges::find(m_tiles, watched);
    if (tile != m_tiles.end())
      return moveFocus(static_cast<int>(tile - m_tiles.begin()), static_cast<QKeyEvent*>(event)->key());
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace deckpipe
