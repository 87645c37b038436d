// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the whole window for people: `window_gallery FOLDER` draws every state in every theme, at a
// desk and in the field, at 1366×768.
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QStandardPaths>
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
  return isWell;
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
