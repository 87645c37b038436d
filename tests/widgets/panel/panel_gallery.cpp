// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the panels in every theme, as wide as the smallest window they are made for.
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <cstdio>

#include "paint/app_style.h"
#include "panel/common/simulator_panel.h"
#include "panel/play/transport_bar.h"
#include "panel/trace/decode_panel.h"
#include "panel/trace/id_view.h"
#include "panel/trace/trace_panel.h"
#include "support/child.h"
#include "widgets/panel/panel_samples.h"
#include "widgets/panel/simulator_samples.h"

namespace deckpipe {
namespace {

constexpr int kWidth = 1366;

struct Gallery {
  QDir folder;
  Theme theme = Theme::Light;
  bool isSaved = true;

  QString prefix() const {
    switch (theme) {
      case Theme::Light: return QStringLiteral("light_");
      case Theme::Dark: return QStringLiteral("dark_");
      case Theme::Sunlight: return QStringLiteral("sunlight_");
    }
    return {};
  }
  void save(QWidget& widget, QSize size, const char* name) {
    widget.resize(size);
    widget.show();
    QApplication::processEvents();
    const QPixmap picture = widget.grab();
    isSaved = picture.save(folder.filePath(prefix() + QString::fromLatin1(name) + QStringLiteral(".png"))) &&
              isSaved;
  }

  void trace(const char* name, const std::shared_ptr<LogDocument>& log, std::optional<std::uint64_t> cursor,
             std::optional<std::uint64_t> current = {}) {
    TraceModel model;
    TraceView view;
    view.setModel(&model);
    view.resize(kWidth, 480);
    view.show();
    model.setView(test::viewOf(log, cursor));
    view.setCurrentFrame(current);
    view.setFocus();
    save(view, {kWidth, 480}, name);
  }

  void tracePanel(const char* name, const std::shared_ptr<LogDocument>& log, const char* filter,
                  const char* search = nullptr) {
    TracePanel panel;
    panel.setView(test::viewOf(log));
    panel.setFilter(QString::fromUtf8(filter));
    panel.resize(kWidth, 420);
    panel.show();
    QElapsedTimer patience;
    patience.start();
    while (panel.model()->isFiltering() && patience.elapsed() < 5000) QApplication::processEvents();
    if (search != nullptr) {
      QTest::keyClick(panel.view(), Qt::Key_F, Qt::ControlModifier);
      test::child<QLineEdit>(panel, "traceSearch")->setText(QString::fromUtf8(search));
      const auto* said = test::child<QLabel>(panel, "traceSearchSaid");
      while (said->text().startsWith(QStringLiteral("Searching…")) && patience.elapsed() < 5000)
        QApplication::processEvents();
    }
    save(panel, {kWidth, 420}, name);
  }

  void byId(const char* name, const std::shared_ptr<LogDocument>& log, const char* filter = "") {
    TracePanel panel;
    panel.setView(test::viewOf(log));
    panel.setFilter(QString::fromUtf8(filter));
    panel.resize(kWidth, 420);
    panel.show();
    test::child<QTabBar>(panel, "traceOrder")->setCurrentIndex(1);
    QElapsedTimer patience;
    patience.start();
    while (panel.ids()->rows()->isBehind() && patience.elapsed() < 5000) QApplication::processEvents();
    save(panel, {kWidth, 420}, name);
  }

  void decode(const char* name, const std::shared_ptr<LogDocument>& log, std::uint64_t frame, QSize size,
              const char* field, const char* pointed = nullptr) {
    DecodePanel panel;
    DecodeModel& model = *panel.model();
    model.setView(test::viewOf(log));
    model.setFrame(frame);
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.index(row, 0).data().toString() == QString::fromLatin1(field))
        panel.list()->setCurrentIndex(model.index(row, 0));
    }
    for (int row = 0; pointed != nullptr && row < model.rowCount(); ++row) {
      if (model.index(row, 0).data().toString() == QString::fromLatin1(pointed))
        Q_EMIT panel.list()->entered(model.index(row, 0));
    }
    save(panel, size, name);
  }

  void transport(const char* name, const LogView& view, const PlayState& play) {
    TransportBar bar;
    bar.resize(kWidth, bar.sizeHint().height());
    bar.setView(view, play);
    save(bar, {kWidth, bar.sizeHint().height()}, name);
  }

