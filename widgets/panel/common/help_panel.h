// SPDX-License-Identifier: GPL-3.0-or-later
// Explains what has the focus: what it is, what it shows now, what that means and where that is written. The
// workspace keeps it in a dock that F1 opens. It reads what every widget and row says of itself for tooltips
// and screen readers, so that nothing has to be written twice.
#pragma once

#include <QPersistentModelIndex>
#include <QPointer>
#include <QTimer>
#include <QWidget>

class QAbstractItemView;
class QLabel;

namespace deckpipe {

class HelpPanel : public QWidget {
  Q_OBJECT

 public:
  explicit HelpPanel(QWidget* parent = nullptr);

  // Null: nothing has the focus.
  void explain(QWidget* widget);
  QString text() const;

  QSize sizeHint() const override { return {320, 200}; }

 protected:
  bool event(QEvent* event) override;

 private:
  void showExplanation();

  QPointer<QWidget> m_widget;
  QMetaObject::Connection m_rows;
  QTimer m_again;  // what is explained goes on changing
  QLabel* m_title;
  QLabel* m_now;
  QLabel* m_story;
};

}  // namespace deckpipe
