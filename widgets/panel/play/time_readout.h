// SPDX-License-Identifier: GPL-3.0-or-later
// Where the cursor is, in figures that do not move: the time since the log's begin, under it the time of day
// that the log gives; in a log without times the number of frames. A click asks for the field in which another place
// is typed (time_field.h).
#pragma once

#include <QAbstractButton>
#include <cstdint>
#include <optional>

#include "base/time.h"
#include "state/log_view.h"
#include "text/time_text.h"

namespace deckpipe {

// The time of day here, "2023-11-14 22:13:20.000"; seconds where the log counts from something else than
// 1970.
QString stampTimeText(std::int64_t stampNs);
// What the log's own clock says at the cursor; nothing before the first frame and in logs without times.
std::optional<std::int64_t> stampAt(const LogView& view);

class TimeReadout : public QAbstractButton {
  Q_OBJECT

 public:
  explicit TimeReadout(QWidget* parent = nullptr);

  void setView(const LogView& view);
  QString elapsed() const { return m_elapsed; }
  QString absolute() const { return m_absolute; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QFont elapsedFont() const;

  QString m_elapsed;
  QString m_absolute;
};

}  // namespace deckpipe
