// SPDX-License-Identifier: GPL-3.0-or-later
// The demo's own panel: breaks the devices of the simulated truck while a person watches what the console
// makes of it. The window has it in the demo only, gives it each SimulatorStatus that the simulator
// publishes, and passes its intents on. What is ticked is what the simulator says, so an intent that was not
// obeyed does not stay.
#pragma once

#include <QWidget>
#include <array>

#include "control/simulator_control.h"

class QAbstractButton;
class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QStackedLayout;

namespace deckpipe {

class GlyphLabel;
class TickBox;

class SimulatorPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SimulatorPanel(QWidget* parent = nullptr);

  QSize sizeHint() const override { return {320, 560}; }

 public Q_SLOTS:
  void setStatus(const deckpipe::SimulatorStatus& status);

 Q_SIGNALS:
  void simulatorIntended(const deckpipe::SimulatorIntent& intent);

 private:
  QWidget* makeControls();
  QWidget* makeFaults();
  QPushButton* makeAction(const char* name, const QString& text, decltype(SimulatorIntent::what) what);
  const SimulatedDevice* device() const;
  void intent(decltype(SimulatorIntent::what) what);
  static QString faultText(SimulatedFault fault);
  void listDevices();
  void showDevice();
  void showState(const SimulatedDevice& device);

  SimulatorStatus m_status;
  QStackedLayout* m_pages;
  QLabel* m_empty;
  QLabel* m_remark = nullptr;
  QComboBox* m_devices = nullptr;
  GlyphLabel* m_sign = nullptr;
  QLabel* m_state = nullptr;
  QPushButton* m_powerOff = nullptr;
  QPushButton* m_powerOn = nullptr;
  QPushButton* m_reset = nullptr;
  QPushButton* m_allWell = nullptr;
  QScrollArea* m_scroll = nullptr;
  EnumArray<SimulatedFault, TickBox*> m_faults;
};

}  // namespace deckpipe
