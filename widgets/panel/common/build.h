// SPDX-License-Identifier: GPL-3.0-or-later
// Small builders for panels, so that a constructor says what stands where, and little else. `name` is an
// object name, for tests and saved layouts; `spoken` is what a screen reader calls the widget.
#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QFont>
#include <QLabel>
#include <QMenu>
#include <QWheelEvent>
#include <initializer_list>
#include <utility>

#include "paint/palette.h"

class QPushButton;
class QScrollArea;
class QTableView;
class QToolButton;
class QTreeView;

namespace deckpipe {

template <typename Widget>
Widget* named(Widget* widget, const char* name, const QString& spoken) {
  widget->setObjectName(QLatin1String(name));
  widget->setAccessibleName(spoken);
  return widget;
}

// Text of a label, changed only when it changes: a new text lays out anew.
inline void setText(QLabel& label, const QString& text) {
  if (label.text() != text) label.setText(text);
}

// Heavier than the text beside it, and `size` times as large.
QFont strongFont(const QFont& font, double size = 1);
QFont boldFont(const QFont& font);
// The font of what stands beside the matter: types under PINs, words beside values, ages. Smaller than the
// application's own, never below 12 pixels.
QFont secondaryFont(const QFont& font);
// The width of the widest age (text/time_text.h, calmAge), rounded up: a running one moves nothing beside it.
int widestAge(const QFont& font);
// Figures and bytes stand under one another; as large as `font`.
QFont figureFont(const QFont& font);

// Plain words that wrap.
QLabel* makeWords(QWidget* parent, const char* name, const QString& spoken, Ink ink = Ink::Text);
// Words in the middle of an empty place: why there is nothing, or what to do. `margin` in pixels, on each
// side.
QLabel* makeMessage(QWidget* parent, const char* name, const QString& spoken, int margin = 24);
// Words in large letters over a page or a part of one.
QLabel* makeTitle(QWidget* parent, const char* name, const QString& text, double size = 1.5);
// Something to be typed into a terminal, or to be copied.
QLabel* makeCommand(QWidget* parent, const char* name, const QString& spoken);
// Screen readers say the text, or `spoken`.
QPushButton* makeButton(QWidget* parent, const char* name, const QString& text, const QString& spoken = {});
// Screen readers say the tip.
QToolButton* makeToolButton(QWidget* parent, const char* name, const QString& text, const QString& tip);

template <typename... What>
QAction* addNamed(QMenu* menu, const char* name, What&&... what) {
  QAction* action = menu->addAction(std::forward<What>(what)...);
  action->setObjectName(QLatin1String(name));
  return action;
}

// Offers an action, or says in its tip why it cannot be done now. An action's own tip is its What's This.
void offer(QAction& action, const QString& whyNot = {});

// A choice that the wheel does not change: scrolling past it must not begin to poll a bus, or change what
// goes to a device. Used in panels that send.
class CalmCombo : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

// A page in the place of the work until a person closes it: by Escape, or by a button at its end.
class ExtraPage : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

 Q_SIGNALS:
  void closeRequested();

 protected:
  QPushButton* makeDone(const char* name, const QString& spoken);
  void keyPressEvent(QKeyEvent* event) override;
};

// Lists whose rows are chosen as a whole, without frame, grid and edit triggers. Delegates draw the rows.
void makeFlat(QTreeView& list);
void makeFlat(QTableView& table);

// `content` scrolled up and down, without a frame. The keys go to what is inside.
QScrollArea* makeScroll(QWidget* parent, const char* name, QWidget* content);
// Fills `page` with `content`, scrolled.
void fillScrolled(QWidget* page, QWidget* content, const char* name);

// What stands in a row or column: a widget or a layout with its share of the room that is left over, a gap,
// or nothing, which takes what is left over.
struct LayoutPart {
  LayoutPart(QWidget* shown, int itsShare = 0, Qt::Alignment at = {})
      : widget(shown), share(itsShare), alignment(at) {}
  LayoutPart(QLayout* inner, int itsShare = 0) : layout(inner), share(itsShare) {}
  static LayoutPart gap(int pixels) { return {pixels, 0}; }
  static LayoutPart rest() { return {0, 1}; }

  QWidget* widget = nullptr;
  QLayout* layout = nullptr;
  int gapPixels = 0;
  int share = 0;
  Qt::Alignment alignment{};

 private:
  LayoutPart(int pixels, int itsShare) : gapPixels(pixels), share(itsShare) {}
};
using LayoutParts = std::initializer_list<LayoutPart>;

// The layout of `owner`, or without one a part of another. Without margins there are none; without a spacing
// it is the style's, or that of the layout around. Both in pixels.
QHBoxLayout* inRow(QWidget* owner, const QMargins& margins, int spacing, LayoutParts parts);
QHBoxLayout* inRow(QWidget* owner, LayoutParts parts);
QHBoxLayout* inRow(int spacing, LayoutParts parts);
QHBoxLayout* inRow(LayoutParts parts);
QVBoxLayout* inColumn(QWidget* owner, const QMargins& margins, int spacing, LayoutParts parts);
QVBoxLayout* inColumn(QWidget* owner, LayoutParts parts);
QVBoxLayout* inColumn(int spacing, LayoutParts parts);

}  // namespace deckpipe
