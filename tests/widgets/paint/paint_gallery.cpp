// SPDX-License-Identifier: GPL-3.0-or-later
// Draws every state in every theme: contact sheets at small sizes, single pictures at full screen, and the
// lamps.
#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <cstdio>

#include "paint/app_style.h"
#include "paint/dial.h"
#include "paint/status_lamp.h"
#include "paint/timeline.h"
#include "widgets/paint/dial_samples.h"

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

QImage picture(QWidget& widget, QSize size, const QColor& ground) {
  widget.resize(size);
  QImage image(size, QImage::Format_RGB32);
  image.fill(ground);
  widget.render(&image);
  return image;
}

QImage dialPicture(const DialSample& sample, Theme theme, QSize size) {
  Dial dial;
  dial.setValues(sample.values);
  dial.setPhase(0.1);
  return picture(dial, size, coloursOf(theme).surface);
}

// One sheet: a row of pictures after another, each over its name.
QImage sheet(Theme theme, QSize size, int columns, size_t first, size_t count) {
  const Colours colours = coloursOf(theme);
  const auto samples = dialSamples();
  const size_t end = std::min(samples.size(), first + count);
  const int rows = (static_cast<int>(end - first) + columns - 1) / columns;
  const int gap = 8, caption = 20;
  QImage image(columns * (size.width() + gap) + gap, rows * (size.height() + caption + gap) + gap,
               QImage::Format_RGB32);
  image.fill(colours.window);
  QPainter painter(&image);
  painter.setPen(colours.text);
  for (size_t i = first; i < end; ++i) {
    const int column = static_cast<int>(i - first) % columns, row = static_cast<int>(i - first) / columns;
    const QPoint at(gap + column * (size.width() + gap), gap + row * (size.height() + caption + gap));
    painter.drawImage(at, dialPicture(samples[i], theme, size));
    painter.drawText(QRect(at.x(), at.y() + size.height(), size.width(), caption), Qt::AlignCenter,
                     QString::fromStdString(samples[i].name));
  }
  return image;
}

QImage lamps(Theme theme) {
  const Colours colours = coloursOf(theme);
  QImage image(4 * 208 + 8, 7 * 40 + 8, QImage::Format_RGB32);
  image.fill(colours.surface);
  QPainter painter(&image);
  int column = 0;
  for (const Severity whenOn : {Severity::Plain, Severity::Fine, Severity::Warning, Severity::Fault}) {
    int row = 0;
    const auto draw = [&](std::optional<Status2> state, bool stale) {
      StatusLamp lamp;
      lamp.setLabel(QStringLiteral("Right"));
      lamp.setWhenOn(whenOn);
      lamp.setState(state, stale);
      painter.drawImage(QPoint(8 + column * 208, 8 + row++ * 40),
                        picture(lamp, QSize(200, 32), colours.surface));
    };
    draw(std::nullopt, false);
    for (const Status2 state : kAllOf<Status2>) draw(state, false);
    draw(Status2::On, true);
    draw(Status2::Off, true);
    ++column;
  }
  return image;
}

struct TimelineSample {
  const char* name;
  TimelineValues values;
  std::optional<TimelineSpan> shown{}, selection{};
};

