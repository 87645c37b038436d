// SPDX-License-Identifier: GPL-3.0-or-later
// A monitor's dial over the whole window, to be read from three metres: header and dial, nothing else. A
// child of the window, above all docks, as large as it. DevicePage makes it, gives it every page and takes
// it away when it asks for that: Esc, F11, a double click or its button.
#pragma once

#include <QWidget>

#include "model/device_page_values.h"

class QLabel;

namespace deckpipe {

class Dial;
class PageHeader;

class FullDial : public QWidget {
  Q_OBJECT

 public:
  explicit FullDial(QWidget* window);

  // A page without a dial, or of a device that is not there at the cursor, is said in words: the view stays.
  void setPage(const DevicePageValues& page);
  void setAnimated(bool animated);

 Q_SIGNALS:
  void closed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

 private:
  PageHeader* m_header;
  Dial* m_dial;
  QLabel* m_message;
};

}  // namespace deckpipe
