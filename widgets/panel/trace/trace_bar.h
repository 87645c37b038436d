// SPDX-License-Identifier: GPL-3.0-or-later
// The line above the trace: in order or by identifier, the filter, how much passes it, how time is said, and
// whether the end is followed. The trace panel listens to it and tells it what holds.
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QTabBar;
class QToolButton;

namespace deckpipe {

class TraceFilterEdit;

class TraceBar : public QWidget {
  Q_OBJECT

 public:
  enum Order { InOrder, ById };
  static constexpr int kTimeModes = 4;

  explicit TraceBar(QWidget* parent = nullptr);

  TraceFilterEdit* filter() const { return m_filter; }
  void setOrder(int order);
  void setTimeMode(int mode);
  void setFollowing(bool isFollowing);
  void setCount(const QString& text);

 Q_SIGNALS:
  void orderChosen(int order);
  void timeModeChosen(int mode);
  void followToggled(bool isFollowing);

 private:
  void makeHelp();

  TraceFilterEdit* m_filter;
  QTabBar* m_order;
  QToolButton* m_help;
  QLabel* m_count;
  QComboBox* m_time;
  QCheckBox* m_follow;
};

}  // namespace deckpipe
