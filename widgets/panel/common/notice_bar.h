// SPDX-License-Identifier: GPL-3.0-or-later
// One line that says in words what stands between a person and the picture: nothing is heard, the link went away,
// lines could not be read, the cursor is not at the end. With it what to do about that: a command to copy, a button.
// It stands beside the menus and keeps its place while there is nothing to say, so that a notice moves nothing. What
// has no room in the line unfolds over the work.
#pragma once

#include <QWidget>

#include "panel/common/status_cell.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace deckpipe {

struct Notice {
  enum class Action : std::uint8_t {
    None,
    GoToEnd,
    Reconnect,
    CopyDetails,
    ShowRecordings,
    AddUpTimes,
    ChangeBitRate
  };

  Severity tone = Severity::Plain;
  QString text{};     // empty: no notice
  QString command{};  // for a terminal
  Action action = Action::None;
  QString details{};  // for CopyDetails
  bool canClose = false;
  friend bool operator==(const Notice&, const Notice&) = default;
};

class ElidedLabel;

class NoticeBar : public QWidget {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  void setNotice(const Notice& notice);
  const Notice& notice() const { return m_notice; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 Q_SIGNALS:
  void actionRequested(deckpipe::Notice::Action action);
  void closeRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void act();
  void offerMore();

  Notice m_notice;
  GlyphLabel* m_sign;
  ElidedLabel* m_text;
  QToolButton* m_more;
  QLabel* m_whole;
  QLabel* m_command;
  QPushButton* m_copy;
  QPushButton* m_act;
  QPushButton* m_close;
};

}  // namespace deckpipe
