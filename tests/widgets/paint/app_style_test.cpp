// SPDX-License-Identifier: GPL-3.0-or-later
#include "paint/app_style.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <QWindow>
#include <set>

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

TEST(AppStyle, DrawsNoLineUnderAMenuBar) {
  for (const Theme theme : kThemes) {
    const test::Look look(theme);
    QMenuBar bar;
    bar.addMenu(QStringLiteral("File"));
    bar.addMenu(QStringLiteral("Help"));
    bar.resize(300, bar.sizeHint().height());
    bar.show();
    QCoreApplication::processEvents();
    const QImage image = bar.grab().toImage();
    for (int y = image.height() * 3 / 4; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x)
        ASSERT_EQ(image.pixelColor(x, y), coloursOf(theme).window) << "at " << x << ',' << y;
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

// From 1 m: a ring as thick as three lines, around whatever takes the keys.
TEST(AppStyle, WhateverTakesTheKeysHasAFocusRingInEveryTheme) {
  for (const Theme theme : kThemes) {
    const test::Look look(theme);
    QWidget window;
    auto* row = new QHBoxLayout(&window);
    auto* combo = new QComboBox;
    combo->addItem(QStringLiteral("250 kbit/s"));
    auto* tool = new QToolButton;
    tool->setText(QStringLiteral("Find"));
    tool->setFocusPolicy(Qt::StrongFocus);
    auto* tabs = new QTabBar;
    tabs->addTab(QStringLiteral("Ask"));
    tabs->addTab(QStringLiteral("Change"));
    auto* rows = new QListWidget;
    rows->addItems({QStringLiteral("First"), QStringLiteral("Second")});
    rows->setCurrentRow(0);
    const QList<QWidget*> controls{new QLineEdit,
                                   new QCheckBox(QStringLiteral("Follow")),
                                   combo,
                                   tool,
                                   new QPushButton(QStringLiteral("Connect")),
                                   new QRadioButton(QStringLiteral("Dark")),
                                   new QSpinBox,
                                   tabs,
                                   rows};
    for (QWidget* control : controls) row->addWidget(control);
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    std::set<QWidget*> seen;
    for (int i = 0; i < controls.size(); ++i) {
      QTest::keyClick(window.windowHandle(), Qt::Key_Tab);
      QWidget* control = QApplication::focusWidget();
      ASSERT_NE(control, nullptr);
      seen.insert(control);
      const QImage picture = window.grab(control->geometry()).toImage();
      // On the accent, as a chosen row is, the ring has the colour of the words there.
      const Colours& c = coloursOf(theme);
      const QRgb ring = (control == rows ? c.accent.onFill : c.accent.ink).rgb();
      int pixels = 0;
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) pixels += picture.pixel(x, y) == ring ? 1 : 0;
      EXPECT_GT(pixels, 3 * 40) << control->metaObject()->className() << " in theme "
                                << static_cast<int>(theme);
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(controls.size()));
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
