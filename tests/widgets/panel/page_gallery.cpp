// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the device table and the page of every scene in every theme: `page_gallery FOLDER [SCENE]`.
#include <QApplication>
#include <QDir>
#include <QHBoxLayout>
#include <QPixmap>
#include <cstdio>

#include "paint/app_style.h"
#include "panel/devices/device_list_panel.h"
#include "panel/page/device_page.h"
#include "panel/page/full_dial.h"
#include "panel/page/overview_panel.h"
#include "widgets/panel/panel_scenes.h"

namespace deckpipe {
namespace {

const char* nameOf(Theme theme) {
  switch (theme) {
    case Theme::Light: return "light";
    case Theme::Dark: return "dark";
    case Theme::Sunlight: return "sunlight";
  }
  return "";
}

QPixmap picture(const test::PanelScene& scene, QSize size, bool hasTable) {
  QWidget window;
  auto* layout = new QHBoxLayout(&window);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* panel = new DeviceListPanel;
  auto* page = new DevicePage;
  panel->setFixedWidth(332);
  panel->setVisible(hasTable);
  if (hasTable) layout->addWidget(panel);
  layout->addWidget(page, 1);
  window.resize(size);
  window.show();
  PanelView view(scene.view);
  view.device = scene.device;
  view.labels = scene.labels;
  panel->setView(view);
  page->setView(view);
  for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  QPixmap result = window.grab();
  if (!hasTable) delete panel;
  return result;
}

QPixmap full(const test::PanelScene& scene, QSize size) {
  QWidget window;
  DevicePage page(&window);
  window.resize(size);
  window.show();
  PanelView view(scene.view);
  view.device = scene.device;
  page.setView(view);
  page.toggleFull();
  for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  return window.grab();
}

QPixmap overview(const LogView& view, QSize size) {
  OverviewPanel panel;
  panel.resize(size);
  panel.show();
  PanelView shown(view);
  shown.labels = test::sceneLabels();
  shown.device = test::keyOfA();
  panel.setView(shown);
  for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
  return panel.grab();
}

int run(const QString& folder, const QString& only) {
  if (!QDir().mkpath(folder)) {
    std::fprintf(stderr, "cannot make the folder\n");
    return 1;
  }
  const QDir dir(folder);
  bool isSaved = true;
  for (const test::PanelScene& scene : test::panelScenes()) {
    const QString name = QString::fromStdString(scene.name);
    if (!only.isEmpty() && name != only) continue;
    for (const Theme theme : kThemes) {
      QApplication::setStyle(new AppStyle(Density::Desk, theme));
      const auto save = [&](QSize size, bool hasTable, const char* suffix) {
        const QString file = QStringLiteral("%1_%2%3.png")
                                 .arg(name, QString::fromLatin1(nameOf(theme)), QString::fromLatin1(suffix));
        isSaved = picture(scene, size, hasTable).save(dir.filePath(file)) && isSaved;
      };
      save({1366, 500}, true, "");
      if (theme == Theme::Light) {
        save({1366, 900}, true, "_high");
        save({560, 1100}, false, "_narrow");
      }
      const bool hasDial = devicePageOf(scene.view, scene.device).dial.has_value();
      const QString file = QStringLiteral("%1_%2_full.png").arg(name, QString::fromLatin1(nameOf(theme)));
      if (hasDial) isSaved = full(scene, {1366, 768}).save(dir.filePath(file)) && isSaved;
    }
  }
  for (const int count : {0, 1, 2, 4, 7, 30}) {
    if (!only.isEmpty() && only != QStringLiteral("overview")) break;
    for (const Theme theme : kThemes) {
      QApplication::setStyle(new AppStyle(Density::Desk, theme));
      const QString file = QStringLiteral("overview_%1_%2.png")
                               .arg(count, 2, 10, QLatin1Char('0'))
                               .arg(QString::fromLatin1(nameOf(theme)));
      isSaved = overview(test::manyMonitors(count), {1030, 500}).save(dir.filePath(file)) && isSaved;
    }
  }
  return isSaved ? 0 : 1;
}

}  // namespace
}  // namespace deckpipe

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QLocale::setDefault(QLocale::c());
  const QApplication application(argc, argv);
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: page_gallery FOLDER [SCENE]\n");
    return 2;
  }
  return deckpipe::run(QString::fromLocal8Bit(argv[1]),
                       argc > 2 ? QString::fromLocal8Bit(argv[2]) : QString());
}
