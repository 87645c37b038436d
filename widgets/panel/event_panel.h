// SPDX-License-Identifier: GPL-3.0-or-later
// The list of what happened in a log. The window gives it each view and puts the cursor where a person clicks
// or presses Enter. What lies behind the cursor is lighter: it has not happened there.
#pragma once

#include <QWidget>

#include "base/time.h"
#include "paint/palette.h"
#include "state/log_view.h"

class QLabel;
class QStackedLayout;
class QTreeView;

namespace deckpipe {

class EventDelegate;
class EventModel;
class FlatHeader;

class EventPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EventPanel(QWidget* parent = nullptr);

  void setView(const LogView& view);
  void setColours(const Colours& colours);
  EventModel* model() const { return m_model; }

  QSize sizeHint() const override { return {560, 200}; }

 Q_SIGNALS:
  void seekRequested(deckpipe::Instant time);

 private:
  void showPage();
  void layOutColumns();
  void seek(const QModelIndex& index);

  EventModel* m_model;
  EventDelegate* m_delegate;
  QTreeView* m_list;
  FlatHeader* m_header;
  QLabel* m_empty;
  QStackedLayout* m_pages;
};

}  // namespace deckpipe
