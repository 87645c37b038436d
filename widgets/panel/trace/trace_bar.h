// SPDX-License-Identifier: GPL-3.0-or-later
// The line above the trace: in order or by identifier, the filter, how much passes it, how time is said, and
// whether the end is followed. The trace panel listens to it and tells it what holds. Where it is narrow, the
// count goes before the filter becomes too short to write in, then the time, then following.
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QTabBar;
class QToolButton;

namespace deckpipe {

class ElidedLabel;
class TraceFilterEdit;

class TraceBar : public QWidget {
  Q_OBJECT

 public:
  enum Order { InOrder, ById };

  explicit TraceBar(QWidget* parent = nullptr);

  TraceFilterEdit* filter() const { return m_filter; }
  void setOrder(int order);
  void setTimeMode(int mode);
  void setFollowing(bool isFollowing);
  void setCount(const QString& text);
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void orderChosen(int order);
  void timeModeChosen(int mode);
  void followToggled(bool isFollowing);
  void findRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void makeHelp();
  void measureCount();
  void fit();

  TraceFilterEdit* m_filter;
  QTabBar* m_order;
  QToolButton* m_help;
  QToolButton* m_find;
  ElidedLabel* m_count;
  QComboBox* m_time;
  QCheckBox* m_follow;
};

}  // namespace deckpipe
