// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/transport_bar.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <cmath>

#include "model/event_text.h"
#include "paint/app_style.h"
#include "paint/event_mark.h"
#include "paint/timeline.h"
#include "panel/common/build.h"
#include "panel/play/time_readout.h"
#include "panel/play/transport_button.h"
#include "text/plural.h"

namespace deckpipe {
namespace {

constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4, 8, 16};
constexpr int kPixelsABin = 3;

}  // namespace

TransportBar::TransportBar(QWidget* parent) : QWidget(parent) {
  named(this, "transportBar", tr("Timeline"));
  const auto button = [this](TransportButton::Sign sign, const char* name, const QString& label) {
    auto* made = named(new TransportButton(sign, this), name, label);
    made->setToolTip(label);
    return made;
  };
  m_back = button(TransportButton::Sign::StepBack, "stepBack", {});
  m_play = button(TransportButton::Sign::Play, "play", tr("Play"));
  m_forward = button(TransportButton::Sign::StepForward, "stepForward", {});
  m_end = button(TransportButton::Sign::ToEnd, "toEnd", tr("To the end of the log, and on with it"));
  const QString atEnd = tr("At the end"), toEnd = tr("To the end");
  const QFontMetrics metrics(font());
  m_end->setWidestText(metrics.horizontalAdvance(atEnd) > metrics.horizontalAdvance(toEnd) ? atEnd : toEnd);
  m_readout = new TimeReadout(this);
  m_timeline = new Timeline(this);
  m_speed = named(new QComboBox(this), "speed", tr("Speed of replay"));
  m_speed->setToolTip(tr("Speed of replay"));
  m_speed->setMinimumHeight(40);
  for (const double speed : kSpeeds) m_speed->addItem(tr("%1×").arg(QLocale().toString(speed)), speed);
  setFocusProxy(m_timeline);

  inRow(this, {8, 4, 8, 4}, 4,
        {m_back,
         m_play,
         m_forward,
         LayoutPart::gap(4),
         m_readout,
         {m_timeline, 1},
         LayoutPart::gap(4),
         m_speed,
         m_end});

  connect(m_back, &QAbstractButton::clicked, this,
          [this] { step(-1, (QApplication::keyboardModifiers() & Qt::ShiftModifier) != 0); });
  connect(m_forward, &QAbstractButton::clicked, this,
          [this] { step(1, (QApplication::keyboardModifiers() & Qt::ShiftModifier) != 0); });
  connect(m_play, &QAbstractButton::clicked, this, &TransportBar::playOrPause);
  connect(m_end, &QAbstractButton::clicked, this, &TransportBar::endRequested);
  connect(m_timeline, &Timeline::seekRequested, this, &TransportBar::seekRequested);
  connect(m_timeline, &Timeline::endRequested, this, &TransportBar::endRequested);
  connect(m_speed, &QComboBox::activated, this,
          [this](int index) { Q_EMIT speedRequested(m_speed->itemData(index).toDouble()); });
  connect(m_timeline, &Timeline::shownChanged, this, &TransportBar::showTimeline);
  connect(m_timeline, &Timeline::selectionChanged, this, &TransportBar::showTimeline);
  m_timeline->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(m_timeline, &QWidget::customContextMenuRequested, this, &TransportBar::showMenu);
  setFiltered(false);
  setView({}, {});
}

void TransportBar::setView(const LogView& view, const PlayState& play) {
  m_view = view;
  m_playState = play;
  showControls();
  showTimeline();
}

void TransportBar::setLabels(const DeviceLabels& labels) {
  m_marks.setLabels(labels);
  showTimeline();
}

void TransportBar::showControls() {
  const bool hasFrames = m_view.document && m_view.frameCount > 0;
  m_play->setEnabled(hasFrames);
  m_back->setEnabled(hasFrames && m_view.cursor.frames > 0);
  m_forward->setEnabled(hasFrames && m_view.cursor.frames < m_view.frameCount);
  m_end->setEnabled(hasFrames);
  m_speed->setEnabled(hasFrames);
  const bool isPlaying = m_playState.isPlaying;
  const QString label = isPlaying ? tr("Pause") : tr("Play");
  if (m_play->accessibleName() != label) {
    m_play->setAccessibleName(label);
    m_play->setToolTip(label);
  }
  m_play->setSign(isPlaying ? TransportButton::Sign::Pause : TransportButton::Sign::Play);
  m_end->setOn(hasFrames && m_view.atEnd);
  m_end->setText(hasFrames && m_view.atEnd ? tr("At the end") : tr("To the end"));
  const int index = m_speed->findData(m_playState.speed);
  if (index != m_speed->currentIndex() && !m_speed->view()->isVisible()) {
    const QSignalBlocker blocker(m_speed);
    m_speed->setCurrentIndex(index);
  }
  m_readout->setView(m_view);
}

