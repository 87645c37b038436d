// SPDX-License-Identifier: GPL-3.0-or-later
// The left panel: who is on the bus at the cursor, and which device is looked at. The window gives it each
// new view; it says when a person chose another device. What was chosen stays chosen by identity: through
// changes of address, and while the cursor stands where the device was not heard yet. A line over the
// table filters it (Ctrl+F); F2, a double click or the menu edits a label; the menu also sorts, by keyboard.
#pragma once

#include <QWidget>

#include "panel/common/panel_view.h"

class QLabel;
class QLineEdit;
class QStackedWidget;

namespace deckpipe {

class DeviceList;
class DeviceModel;
class DeviceOrder;
class UntrackedLabel;

class DeviceListPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DeviceListPanel(QWidget* parent = nullptr);

  // The device that is chosen there need not be there yet.
  void setView(const PanelView& view);

  QSize sizeHint() const override { return {336, 480}; }
  // A PIN is never cut.
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  // Another device is looked at, or the same one under the PIN that it has said now.
  void deviceSelected(const deckpipe::DeviceKey& key);
  // A person gave a device another label; empty takes it away. It is shown once it comes by setLabels().
  void labelEdited(const deckpipe::Pin& pin, const QString& label);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void choose(const DeviceKey& key);
  void showPage();
  void showMenu(const QPoint& at);
  void showSelection();

  DeviceModel* m_model;
  DeviceOrder* m_order;
  DeviceList* m_list;
  QLineEdit* m_filter;
  QLabel* m_empty;
  UntrackedLabel* m_untracked;
  QStackedWidget* m_pages;
  DeviceKey m_selected;
  bool m_isUpdating = false;  // the list's current row changes by itself then, not by a person
};

}  // namespace deckpipe
