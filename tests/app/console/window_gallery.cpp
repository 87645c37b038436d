// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the whole window for people: `window_gallery FOLDER` draws every state in every theme, at a
// desk and in the field, at 1366×768; what must be found at a glance also at the other sizes.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QPixmap>
#include <QStandardPaths>
#include <QTabWidget>
#include <cstdio>

#include "app/console/window_scenes.h"
#include "console/language.h"
#include "console/main_window.h"
#include "support/child.h"

namespace {

using namespace deckpipe;

void settle() {
  for (int i = 0; i < 3; ++i) {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();  // a picture is no program: nothing else runs here
  }
}

bool save(MainWindow& window, const QDir& folder, const QString& name) {
  settle();
  const QString path = folder.filePath(name + QStringLiteral(".png"));
  if (window.grab().save(path)) return true;
  std::fprintf(stderr, "%s cannot be written\n", qPrintable(path));
  return false;
}

struct Screen {
  const char* name;
  QSize size;
  int scale = 1;
};
const Screen kScreens[] = {{"1024x600", {1024, 600}},
                           {"1366x768", {1366, 768}},
                           {"1920x1080", {1920, 1080}},
                           {"4k", {1920, 1080}, 2}};

bool saveScaled(MainWindow& window, const QDir& folder, const QString& name, int scale) {
  settle();
  QPixmap picture(window.size() * scale);
  picture.setDevicePixelRatio(scale);
  window.render(&picture);
  return picture.save(folder.filePath(name + QStringLiteral(".png")));
}

// Thirty monitors of which three are in trouble, and the page with one notice and with three.
bool drawScreens(MainWindow& window, const QDir& folder, const QString& theme) {
  bool isWell = true;
  const auto click = [&](const char* action) { test::child<QAction>(window, action)->trigger(); };
  const QString saved = folder.filePath(QStringLiteral("saved by the gallery.log"));
  for (const Screen& screen : kScreens) {
    window.resize(screen.size);
    const auto draw = [&](const char* name) {
      const QString file =
          QStringLiteral("%1_%2_%3").arg(QLatin1String(name), QLatin1String(screen.name), theme);
      isWell = saveScaled(window, folder, file, screen.scale) && isWell;
    };
    window.setSnapshot(test::windowScenes()[0].snapshot);
    window.setSnapshot(test::fleetOfMonitors());
    click("resetLayoutAction");
    click("overviewAction");
    draw("overview");
    click("devicePageAction");
    window.setSnapshot(test::linkLost());
    click("resetLayoutAction");
    draw("one_notice");
    click("markAction");
    window.saveLog(saved);
    Snapshot both = test::linkLost();
    both.notSent = Refusal::NoLink;
    window.setSnapshot(both);
    draw("three_notices");
    test::child<QAbstractButton>(window, "markCancel")->click();
    // Once to break off what may still be saved, once to close the line.
    for (int i = 0; i < 2; ++i) {
      settle();
      test::child<QAbstractButton>(window, "saveButton")->click();
    }
    settle();
  }
  window.resize(1366, 768);
  click("resetLayoutAction");
  return isWell;
}

bool drawChange(MainWindow& window, const QDir& folder, const QString& theme) {
  window.setSnapshot(test::askingSnapshot());
  test::child<QDockWidget>(window, "requestsDock")->show();
  auto* tabs = test::child<QTabWidget>(window, "requestTabs");
  tabs->setCurrentIndex(1);
  bool isWell = save(window, folder, QStringLiteral("change_") + theme);
  for (auto* card : window.findChildren<QWidget*>()) {
    auto* button = card->findChild<QAbstractButton*>(QStringLiteral("askButton"), Qt::FindDirectChildrenOnly);
    if (button == nullptr || !button->isVisible() || !button->isEnabled()) continue;
    button->click();
    settle();
    if (QWidget* question = QApplication::activeModalWidget()) {
      isWell = question->grab().save(folder.filePath(QStringLiteral("danger_%1.png").arg(theme))) && isWell;
      question->close();
    }
    break;
  }
  settle();
  tabs->setCurrentIndex(0);
  test::child<QAction>(window, "resetLayoutAction")->trigger();
  return isWell;
}

bool drawTheme(MainWindow& window, const QDir& folder, const QString& theme) {
  bool isWell = true;
  for (const test::Scene& scene : test::windowScenes()) {
    window.setSnapshot(scene.snapshot);
    isWell = save(window, folder, QLatin1String(scene.name) + QLatin1Char('_') + theme) && isWell;
  }
  window.setSnapshot(test::windowScenes()[1].snapshot);
  for (const char* action : {"settingsAction", "aboutAction"}) {
    test::child<QAction>(window, action)->trigger();
    isWell = save(window, folder, QLatin1String(action).chopped(6) + QLatin1Char('_') + theme) && isWell;
  }
  window.setSnapshot(test::windowScenes()[0].snapshot);
  window.setSnapshot(test::windowScenes()[1].snapshot);
  test::child<QAction>(window, "explainAction")->trigger();
  test::child<QDockWidget>(window, "eventsDock")->raise();
  isWell = save(window, folder, QStringLiteral("events_and_help_") + theme) && isWell;
  test::child<QAction>(window, "resetLayoutAction")->trigger();
  window.setSnapshot(
      test::snapshotOf(test::eventfulText(), SourceStatus::Kind::File, SourceStatus::Progress::Done));
  test::child<QDockWidget>(window, "eventsDock")->raise();
  isWell = save(window, folder, QStringLiteral("events_") + theme) && isWell;
  window.resize(1024, 600);
  isWell = save(window, folder, QStringLiteral("events_small_") + theme) && isWell;
  window.resize(1366, 768);
  test::child<QAction>(window, "resetLayoutAction")->trigger();
  // The last values behind a link that is down are not current, on the page and on its dial over the whole stage.
  window.setSnapshot(test::linkLost());
  window.resize(1024, 600);
  isWell = save(window, folder, QStringLiteral("link_lost_small_") + theme) && isWell;
  window.resize(1366, 768);
  test::child<QAction>(window, "resetLayoutAction")->trigger();
  for (const auto& [name, snapshot] : {std::pair("asking_", test::askingSnapshot()),
                                       std::pair("asking_locked_", test::windowScenes()[7].snapshot)}) {
    window.setSnapshot(snapshot);
    test::child<QDockWidget>(window, "requestsDock")->show();
    test::child<QDockWidget>(window, "terminalDock")->raise();
    isWell = save(window, folder, QLatin1String(name) + theme) && isWell;
  }
  test::child<QAction>(window, "resetLayoutAction")->trigger();
  isWell = drawChange(window, folder, theme) && isWell;
  return drawScreens(window, folder, theme) && isWell;
}

}  // namespace

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QStandardPaths::setTestModeEnabled(true);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("DeckpipeGallery"));
  QLocale::setDefault(QLocale::c());
  installLanguage(application);
  if (argc != 2 || !QDir().mkpath(QString::fromLocal8Bit(argv[1]))) {
    std::fprintf(stderr, "usage: window_gallery FOLDER\n");
    return 2;
  }
  const QDir folder(QString::fromLocal8Bit(argv[1]));
  Session session;
  MainWindow window(session);
  window.resize(1366, 768);
  window.show();
  bool isWell = true;
  const std::pair<Theme, const char*> themes[] = {
      {Theme::Light, "light"}, {Theme::Dark, "dark"}, {Theme::Sunlight, "sunlight"}};
  for (const auto& [theme, name] : themes) {
    window.setTheme(theme);
    window.setDensity(Density::Desk);
    isWell = drawTheme(window, folder, QLatin1String(name)) && isWell;
    window.setDensity(Density::Field);
    isWell = drawTheme(window, folder, QLatin1String(name) + QStringLiteral("_field")) && isWell;
  }
  return isWell ? 0 : 1;
}
