// SPDX-License-Identifier: GPL-3.0-or-later
// Everything in the window that sends, as actions: the transmit lock, and what is asked of every device. The
// main window puts the menu into its bar, gives it each snapshot, and hands it the intents of the panels.
#pragma once

#include <QObject>
#include <functional>

#include "session/session.h"

class QAction;
class QMenu;
class QWidget;

namespace deckpipe {

class SendingActions : public QObject {
  Q_OBJECT

 public:
  // `window` is where questions are asked.
  SendingActions(Session& session, QWidget* window);

  QMenu* menu() const { return m_menu; }
  void setSnapshot(const Snapshot& snapshot);

 public Q_SLOTS:
  void intent(const deckpipe::Intent& intent);
  // Unlocking is a deliberate act: it asks once. Locking is not. `then` is called where the person unlocks.
  void askToUnlock(const std::function<void()>& then = {});
  void lock();
  void toggleLock() { m_isLocked ? askToUnlock() : lock(); }

 private:
  Session& m_session;
  QWidget* m_window;
  QMenu* m_menu;
  QAction* m_lock;
  QAction* m_names;
  QAction* m_everyone;
  QAction* m_stop;
  QAction* m_endRepeats;
  bool m_isLocked = true;
};

// Who this installation is on a bus: its identity number, made up once and kept in the settings, and the
// address it would like. F9 replaces a kept address that addressUse() refuses.
ClaimSettings claimSettings();
// Takes such an address out of the settings and returns it, for saying so once; nothing if there is none.
std::optional<Address> dropRefusedAddress();
void keepClaimSettings(const ClaimSettings& claim);

}  // namespace deckpipe
