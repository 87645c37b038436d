// SPDX-License-Identifier: GPL-3.0-or-later
// The list of what happened in a log, and which of it is listed. The window gives it each view and puts the
// cursor where a person clicks or presses Enter, or where the next or the previous event of the list is. What
// lies behind the cursor is lighter: it has not happened there.
#pragma once

#include <QWidget>

#include "base/time.h"
#include "panel/common/panel_view.h"

class QLabel;
class QStackedLayout;
class QTreeView;

namespace deckpipe {

class EventDelegate;
class EventFilter;
class EventFilterBar;
class EventModel;
class FlatHeader;
class UntrackedLabel;

class EventPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EventPanel(QWidget* parent = nullptr);

  void setView(const PanelView& view);
  // Puts the cursor at the next or the previous event of the list, or kBefore before the chosen event; with
  // none chosen, before the last event at or before the cursor.
  void goToNext();
  void goToPrevious();
  void goBefore();
  // Puts the cursor where the next fault began, or the previous one, listed or not.
  void goToNextFault();
  void goToPreviousFault();
  static constexpr Duration kBefore = 5s;
  // Whether anything happened, listed or not.
  bool hasEvents() const;
  EventModel* model() const { return m_model; }

  QSize sizeHint() const override { return {560, 200}; }
  QSize minimumSizeHint() const override { return {240, 80}; }

 Q_SIGNALS:
  void seekRequested(deckpipe::Instant time);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showPage();
  void layOutColumns();
  void seek(const QModelIndex& index);
  // Chooses a row of the list, and asks for the cursor to be there, or before it.
  void goTo(int row, Duration before);
  void goToFault(bool isBack);
  // The row that is chosen, if the cursor is where choosing it has put it; -1 otherwise.
  int chosenRow() const;

  EventModel* m_model;
  EventFilter* m_filter;
  EventFilterBar* m_bar;
  EventDelegate* m_delegate;
  QTreeView* m_list;
  FlatHeader* m_header;
  QLabel* m_empty;
  QLabel* m_cut;  // says that more happened than is listed
  UntrackedLabel* m_untracked;
  QStackedLayout* m_pages;
};

}  // namespace deckpipe
