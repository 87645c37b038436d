// SPDX-License-Identifier: GPL-3.0-or-later
// The line that looks for a frame in the trace: text that a row shows, or an expression of the filter
// language. Opened with Ctrl+F below the rows; looks on as one types, F3 and Shift+F3 go on and back. While
// it searches it says how far it is; Escape gives that up, and otherwise closes it. The trace panel gives it
// the log at each question.
#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>

#include "model/trace_search.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace deckpipe {

class TraceSearchBar : public QWidget {
  Q_OBJECT

 public:
  struct Way {
    bool isBackwards = false;
    bool isHereToo = false;  // the frame where the search begins may be found
  };
  // What is searched and from where, made by the panel: `wanted` and the direction are filled in here.
  using Where = std::function<TraceSearch::Question(Way way)>;

  explicit TraceSearchBar(Where where, QWidget* parent = nullptr);

  void open();
  void findNext() { find({}); }
  void findPrevious() { find({.isBackwards = true}); }
  // What Escape does, here and in the rows.
  void giveUpOrClose();
  // The log is another: what is under way is of no use.
  void forget();
  QLineEdit* edit() const { return m_edit; }
  QString said() const;

 Q_SIGNALS:
  void frameFound(quint64 frame);
  void closed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void find(Way way);
  void say(const QString& text, bool isWarning = false);
  void sayProgress();

  const Where m_where;
  TraceSearch m_search;
  QTimer m_tick;
  bool m_isBackwards = false;
  QLineEdit* m_edit;
  QToolButton* m_previous;
  QToolButton* m_next;
  QToolButton* m_close;
  QLabel* m_said;
};

}  // namespace deckpipe
