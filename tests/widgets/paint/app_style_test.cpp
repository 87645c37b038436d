// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/app_style.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>

#include "paint/stick_view.h"
#include "support/look.h"

namespace deckpipe {
namespace {

QColor inkOfWords(const QWidget& words) {
  EXPECT_EQ(words.palette().color(QPalette::Text), words.palette().color(QPalette::WindowText));
  return words.palette().color(QPalette::WindowText);
}

TEST(AppStyle, AnyOtherStyleIsPaintedInTheLightTheme) {
  const QWidget widget;
  EXPECT_EQ(coloursOf(&widget), coloursOf(Theme::Light));
  EXPECT_EQ(coloursOf(nullptr), coloursOf(Theme::Light));
}

TEST(AppStyle, GivesItsThemeToWhatIsThereAndToWhatComes) {
  QWidget before;
  before.show();
  for (const Theme theme : kThemes) {
    const test::Look look(theme);
    QWidget after;
    after.show();
    QCoreApplication::processEvents();  // windows get a palette by an event
    for (const QWidget* widget : {&before, &after}) {
      EXPECT_EQ(coloursOf(widget).theme, theme);
      EXPECT_EQ(widget->palette().color(QPalette::Window), coloursOf(theme).window);
    }
  }
}

TEST(AppStyle, AThemeChangeRepaintsWhatIsPainted) {
  const auto picture = [](StickView& view) { return view.grab().toImage(); };
  StickView view;
  view.setValues({0.5, 0.5, false});
  view.show();
  std::vector<QImage> pictures{picture(view)};
  for (const Theme theme : {Theme::Dark, Theme::Sunlight}) {
    const test::Look look(theme);
    pictures.push_back(picture(view));
    EXPECT_NE(pictures.back(), pictures.front());
  }
  EXPECT_NE(pictures[1], pictures[2]);
  EXPECT_EQ(picture(view), pictures.front());
}

TEST(AppStyle, AnInkFollowsTheThemeWhereverTheWordsStand) {
  QWidget window;
  QLabel shown(&window), hidden(&window);
  QLineEdit edit(&window);
  hidden.hide();
  setInk(shown, Ink::Warning);
  setInk(hidden, Ink::Fault);
  setInk(edit, Ink::Secondary);
  window.show();
  for (const Theme theme : kThemes) {
    const test::Look look(theme);
    const Colours& c = coloursOf(theme);
    EXPECT_EQ(inkOfWords(shown), c.warning.ink);
    EXPECT_EQ(inkOfWords(edit), c.textSecondary);
    hidden.show();
    EXPECT_EQ(inkOfWords(hidden), c.fault.ink);
    hidden.hide();
    QLabel late(&window);
    setInk(late, Ink::Stale);
    EXPECT_EQ(inkOfWords(late), c.stale.ink);
  }
}

TEST(AppStyle, TheLastInkHolds) {
  QLabel label;
  setInk(label, Ink::Fault);
  setInk(label, Ink::Text);
  label.show();
  const test::Look look(Theme::Dark);
  EXPECT_EQ(inkOfWords(label), coloursOf(Theme::Dark).text);
}

}  // namespace
}  // namespace deckpipe
