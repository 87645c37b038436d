// SPDX-License-Identifier: GPL-3.0-or-later
// Texts in other languages are longer: with each 40 % longer than the English, nothing of the window is cut
// and the window still fits on a small laptop. And English counts one thing as one.
#include <QAbstractButton>
#include <QApplication>
#include <QSettings>
#include <QTranslator>

#include "app/console/window_scenes.h"
#include "app/console/window_test.h"
#include "console/language.h"
#include "console/status_text.h"
#include "panel/common/labels.h"
#include "support/child.h"

namespace deckpipe {
namespace {

class LongTranslator : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* source, const char*, int) const override {
    const QString text = QString::fromUtf8(source);
    // In words, as texts are that may break; one letter longer at least.
    return text + QStringLiteral(" wwww")
                      .repeated(1 + text.size() * 2 / 25)
                      .left(std::max<qsizetype>(2, text.size() * 2 / 5));
  }
};

// What of a window's words has less room than it needs. Words of one line that end in an ellipsis may.
QStringList cut(const QWidget& window) {
  QStringList names;
  for (const auto* label : window.findChildren<QLabel*>()) {
    // Behind the tab of another dock nothing is laid out.
    if (label->visibleRegion().isEmpty() || label->text().isEmpty()) continue;
    if (qobject_cast<const ElidedLabel*>(label) != nullptr) continue;
    const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
    if (label->height() < needed || (!label->wordWrap() && label->width() < label->sizeHint().width()))
      names += label->objectName() + QLatin1Char('=') + label->text().left(30);
  }
  for (const auto* button : window.findChildren<QAbstractButton*>()) {
    if (!button->visibleRegion().isEmpty() && !button->text().isEmpty() &&
        button->width() < button->minimumSizeHint().width())
      names += button->objectName();
  }
  return names;
}

class LongTexts : public testing::Test {
 protected:
  LongTexts() {
    QSettings().clear();
    QCoreApplication::installTranslator(&m_translator);
  }
  ~LongTexts() override { QCoreApplication::removeTranslator(&m_translator); }
  LongTranslator m_translator;
};

TEST_F(LongTexts, AreNotCutInAnyStateOfTheWindow) {
  Session session;
  MainWindow window(session);
  window.resize(1366, 720);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  for (const test::Scene& scene : test::windowScenes()) {
    window.setSnapshot(scene.snapshot);
    QTest::qWait(0);
    EXPECT_EQ(cut(window).join(QLatin1Char('\n')).toStdString(), "") << scene.name;
    EXPECT_LE(window.width(), 1366) << scene.name;
  }
  for (const char* action : {"settingsAction", "aboutAction"}) {
    test::child<QAction>(window, action)->trigger();
    QTest::qWait(0);
    EXPECT_EQ(cut(window).join(QLatin1Char('\n')).toStdString(), "") << action;
  }
}

TEST(EnglishTexts, CountOneThingAsOne) {
  QTranslator* translator = installLanguage(*qApp);
  ASSERT_NE(translator, nullptr);
  EXPECT_EQ(frameCountText(1).toStdString(), "1 frame");
  EXPECT_EQ(frameCountText(2).toStdString(), "2 frames");
  EXPECT_EQ(errorWords(1).toStdString(), "1 error frame");
  QCoreApplication::removeTranslator(translator);
}

}  // namespace
}  // namespace deckpipe
