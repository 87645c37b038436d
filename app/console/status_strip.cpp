// SPDX-License-Identifier: GPL-3.0-or-later
#include "status_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>

#include "paint/glyph.h"

namespace deckpipe {
namespace {

enum class Condition { Idle, Busy, Fine, Attend, Fault };

Condition conditionOf(const SourceStatus& source) {
  using Progress = SourceStatus::Progress;
  switch (source.progress) {
    case Progress::Idle: return Condition::Idle;
    case Progress::Opening: return Condition::Busy;
    case Progress::Running:
    case Progress::Done: return source.unreadable + source.notKept == 0 ? Condition::Fine : Condition::Attend;
    case Progress::Lost:
    case Progress::Failed: return Condition::Fault;
  }
  return Condition::Idle;
}

}  // namespace

// The condition as a glyph; its words stand beside it.
class StatusStrip::Lamp : public QWidget {
 public:
  explicit Lamp(QWidget* parent) : QWidget(parent) { setFixedSize(24, 24); }
  void set(Condition condition) {
    if (condition == m_condition) return;
    m_condition = condition;
    update();
  }
  void setColours(const Colours& colours) {
    m_colours = colours;
    update();
  }

 private:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(2, 2, -2, -2);
    switch (m_condition) {
      case Condition::Idle: drawGlyph(painter, box, Glyph::NoData, m_colours.stale.ink); break;
      case Condition::Busy: drawGlyph(painter, box, Glyph::Stale, m_colours.accent.ink); break;
      case Condition::Fine: drawGlyph(painter, box, Glyph::Fine, m_colours.fine.ink); break;
      case Condition::Attend: drawGlyph(painter, box, Glyph::Attend, m_colours.attend.ink); break;
      case Condition::Fault: drawGlyph(painter, box, Glyph::Fault, m_colours.fault.ink); break;
    }
  }

  Condition m_condition = Condition::Idle;
  Colours m_colours = coloursOf(Theme::Light);
};

StatusStrip::StatusStrip(QWidget* parent)
    : QWidget(parent), m_lamp(new Lamp(this)), m_source(new QLabel(this)), m_counts(new QLabel(this)) {
  setObjectName(QStringLiteral("statusStrip"));
  setAccessibleName(tr("Status"));
  m_source->setObjectName(QStringLiteral("sourceStatus"));
  m_source->setAccessibleName(tr("Source"));
  m_source->setTextFormat(Qt::PlainText);
  // A long path or reason is cut by the window, never widens it.
  m_source->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  m_counts->setObjectName(QStringLiteral("frameCounts"));
  m_counts->setAccessibleName(tr("Frames"));
  m_counts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 16, 4);
  layout->setSpacing(8);
  layout->addWidget(m_lamp);
  layout->addWidget(m_source, 1);
  layout->addWidget(m_counts);
  setSnapshot({});
}

void StatusStrip::setColours(const Colours& colours) { m_lamp->setColours(colours); }

void StatusStrip::setSnapshot(const Snapshot& snapshot) {
  m_lamp->set(conditionOf(snapshot.source));
  const QString source = sourceText(snapshot.source);
  m_source->setText(source);
  m_source->setToolTip(source);
  m_counts->setText(countsText(snapshot));
}

QString StatusStrip::sourceText(const SourceStatus& source) {
  using Progress = SourceStatus::Progress;
  if (source.kind == SourceStatus::Kind::Nothing) return tr("Nothing open");
  QString text = source.simulated ? tr("Simulated truck") : source.name;
  if (source.kind == SourceStatus::Kind::Link && source.bitRate != 0) {
    text += tr(", %1 kbit/s").arg(source.bitRate / 1000);
  }
  switch (source.progress) {
    case Progress::Idle: break;
    case Progress::Opening:
      text += source.kind == SourceStatus::Kind::File
                  ? tr(" – reading, %1 %").arg(static_cast<int>(source.fraction * 100))
                  : tr(" – connecting");
      break;
    case Progress::Running: text += tr(" – connected"); break;
    case Progress::Done: break;
    case Progress::Lost: text += tr(" – link lost"); break;
    case Progress::Failed:
      text += source.kind == SourceStatus::Kind::File ? tr(" – cannot be read") : tr(" – not connected");
      break;
  }
  if (!source.reason.isEmpty() && source.progress != Progress::Running)
    text += QStringLiteral(": ") + source.reason;
  if (source.unreadable == 1) text += tr(" – 1 unreadable line");
  if (source.unreadable > 1) text += tr(" – %1 unreadable lines").arg(source.unreadable);
  if (source.notKept == 1) text += tr(" – 1 frame not kept");
  if (source.notKept > 1) text += tr(" – %1 frames not kept").arg(source.notKept);
  return text;
}

QString StatusStrip::countsText(const Snapshot& snapshot) {
  if (snapshot.view.document == nullptr) return {};
  return tr("%1 frames").arg(QLocale().toString(static_cast<qulonglong>(snapshot.view.frameCount)));
}

}  // namespace deckpipe
