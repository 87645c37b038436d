// SPDX-License-Identifier: GPL-3.0-or-later
// One monitor on the overview: its name, its health, its dial, its trouble and the other stops that it stands at. A button:
// pressed it asks for the monitor's page. Used by OverviewPanel alone.
#pragma once

#include <QAbstractButton>

#include "model/overview_of.h"

namespace deckpipe {

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

}  // namespace deckpipe