void TransportBar::showTimeline() {
  const int bins = std::max(1, m_timeline->width() / kPixelsABin);
  m_marks.take(m_view, m_timeline->isZoomed() ? m_timeline->shown() : TimelineSpan{m_view.begin, m_view.end},
               bins);
  TimelineValues values;
  values.isEmpty = !m_view.document || m_view.frameCount == 0;
  if (!values.isEmpty) {
    values.begin = m_view.begin;
    values.end = m_view.end;
    values.cursor = m_view.cursor.time;
    values.atEnd = m_view.atEnd;
    values.density = m_marks.density();
    values.marks = m_marks.marks();
    values.gaps = m_marks.gaps();
    values.selection = selectionText();
  }
  m_timeline->setValues(values);
  m_timeline->setAccessibleDescription(values.isEmpty ? tr("no frames") : m_readout->elapsed());
}

void TransportBar::setFiltered(bool isFiltered) {
  m_isFiltered = isFiltered;
  const auto say = [](TransportButton* button, const QString& text) {
    button->setAccessibleName(text);
    button->setToolTip(text);
  };
  say(m_back, isFiltered ? tr("Back by one row of the filter; with Shift by one frame (,)")
                         : tr("Back by one frame (,)"));
  say(m_forward, isFiltered ? tr("On by one row of the filter; with Shift by one frame (.)")
                            : tr("On by one frame (.)"));
}

void TransportBar::step(int by, bool isByFrame) {
  if (!(by < 0 ? m_back : m_forward)->isEnabled()) return;
  if (m_isFiltered && !isByFrame) {
    Q_EMIT rowStepRequested(by);
  } else {
    Q_EMIT stepRequested(by);
  }
}

// "12.345 s, 4,512 frames, 366/s"
QString TransportBar::selectionText() const {
  const auto span = m_timeline->selection();
  if (!span || !m_view.document) return {};
  const FrameStore& frames = m_view.document->frames;
  const std::uint64_t count = frames.firstAtOrAfter(span->end) - frames.firstAtOrAfter(span->begin);
  const double seconds = span->ns() / 1e9;
  const QLocale locale;
  return tr("%1 s, %Ln frames, %2/s", nullptr, forPlural(count))
      .arg(locale.toString(seconds, 'f', seconds < 100 ? 3 : 1),
           locale.toString(static_cast<double>(count) / seconds, 'f', 0));
}

void TransportBar::showMenu(const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("timelineMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto span = m_timeline->selection();
  const auto seconds = [this](Instant time) {
    return QString::number(static_cast<double>((time - m_view.begin).count()) / 1e9, 'f', 6);
  };
  QAction* zoom = menu->addAction(tr("Look closer at the selection"), this,
                                  [this, span] { m_timeline->showSpan(*span); });
  QAction* only = menu->addAction(tr("Show only the selection in the trace"), this, [this, span, seconds] {
    Q_EMIT spanRequested(QStringLiteral("t>=%1 and t<%2").arg(seconds(span->begin), seconds(span->end)));
  });
  QAction* save = menu->addAction(tr("Save the selection…"), this, [this, span] {
    const FrameStore& frames = m_view.document->frames;
    Q_EMIT saveRequested(frames.firstAtOrAfter(span->begin), frames.firstAtOrAfter(span->end));
  });
  QAction* none = menu->addAction(tr("No selection"), this, [this] { m_timeline->select({}); });
  for (QAction* action : {zoom, only, save, none}) action->setEnabled(span && m_view.document);
  menu->addSeparator();
  menu->addAction(tr("The whole log"), m_timeline, &Timeline::fit)->setEnabled(m_timeline->isZoomed());
  // What each mark stands for, and which are drawn.
  menu->addSection(tr("Marks"));
  for (const EventGroup group : kAllOf<EventGroup>) {
    QAction* shown = menu->addAction(eventMarkIcon(group, coloursOf(this)), eventGroupText(group), this,
                                     [this, group](bool isOn) { m_timeline->hide(group, !isOn); });
    shown->setCheckable(true);
    shown->setChecked(!m_timeline->hidden().has(group));
  }
  menu->popup(m_timeline->mapToGlobal(at));
}

void TransportBar::playOrPause() {
  if (!m_play->isEnabled()) return;
  if (m_playState.isPlaying) {
    Q_EMIT pauseRequested();
  } else {
    Q_EMIT playRequested();
  }
}

// The timeline leaves Space to the bar; a button in focus takes it for itself.
void TransportBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space) {
    if (!event->isAutoRepeat()) playOrPause();
    return;
  }
  const bool isBack =
      event->key() == Qt::Key_Comma || event->key() == Qt::Key_Less || event->key() == Qt::Key_Semicolon;
  const bool isOn =
      event->key() == Qt::Key_Period || event->key() == Qt::Key_Greater || event->key() == Qt::Key_Colon;
  if (isBack || isOn) {
    step(isBack ? -1 : 1, (event->modifiers() & Qt::ShiftModifier) != 0);
    return;
  }
  QWidget::keyPressEvent(event);
}

void TransportBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showTimeline();
}

void TransportBar::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.fillRect(rect(), c.window);
  p.fillRect(QRect(0, 0, width(), 1), c.outline);
}

}  // namespace deckpipe