  void simulator(const char* name, const SimulatorStatus& status, QSize size) {
    SimulatorPanel panel;
    panel.setStatus(status);
    save(panel, size, name);
  }

  void all() {
    QApplication::setStyle(new AppStyle(Density::Desk, theme));
    const auto busy = test::logOfText(test::busyText(400));
    busy->notes.append({.frame = 300, .time = busy->frames.timeAt(300), .value = note::Mark{"water on"}});
    busy->notes.append({.frame = 900, .time = busy->frames.timeAt(900), .value = note::Dropped{{}, 12}});
    busy->notes.append({.frame = 2000, .time = busy->frames.timeAt(2000), .value = note::LinkDown{}});
    const auto foreign = test::logOfText(test::foreignText(300));
    const std::uint64_t count = busy->frames.count();
    trace("trace_busy", busy, {});
    trace("trace_selected", busy, count / 2 + 2, count / 2 - 3);
    trace("trace_start", busy, 12, 3);
    trace("trace_odd", test::logOfText(test::oddText()), 17, 8);
    trace("trace_empty", nullptr, {});
    trace("trace_foreign", foreign, 500);
    tracePanel("panel_all", busy, "");
    tracePanel("panel_filtered", busy, "pgn=EF00 and sa=80 and rotation_deg>20");
    tracePanel("panel_mistyped", busy, "pgn=EF00 and rotation_deg>left");
    tracePanel("panel_nothing", busy, "id=123");
    tracePanel("panel_found", busy, "", "soft limits");
    tracePanel("panel_not_found", busy, "dir=tx", "elevation_deg>80");
    byId("panel_by_id", busy);
    byId("panel_by_id_filtered", busy, "sa=80 and t>=10 and t<20");
    decode("decode_position", busy, 3, {520, 760}, "Rotation");
    decode("decode_pointed", busy, 3, {520, 760}, "Rotation", "Elevation");
    decode("decode_wide", busy, 3, {kWidth, 300}, "Rotation");
    decode("decode_joystick", busy, 6, {420, 600}, "Stick X");
    decode("decode_none", busy, count, {420, 420}, "");
    std::uint64_t malformed = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (busy->frames[i].length == 3 && busy->frames[i].data[0] == 1) malformed = i;
    }
    decode("decode_malformed", busy, malformed, {520, 420}, "Byte 2");
    transport("transport_empty", test::viewOf(nullptr), {});
    transport("transport_file", test::viewOf(busy, count / 3), {});
    transport("transport_playing", test::viewOf(busy, count / 2), {.isPlaying = true, .speed = 5});
    transport("transport_live", test::viewOf(busy), {.isPlaying = true, .isLive = true});
    transport("transport_past", test::viewOf(busy, count / 2), {.isLive = true});
    transport("transport_skipped", test::viewOf(busy, count / 2),
              {.isPlaying = true, .isLooping = true, .skipsSilences = true, .skipped = 83s});
    transport("transport_timeless", test::viewOf(test::logOfText("can0 123 [1] 11\ncan0 123 [1] 12\n"), 1),
              {});
    simulator("simulator",
              test::simulatorSample({SimulatedFault::RotationSensorError, SimulatedFault::AnswersLate}),
              {320, 620});
    simulator("simulator_high", test::simulatorSample(), {320, 1120});
    simulator("simulator_small", test::simulatorSample(), {280, 360});
    simulator("simulator_none", {}, {320, 300});
  }
};

}  // namespace
}  // namespace deckpipe

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  if (argc != 2) {
    std::fprintf(stderr, "usage: panel_gallery FOLDER\n");
    return 2;
  }
  deckpipe::Gallery gallery;
  gallery.folder = QDir(QString::fromLocal8Bit(argv[1]));
  if (!gallery.folder.mkpath(QStringLiteral("."))) {
    std::fprintf(stderr, "cannot make the folder\n");
    return 1;
  }
  for (const deckpipe::Theme theme : deckpipe::kThemes) {
    gallery.theme = theme;
    gallery.all();
  }
  return gallery.isSaved ? 0 : 1;
}
