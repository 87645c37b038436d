// SPDX-License-Identifier: GPL-3.0-or-later
// The first line of a page, which never scrolls away: which device this is, where it is heard, how long ago,
// and how it is.
#pragma once

#include <QWidget>

#include "model/device_page_values.h"

class QLabel;
class QToolButton;

namespace deckpipe {

class FullButton;
class GlyphLabel;

class PageHeader : public QWidget {
  Q_OBJECT

 public:
  explicit PageHeader(QWidget* parent = nullptr);

  void setPage(const DevicePageValues& page);
  // Whether the button is there that spreads the dial over the window, and what it does now.
  void setFullOffered(bool isOffered);
  void setTraceOffered(bool isOffered);
  void setFull(bool isFull);
  // Keys go to the page below.
  void setMarked(bool isMarked);

  // Its texts give way: the page is never wider for them.
  QSize minimumSizeHint() const override { return {240, QWidget::minimumSizeHint().height()}; }

 Q_SIGNALS:
  void fullRequested();
  // The device's frames are wanted in the trace.
  void traceRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void setFonts();
  // Gives up the age, then the place's end, before the words of the health.
  void fitLine();
  // As much of the texts as has room; the tooltips say all.
  void showTexts();

  Health m_health;
  QString m_titleText;
  QString m_typeText;
  QLabel* m_title;
  QLabel* m_type;
  QLabel* m_place;
  QLabel* m_age;
  GlyphLabel* m_sign;
  QLabel* m_word;
  QToolButton* m_trace;
  FullButton* m_full;
  int m_widestWord = 0;
  bool m_isTraceOffered = false;
  bool m_isMarked = false;
};

}  // namespace deckpipe
