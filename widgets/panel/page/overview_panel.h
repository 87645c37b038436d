// SPDX-License-Identifier: GPL-3.0-or-later
// All monitors at once, a tile each, as large as all fit, those in trouble first under a line that counts them. The
// window gives it each new view; it says when a person asks for a monitor's page by click, Enter or Space. Arrow keys,
// Home and End go from tile to tile. A tile belongs to its monitor and takes the focus along; while the pointer is
// among the tiles they keep their places.
#pragma once

#include <QAbstractButton>
#include <QRect>
#include <QSize>
#include <QWidget>

#include <vector>

#include "model/overview_of.h"
#include "panel/common/panel_view.h"

class QLabel;
class QScrollArea;

namespace deckpipe {

// One monitor on the overview: its name, its health, its dial, its trouble and the other stops that it stands at. A button:
// pressed it asks for the monitor's page. Used by OverviewPanel alone.
class Dial;

class MonitorTile : public QAbstractButton {
  Q_OBJECT

 public:
  explicit MonitorTile(QWidget* parent = nullptr);

  void setMonitor(const OverviewMonitor& monitor);
  const OverviewMonitor& monitor() const { return m_monitor; }
  // True if the device page shows this monitor.
  void setChosen(bool chosen);
  void setAnimated(bool animated);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void describe();

  OverviewMonitor m_monitor;
  Dial* m_dial;
  bool m_isChosen = false;
};

// How many tiles stand beside one another in the overview, and how large each is: all of them as large as fit
// at once; where that would be too small to read, at their least size, and the panel scrolls. Pure.
struct OverviewGrid {
  static constexpr int kGap = 8;
  static constexpr QSize kMin{264, 232};
  static constexpr QSize kMax{880, 600};  // larger than this is for a page

  int columns = 1;
  QSize tile = kMin;

  QRect place(int i) const {
    const QPoint step(tile.width() + kGap, tile.height() + kGap);
    return {QPoint(kGap + i % columns * step.x(), kGap + i / columns * step.y()), tile};
  }
  // Of `count` tiles with the gaps around them.
  int height(int count) const;
};

OverviewGrid overviewGrid(int count, const QSize& room);

class MonitorTile;
class UntrackedLabel;

class OverviewPanel : public QWidget {
  Q_OBJECT

 public:
  explicit OverviewPanel(QWidget* parent = nullptr);

  void setView(const PanelView& view);

  QSize sizeHint() const override { return {1032, 560}; }
  QSize minimumSizeHint() const override { return {288, 160}; }

 Q_SIGNALS:
  void pageRequested(const deckpipe::DeviceKey& key);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  MonitorTile* newTile();
  void giveTiles(const std::vector<OverviewMonitor>& monitors);
  void keepPlaces(std::vector<OverviewMonitor>& monitors) const;
  void layOut();
  int count() const { return static_cast<int>(m_tiles.size()); }
  bool moveFocus(int from, int key);
  QString emptyText() const;

  PanelView m_view;
  int m_columns = 1;         // as laid out
  bool m_isPointed = false;  // by a pointer that moved among the tiles
  QLabel* m_empty;
  QLabel* m_summary;
  UntrackedLabel* m_untracked;
  QScrollArea* m_scroll;
  QWidget* m_content;
  std::vector<MonitorTile*> m_tiles;  // in the order of their places
};

}  // namespace deckpipe
