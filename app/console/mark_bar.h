// SPDX-License-Identifier: GPL-3.0-or-later
// A line above the timeline for a person's words at a place of the log: Enter keeps them, Escape does not.
// The place is the cursor's when the line was opened, however long the words take.
#pragma once

#include <QWidget>

#include "state/log_view.h"

class QLabel;
class QLineEdit;

namespace deckpipe {

class MarkBar : public QWidget {
  Q_OBJECT
 public:
  explicit MarkBar(QWidget* parent = nullptr);

  void open(const LogView& view);

 Q_SIGNALS:
  void marked(deckpipe::Cursor at, const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void keep();
  void leave();

  Cursor m_at;
  QLabel* m_label;
  QLineEdit* m_text;
};

}  // namespace deckpipe
