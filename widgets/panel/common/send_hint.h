// SPDX-License-Identifier: GPL-3.0-or-later
// Says why nothing can be sent now, and offers to unlock where it is the lock. Every panel that sends has one
// and gives it the services' status. It takes no room where nothing stands in the way, unless a panel has buttons below
// it, which must not move.
#pragma once

#include <QWidget>

#include "control/status.h"

class QLabel;
class QPushButton;

namespace deckpipe {

class SendHint : public QWidget {
  Q_OBJECT

 public:
  // Its label and button are `prefix`Hint and `prefix`Unlock.
  explicit SendHint(const QString& prefix, QWidget* parent = nullptr);

  // Takes as much room as the longest of its own sentences wants, whatever it says.
  void keepRoom();

  // `own`: what stands in this panel's way where sending as such is possible. `trouble`: what has just gone
  // wrong, said before everything else.
  void setStatus(const ServiceStatus& services, bool isLive, const QString& own, const QString& trouble = {});

 Q_SIGNALS:
  void unlockRequested();

 protected:
  bool event(QEvent* event) override;

 private:
  static QString pausedText();
  static QString noLinkText();
  static QString lockedText();

  bool m_keepsRoom = false;  // before the children: their coming is an event
  QLabel* m_text;
  QPushButton* m_unlock;
};

}  // namespace deckpipe
