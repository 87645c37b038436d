// SPDX-License-Identifier: GPL-3.0-or-later
// Asks the chosen device: polls, once or repeated, and the guarded commands, each with its last answer in
// words and how the request went; below, earlier answers and what changed. The window gives it the view, what
// was said in the log, the services' status and the chosen device; it emits intents and sends nothing.
#pragma once

#include <QWidget>
#include <array>

#include "control/intent.h"
#include "panel/common/panel_view.h"

class QComboBox;
class QLabel;
class QPushButton;
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

  QSize sizeHint() const override { return {360, 560}; }

 Q_SIGNALS:
  void intended(const deckpipe::Intent& intent);
  void unlockRequested();
  void frameRequested(std::uint64_t frame);

 private:
  QWidget* makeRequests();
  void showState();
  void offerPeriods(bool isOffered);
  // What the log says up to the cursor, whoever asked. `withMissing`: also that no answer came.
  RequestCardValues loggedValues(Request request, bool withMissing) const;
  void showCard(RequestCard& card, const DeviceServices* device);
  void press(Request request);
  void repeat(int index);
  QString stateText(Request request, const RequestStatus& status, bool& isFine) const;

  const ServiceStatus& services() const { return *m_view.services; }

  PanelView m_view;

  QLabel* m_title = nullptr;
  SendHint* m_hint = nullptr;
  RepeatBar* m_repeats = nullptr;
  QPushButton* m_askAll = nullptr;
  QPushButton* m_askEveryone = nullptr;
  QPushButton* m_cancel = nullptr;
  QComboBox* m_repeat = nullptr;
  EnumArray<Request, RequestCard*> m_cards;
  QLabel* m_none = nullptr;
  AnswerHistory* m_history;
  QTreeView* m_historyView = nullptr;
  FlatHeader* m_historyHeader = nullptr;
};

}  // namespace deckpipe
