// SPDX-License-Identifier: GPL-3.0-or-later
// Asks the chosen device: polls, once or repeated, each with its last answer in words and how the request went; apart
// from them, on a tab of their own, the guarded commands, which change the device. Below, earlier answers and what
// changed. The window gives it the view, what was said in the log, the services' status and the chosen device; it emits
// intents and sends nothing.
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "control/intent.h"
#include "panel/common/danger_dialog.h"
#include "panel/common/panel_view.h"

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QTreeView;

namespace deckpipe {

class AnswerHistory;
class RequestCard;
struct RequestCardValues;
class FlatHeader;
class RepeatBar;
class SendHint;

class RequestPanel : public QWidget {
  Q_OBJECT

 public:
  explicit RequestPanel(QWidget* parent = nullptr);

  void setView(const PanelView& view);
  // Every poll that the device takes, once. Behind the lock the person is asked to unlock first, and the device
  // is asked once the console has an address.
  void askAll();
  bool canAskAll() const;

  QSize sizeHint() const override { return {360, 560}; }

 Q_SIGNALS:
  void intended(const deckpipe::Intent& intent);
  void unlockRequested();
  // Sending is to be unlocked for something; `then` is called where the person does.
  void unlockForRequested(const std::function<void()>& then);
  void frameRequested(std::uint64_t frame);

 private:
  QWidget* makePolls();
  QWidget* makeCommands();
  QScrollArea* scrolled(const char* name, QWidget* content);
  void showPolls(const DeviceServices* device);
  void showState();
  void offerPeriods(bool isOffered);
  // What the log says up to the cursor, whoever asked. `withMissing`: also that no answer came.
  RequestCardValues loggedValues(Request request, bool withMissing) const;
  void showCard(RequestCard& card, const DeviceServices* device);
  bool isBehindLock() const;
  bool takesPolls() const;
  void press(Request request);
  void ask(Request command);
  void askOnceUnlocked();
  void unlockFor(RequestSet requests);
  void repeat(int index);
  QString stateText(Request request, const RequestStatus& status, bool& isFine) const;

  const ServiceStatus& services() const { return *m_view.services; }

  // What is asked once sending is unlocked and the console has an address; a command after a question of its own.
  struct Waiting {
    RequestSet requests;
    DeviceKey device;
    Instant since;
  };

  Instant now() const { return std::max(m_view.log.cursor.time, m_view.log.end); }

  PanelView m_view;
  DeviceQuestion m_question;
  std::optional<Waiting> m_waiting;

  QLabel* m_title = nullptr;
  SendHint* m_hint = nullptr;
  RepeatBar* m_repeats = nullptr;
  QPushButton* m_askAll = nullptr;
  QPushButton* m_askEveryone = nullptr;
  QPushButton* m_cancel = nullptr;
  QComboBox* m_repeat = nullptr;
  EnumArray<Request, RequestCard*> m_cards;
  QLabel* m_none = nullptr;
  QLabel* m_noCommand = nullptr;
  AnswerHistory* m_history;
  QTreeView* m_historyView = nullptr;
  FlatHeader* m_historyHeader = nullptr;
};

}  // namespace deckpipe
