// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/page/overview_panel.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>
#include <cmath>
#include <utility>

#include "paint/app_style.h"
#include "paint/dial.h"
#include "paint/figures.h"
#include "paint/glyph.h"
#include "panel/common/build.h"
#include "panel/common/health_look.h"
#include "panel/common/labels.h"
#include "text/time_text.h"

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

namespace {

constexpr int kTilePad = 12;
constexpr int kFrame = 3;  // of the focus
constexpr double kTileSign = 14;
constexpr double kTileGap = 8;

int lineHeight(const QFont& font) { return static_cast<int>(std::ceil(QFontMetricsF(font).height())) + 4; }

}  // namespace

MonitorTile::MonitorTile(QWidget* parent) : QAbstractButton(parent), m_dial(new Dial(this)) {
  setObjectName(QStringLiteral("monitorTile"));
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::StrongFocus);
  m_dial->setAttribute(Qt::WA_TransparentForMouseEvents);  // the tile takes the click
  m_dial->setObjectName(QStringLiteral("tileDial"));
}

void MonitorTile::setMonitor(const OverviewMonitor& monitor) {
  m_dial->setValues(monitor.dial);
  // Ages run on; what counts is what is written of them. The dial looks after itself.
  const bool isSame = monitor.key == m_monitor.key && monitor.title == m_monitor.title &&
                      monitor.identity == m_monitor.identity && monitor.detail == m_monitor.detail &&
                      monitor.health == m_monitor.health && monitor.reasons == m_monitor.reasons &&
                      monitor.stops == m_monitor.stops && monitor.areStopsStale == m_monitor.areStopsStale &&
                      ageText(monitor.age) == ageText(m_monitor.age);
  m_monitor = monitor;
  if (isSame) return;
  describe();
  update();
}

void MonitorTile::setChosen(bool chosen) {
  if (chosen == m_isChosen) return;
  m_isChosen = chosen;
  describe();
  update();
}

void MonitorTile::setAnimated(bool animated) { m_dial->setAnimated(animated); }

void MonitorTile::describe() {
  QString details = m_monitor.detail;
  if (!m_monitor.identity.isEmpty()) details.prepend(m_monitor.identity + QStringLiteral(" · "));
  setAccessibleName(tr("%1, %2, %3", "a monitor's name, details and health")
                        .arg(m_monitor.title, details, healthWord(m_monitor.health)));
  QStringList parts = m_monitor.reasons;
  if (!m_monitor.stops.isEmpty()) parts << tr("Stands at: %1.").arg(m_monitor.stops);
  if (m_isChosen) parts << tr("Its page is shown.");
  setAccessibleDescription(parts.join(QLatin1Char(' ')));
  parts.prepend(details);
  parts.prepend(m_monitor.title);
  setToolTip(parts.join(QLatin1Char('\n')));
}

void MonitorTile::resizeEvent(QResizeEvent*) {
  const int head = kTilePad / 2 + lineHeight(strongFont(font())) + lineHeight(secondaryFont(font()));
  const int foot = lineHeight(secondaryFont(font())) + kTilePad / 2;
  m_dial->setGeometry(kFrame + 1, head, width() - 2 * kFrame - 2, height() - head - foot);
}

void MonitorTile::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

void MonitorTile::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const double stroke = hasFocus() ? kFrame : m_isChosen ? 2 : 1;
  const QColor frame = hasFocus() || m_isChosen ? c.accent.ink : underMouse() ? c.text : c.outline;
  p.setPen(QPen(frame, stroke));
  p.setBrush(c.surface);
  p.drawRoundedRect(QRectF(rect()).adjusted(stroke / 2, stroke / 2, -stroke / 2, -stroke / 2), 6, 6);

  const QFont strong = strongFont(font()), small = secondaryFont(font());
  const QFontMetricsF strongMetrics(strong), smallMetrics(small);
  const double left = kTilePad, right = width() - kTilePad;
  const double first = kTilePad / 2.0 + (lineHeight(strong) + strongMetrics.capHeight()) / 2;
  const double second =
      kTilePad / 2.0 + lineHeight(strong) + (lineHeight(small) + smallMetrics.capHeight()) / 2;

  const QColor health = inkOf(c, inkOf(m_monitor.health.severity()));
  const QString age = ageText(m_monitor.age);
  const double signLeft = right - kTileSign;
  const double ageLeft = signLeft - kTileGap - smallMetrics.horizontalAdvance(age);
  drawGlyph(p, QRectF(signLeft, first - strongMetrics.capHeight() / 2 - kTileSign / 2, kTileSign, kTileSign),
            healthGlyph(m_monitor.health.severity()), health, Qt::transparent, c.stroke);
  p.setFont(strong);
  p.setPen(c.text);
  // The name before the age: the dial has its own.
  const QString name = elidedPin(m_monitor.title, strongMetrics, signLeft - kTileGap - left);
  p.drawText(QPointF(left, first), name);
  p.setFont(small);
  p.setPen(c.textSecondary);
  if (left + strongMetrics.horizontalAdvance(name) + kTileGap <= ageLeft)
    p.drawText(QPointF(ageLeft, first), age);

  // A PIN, then the words of the health; the rest has what they leave.
  double detailLeft = left;
  if (!m_monitor.identity.isEmpty()) {
    const QString pin = elidedPin(m_monitor.identity, smallMetrics, right - left);
    p.drawText(QPointF(left, second), pin);
    detailLeft += smallMetrics.horizontalAdvance(pin) + kTileGap;
  }
  const QString words = wordsThatFit(healthWords(m_monitor.health), smallMetrics, right - detailLeft);
  const double wordsLeft = right - smallMetrics.horizontalAdvance(words);
  p.drawText(QPointF(detailLeft, second),
             smallMetrics.elidedText(m_monitor.detail, Qt::ElideRight, wordsLeft - kTileGap - detailLeft));
  p.setPen(health);
  p.drawText(QPointF(wordsLeft, second), words);

  // At the foot the trouble in words, then the stops in what it leaves.
  const double foot = height() - kTilePad / 2.0 - lineHeight(small) / 2.0;
  const auto drawFoot = [&](double from, Glyph glyph, const QColor& ink, const QString& text) {
    const double textLeft = from + kTileSign + kTileGap / 2;
    if (text.isEmpty() || right <= textLeft) return from;
    drawGlyph(p, QRectF(from, foot - kTileSign / 2, kTileSign, kTileSign), glyph, ink, Qt::transparent,
              c.stroke);
    p.setPen(ink);
    const QString shown = smallMetrics.elidedText(text, Qt::ElideRight, right - textLeft);
    p.drawText(QPointF(textLeft, foot + smallMetrics.capHeight() / 2), shown);
    return textLeft + smallMetrics.horizontalAdvance(shown) + kTileGap;
  };
  const Severity tone = m_monitor.troubleTone;
  const double stopsLeft = drawFoot(left, healthGlyph(tone), inkOf(c, inkOf(tone)), m_monitor.trouble);
  drawFoot(stopsLeft, m_monitor.areStopsStale ? Glyph::Stale : Glyph::Stop,
           m_monitor.areStopsStale ? c.stale.ink : c.text, m_monitor.stops);
}

}  // namespace deckpipe
