// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/play/transport_bar.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>
#include <QLayout>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <cmath>
#include <limits>

#include "model/event_text.h"
#include "paint/app_style.h"
#include "paint/glyph.h"
#include "paint/timeline.h"
#include "panel/common/build.h"
#include "panel/play/log_scale.h"
#include "panel/play/time_field.h"
#include "panel/play/transport_button.h"
#include "text/plural.h"
#include "text/time_text.h"

namespace deckpipe {
namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 5, 10, 100, std::numeric_limits<double>::infinity()};
constexpr int kPixelsABin = 3;
constexpr int kLeastTimeline = 240;  // pixels that the timeline keeps before buttons go

void say(TransportButton* button, const QString& text) {
  if (button->accessibleName() == text) return;
  button->setAccessibleName(text);
  button->setToolTip(text);
}

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
  m_end = button(TransportButton::Sign::ToEnd, "toEnd", {});
  m_loop = button(TransportButton::Sign::Loop, "loop", {});
  m_silences = button(TransportButton::Sign::Skip, "silences", tr("Skip silences of more than 3 s"));
  for (TransportButton* toggle : {m_loop, m_silences}) toggle->setCheckable(true);
  const QString live = tr("Live"), end = tr("End");
  m_end->setWidestText(fontMetrics().horizontalAdvance(live) > fontMetrics().horizontalAdvance(end) ? live
                                                                                                    : end);
  m_readout = new TimeReadout(this);
  m_field = new TimeField(m_readout, this);
  m_timeline = new Timeline(this);
  m_speed = named(new QComboBox(this), "speed", tr("Speed of replay"));
  m_speed->setToolTip(tr("Speed of replay; Ctrl+Up and Ctrl+Down change it"));
  m_speed->setMinimumHeight(40);
  for (const double speed : kSpeeds)
    m_speed->addItem(std::isinf(speed) ? tr("Max") : tr("%1×").arg(QLocale().toString(speed)), speed);
  const int fastest = m_speed->count() - 1;
  for (const int role : {Qt::ToolTipRole, Qt::AccessibleTextRole})
    m_speed->setItemData(fastest, tr("As fast as it goes"), role);
  setFocusProxy(m_timeline);

  inRow(this, {8, 4, 8, 4}, 4,
        {m_back,
         m_play,
         m_forward,
         LayoutPart::gap(4),
         m_readout,
         {m_timeline, 1},
         LayoutPart::gap(4),
         m_loop,
         m_silences,
         m_speed,
         m_end});

  connect(m_back, &QAbstractButton::clicked, this,
          [this] { step(-1, (QApplication::keyboardModifiers() & Qt::ShiftModifier) != 0); });
  connect(m_forward, &QAbstractButton::clicked, this,
          [this] { step(1, (QApplication::keyboardModifiers() & Qt::ShiftModifier) != 0); });
  connect(m_play, &QAbstractButton::clicked, this, &TransportBar::playOrPause);
  connect(m_end, &QAbstractButton::clicked, this, &TransportBar::endRequested);
  connect(m_timeline, &Timeline::seekRequested, this, &TransportBar::seekOnScale);
  connect(m_timeline, &Timeline::endRequested, this, &TransportBar::endRequested);
  connect(m_speed, &QComboBox::activated, this,
          [this](int index) { Q_EMIT speedRequested(m_speed->itemData(index).toDouble()); });
  connect(m_timeline, &Timeline::shownChanged, this, &TransportBar::showTimeline);
  connect(m_timeline, &Timeline::selectionChanged, this, &TransportBar::selectionChanged);
  connect(m_loop, &QAbstractButton::clicked, this, &TransportBar::toggleLoop);
  connect(m_silences, &QAbstractButton::clicked, this, &TransportBar::silencesRequested);
  connect(m_readout, &QAbstractButton::clicked, this, &TransportBar::typeTime);
  connect(m_field, &TimeField::timeTyped, this, &TransportBar::seekRequested);
  connect(m_field, &TimeField::framesTyped, this, &TransportBar::framesRequested);
  connect(m_field, &TimeField::done, m_timeline, qOverload<>(&QWidget::setFocus));
  m_timeline->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(m_timeline, &QWidget::customContextMenuRequested, this, &TransportBar::showMenu);
  setFiltered(false);
  setView({}, {});
}

void TransportBar::setView(const LogView& view, const PlayState& play) {
  m_view = view;
  m_playState = play;
  m_field->setView(view);
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
  // Without times a log is played frame by frame, as fast as it goes.
  m_speed->setEnabled(hasFrames && m_view.hasTimes());
  m_silences->setEnabled(hasFrames && m_view.hasTimes());
  m_silences->setChecked(m_playState.skipsSilences);
  m_loop->setEnabled(canLoop());
  m_loop->setChecked(m_playState.isLooping);
  say(m_loop, m_loop->isEnabled()
                  ? tr("Play the selection again and again")
                  : tr("Play the selection again and again: select a part of the timeline first, with "
                       "[ and ], with Shift and a drag, or with a drag above the strip"));
  const bool isPlaying = m_playState.isPlaying;
  say(m_play, isPlaying ? tr("Pause") : tr("Play"));
  m_play->setSign(isPlaying ? TransportButton::Sign::Pause : TransportButton::Sign::Play);
  showEnd();
  const int index =
      m_speed->findData(m_view.hasTimes() ? m_playState.speed : kSpeeds[std::size(kSpeeds) - 1]);
  if (index != m_speed->currentIndex() && !m_speed->view()->isVisible()) {
    const QSignalBlocker blocker(m_speed);
    m_speed->setCurrentIndex(index);
  }
  m_readout->setView(m_view);
}

