// SPDX-License-Identifier: GPL-3.0-or-later
// The trace with everything around it: filter line, how time is said, follow, search, the menus of cells and
// columns, and the same traffic by identifier. The console hands it each view of the log, listens for the
// frame that is looked at (the decode panel shows it) and for the intent to put the cursor at one.
//
//   Ctrl+Shift+F   to the filter line    Ctrl+F        search; F3 and Shift+F3 on and back
//   Space    the frame that is looked at in detail
//   Escape   from the filter line back to the rows; gives a search up, then closes it
#pragma once

#include <QTimer>
#include <QWidget>

#include "model/trace_model.h"
#include "panel/common/panel_view.h"
#include "panel/trace/trace_view.h"

class QLabel;
class QStackedWidget;

namespace deckpipe {

class IdView;
class TraceBar;
class TraceSearchBar;

class TracePanel : public QWidget {
  Q_OBJECT

 public:
  explicit TracePanel(QWidget* parent = nullptr);

  void setView(const PanelView& view);

  // Of what is shown: a row of the trace, or the last frame of an identifier.
  std::optional<std::uint64_t> currentFrame() const;
  void setCurrentFrame(std::optional<std::uint64_t> frame);
  bool isById() const;
  bool isFiltered() const { return m_model->isFiltered(); }
  // In the filter language; what is wrong is said as if it had been typed.
  void setFilter(const QString& expression);
  QString filter() const;
  // Where the cursor would stand so many rows on from where it is: 1 the next row of the trace, −1 the one
  // before. Nothing where there is none.
  std::optional<std::uint64_t> cursorRowsOn(int rows) const;
  // Asks for the cursor there.
  void stepCursor(int rows);

  // Opens the line that looks for a frame; goes to the line of the filter.
  void find();
  void goToFilter();

  // Asks for a file of what is selected, or of all that passes the filter.
  bool hasSelection() const;
  void saveSelection();
  void saveShown();

  // Columns and how time is said, for the caller's settings.
  QByteArray saveState() const;
  bool restoreState(const QByteArray& state);

  TraceView* view() const { return m_view; }
  IdView* ids() const { return m_ids; }
  TraceModel* model() const { return m_model; }

 Q_SIGNALS:
  void currentFrameChanged(std::optional<std::uint64_t> frame);
  // The frame that is looked at is wanted in detail.
  void detailRequested();
  void cursorRequested(std::uint64_t frame);
  // The frames of [begin, end) that pass.
  void saveRequested(std::uint64_t begin, std::uint64_t end, const deckpipe::TraceFilter& filter);
  // Whether steps by row are others than steps by frame.
  void filteredChanged(bool isFiltered);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void layOut();
  void connectParts();
  void makeShortcuts();
  void takeFilter(const TraceFilter& filter);
  void refresh();
  void showCount();
  QString idCount() const;
  void showError();
  void showCellMenu(std::optional<TraceView::Cell> cell, const QPoint& global);
  void showColumnMenu(FlatHeader& header, const QPoint& at);
  void setTimeMode(int mode);
  void setOrder(int order);
  TraceSearchBar* makeSearch();
  void closeSearch();

  QString m_expression;  // of the filter in force
  // While the frames of a row of the traffic by identifier are looked at: the filter before, and theirs.
  struct Row {
    QString before, frames;
  };
  std::optional<Row> m_row;
  std::size_t m_channels = 0;  // that completion knows
  TraceModel* m_model;
  TraceView* m_view;
  IdView* m_ids;
  QStackedWidget* m_pages;
  TraceBar* m_bar;
  QLabel* m_error;
  TraceSearchBar* m_search;
  QTimer m_more;  // while a filter is looked through, or a table is on its way
};

}  // namespace deckpipe
