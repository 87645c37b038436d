// SPDX-License-Identifier: GPL-3.0-or-later
// All monitors at once, a tile each, as large as all fit. The window gives it each new view; it says when a
// person asks for a monitor's page by click, Enter or Space. Arrow keys, Home and End go from tile to tile.
#pragma once

#include <QWidget>
#include <vector>

#include "model/overview_of.h"
#include "panel/common/panel_view.h"

class QLabel;
class QScrollArea;

namespace deckpipe {

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
  void addTile();
  void layOut();
  bool moveFocus(int from, int key);
  QString emptyText() const;

  PanelView m_view;
  int m_count = 0;    // tiles in use, the first ones
  int m_columns = 1;  // as laid out
  QLabel* m_empty;
  UntrackedLabel* m_untracked;
  QScrollArea* m_scroll;
  QWidget* m_content;
  std::vector<MonitorTile*> m_tiles;
};

}  // namespace deckpipe