// What is filled has a sign and a name of its own, too.
void TransportBar::showEnd() {
  const bool isThere = m_end->isEnabled() && m_view.atEnd;
  m_end->setOn(isThere);
  m_end->setSign(isThere && m_playState.isLive ? TransportButton::Sign::Live : TransportButton::Sign::ToEnd);
  m_end->setText(m_playState.isLive ? tr("Live") : tr("End"));
  say(m_end, m_playState.isLive ? (isThere ? tr("Live: the cursor goes with the bus")
                                           : tr("Live: to what comes from the bus now, and on with it"))
                                : (isThere ? tr("End: the cursor stands at the end of the log")
                                           : tr("End: to the end of the log")));
}

void TransportBar::showTimeline() {
  const int bins = std::max(1, m_timeline->width() / kPixelsABin);
  const TimelineSpan whole = scaleOf(m_view);
  m_marks.take(m_view, m_timeline->isZoomed() ? m_timeline->shown() : whole, bins);
  TimelineValues values;
  values.isEmpty = !m_view.document || m_view.frameCount == 0;
  if (!values.isEmpty) {
    values.begin = whole.begin;
    values.end = whole.end;
    values.cursor = onScale(m_view, m_view.cursor);
    values.unit = m_view.hasTimes() ? TimelineUnit::Time : TimelineUnit::Frames;
    values.atEnd = m_view.atEnd;
    values.density = m_marks.density();
    values.marks = m_marks.marks();
    values.gaps = m_marks.gaps();
    values.selection = selectionText();
    if (m_playState.skipped > Duration(0))
      values.atCursor = tr("%1 without frames skipped").arg(briefAge(m_playState.skipped));
  }
  m_timeline->setValues(values);
}

void TransportBar::setFiltered(bool isFiltered) {
  m_isFiltered = isFiltered;
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
  const std::uint64_t count = framesBefore(m_view, span->end) - framesBefore(m_view, span->begin);
  if (!m_view.hasTimes()) return tr("%Ln frames", nullptr, forPlural(count));
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
  const auto only = [this](TimelineSpan of) {
    if (!m_view.hasTimes())
      return QStringLiteral("frame>%1 and frame<=%2")
          .arg(framesBefore(m_view, of.begin))
          .arg(framesBefore(m_view, of.end));
    const auto seconds = [this](Instant time) {
      return QString::number(static_cast<double>((time - m_view.begin).count()) / 1e9, 'f', 6);
    };
    return QStringLiteral("t>=%1 and t<%2").arg(seconds(of.begin), seconds(of.end));
  };
  QAction* zoom = menu->addAction(tr("Look closer at the selection"), this,
                                  [this, span] { m_timeline->showSpan(*span); });
  QAction* show = menu->addAction(tr("Show only the selection in the trace"), this,
                                  [this, span, only] { Q_EMIT spanRequested(only(*span)); });
  QAction* save = menu->addAction(tr("Save the selection…"), this, [this, span] {
    Q_EMIT saveRequested(framesBefore(m_view, span->begin), framesBefore(m_view, span->end));
  });
  QAction* none = menu->addAction(tr("No selection"), this, [this] { m_timeline->select({}); });
  for (QAction* action : {zoom, show, save, none}) action->setEnabled(span.has_value());
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

void TransportBar::seekOnScale(Instant at) {
  if (m_view.hasTimes()) {
    Q_EMIT seekRequested(at);
  } else {
    Q_EMIT framesRequested(framesBefore(m_view, at));
  }
}

// A loop goes with the selection.
void TransportBar::selectionChanged() {
  if (m_playState.isLooping) Q_EMIT loopRequested(m_timeline->selection());
  showControls();
  showTimeline();
}

bool TransportBar::canLoop() const {
  return m_playState.isLooping || (m_timeline->selection() && m_view.hasTimes());
}

void TransportBar::toggleLoop() {
  const bool begins = !m_playState.isLooping;
  m_loop->setChecked(m_playState.isLooping);  // until the session says otherwise
  if (canLoop()) Q_EMIT loopRequested(begins ? m_timeline->selection() : std::nullopt);
}

void TransportBar::changeSpeed(int by) {
  const int index = std::clamp(m_speed->currentIndex() + by, 0, m_speed->count() - 1);
  if (m_speed->isEnabled() && index != m_speed->currentIndex())
    Q_EMIT speedRequested(m_speed->itemData(index).toDouble());
}

void TransportBar::typeTime() {
  if (m_readout->isEnabled()) m_field->open(m_readout->elapsed());
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
  if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down)
    return changeSpeed(event->key() == Qt::Key_Up ? 1 : -1);
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
  fit();
  m_field->place();
  showTimeline();
}

void TransportBar::fit() {
  int others = 0;
  for (const QWidget* each : std::initializer_list<QWidget*>{m_back, m_play, m_forward, m_readout, m_loop,
                                                             m_silences, m_speed, m_end})
    others += each->sizeHint().width() + layout()->spacing();
  for (QWidget* button : {m_loop, m_silences}) button->setVisible(width() - others >= kLeastTimeline);
}

void TransportBar::paintEvent(QPaintEvent*) {
  const Colours& c = coloursOf(this);
  QPainter p(this);
  p.fillRect(rect(), c.window);
  p.fillRect(QRect(0, 0, width(), 1), c.outline);
}

}  // namespace deckpipe