// A minute of a log in the states that one comes upon.
std::vector<TimelineSample> timelineSamples() {
  const auto at = [](double seconds) { return Instant{static_cast<std::int64_t>(seconds * 1e9)}; };
  TimelineValues usual;
  usual.isEmpty = false;
  usual.begin = at(0);
  usual.end = at(60);
  usual.cursor = at(24);
  usual.atEnd = false;
  for (int i = 0; i < 300; ++i)
    usual.density.push_back(0.35F + 0.3F * static_cast<float>(i % 11 == 0) +
                            0.1F * static_cast<float>(i % 7 == 0));
  const auto thin = [](TimelineValues values, double from, double to) {
    for (std::size_t i = 0; i < values.density.size(); ++i) {
      const double second = 60.0 * static_cast<double>(i) / static_cast<double>(values.density.size());
      if (second >= from && second < to) values.density[i] = 0;
    }
    return values;
  };
  TimelineValues live = usual;
  live.atEnd = true;
  live.cursor = live.end;
  TimelineValues marked = usual;
  marked.marks = {{TimelineMark::Kind::TimeJump, at(17)}};
  for (const EventGroup group : kAllOf<EventGroup>) {
    double second = 4 + 6 * static_cast<double>(group);
    for (const Severity weight : kEventWeights) {
      marked.marks.push_back({TimelineMark::Kind::Event, at(second), {}, group, weight});
      second += 1.5;
    }
  }
  TimelineValues gap = thin(usual, 12, 20);
  gap.gaps = {{TimelineGap::Kind::Silence, {at(12), at(20)}}};
  TimelineValues lost = thin(usual, 36, 60);
  lost.gaps = {{TimelineGap::Kind::LinkLost, {at(36), kNever}}};
  TimelineValues selected = usual;
  selected.selection = QStringLiteral("14.000 s, 4,512 frames, 322/s");
  TimelineValues ended = usual;
  ended.cursor = ended.end;
  return {{"nothing open", {}},
          {"live", live},
          {"paused", usual},
          {"the end of a log", ended},
          {"zoomed", usual, TimelineSpan{at(18), at(30)}},
          {"zoomed, the cursor elsewhere", usual, TimelineSpan{at(40), at(50)}},
          {"selection", selected, {}, TimelineSpan{at(30), at(44)}},
          {"small selection", selected, {}, TimelineSpan{at(57), at(58)}},
          {"marks", marked},
          {"gap", gap},
          {"link lost", lost}};
}

QImage timelines(Theme theme, int width) {
  const Colours colours = coloursOf(theme);
  const std::vector<TimelineSample> samples = timelineSamples();
  constexpr int kHeight = 48, kCaption = 24;
  QImage image(width, static_cast<int>(samples.size()) * (kHeight + kCaption) + 8, QImage::Format_RGB32);
  image.fill(colours.window);
  QPainter painter(&image);
  painter.setPen(colours.text);
  int y = 0;
  for (const TimelineSample& sample : samples) {
    Timeline timeline;
    timeline.setValues(sample.values);
    if (sample.shown) timeline.showSpan(*sample.shown);
    timeline.select(sample.selection);
    painter.drawText(QRect(10, y, width, kCaption), Qt::AlignLeft | Qt::AlignBottom,
                     QString::fromLatin1(sample.name));
    painter.drawImage(QPoint(0, y + kCaption), picture(timeline, {width, kHeight}, colours.window));
    y += kHeight + kCaption;
  }
  return image;
}

int run(const QString& folder) {
  if (!QDir().mkpath(folder)) {
    std::fprintf(stderr, "cannot make the folder\n");
    return 1;
  }
  const QDir dir(folder);
  bool saved = true;
  const auto save = [&](const QImage& image, const QString& name) {
    saved = image.save(dir.filePath(name + QStringLiteral(".png"))) && saved;
  };
  for (const Theme theme : kThemes) {
    QApplication::setStyle(new AppStyle(Density::Desk, theme));
    const QString prefix = QString::fromLatin1(nameOf(theme));
    save(sheet(theme, {200, 200}, 7, 0, 100), prefix + QStringLiteral("_200x200"));
    save(sheet(theme, {200, 120}, 7, 0, 100), prefix + QStringLiteral("_200x120"));
    for (size_t first = 0; first < dialSamples().size(); first += 6)
      save(sheet(theme, {640, 360}, 2, first, 6), prefix + QStringLiteral("_640x360_%1").arg(first / 6 + 1));
    save(lamps(theme), prefix + QStringLiteral("_lamps"));
    save(timelines(theme, 900), prefix + QStringLiteral("_timelines"));
    for (const DialSample& sample : dialSamples())
      save(dialPicture(sample, theme, {1920, 1080}),
           prefix + QStringLiteral("_full_") + QString::fromStdString(sample.name));
  }
  return saved ? 0 : 1;
}

}  // namespace
}  // namespace deckpipe

int main(int argc, char** argv) {
  if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  if (argc != 2) {
    std::fprintf(stderr, "usage: paint_gallery FOLDER\n");
    return 2;
  }
  return deckpipe::run(QString::fromLocal8Bit(argv[1]));
}
