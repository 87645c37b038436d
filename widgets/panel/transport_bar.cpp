// SPDX-License-Identifier: GPL-3.0-or-later
#include "panel/transport_bar.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <cmath>

#include "paint/timeline.h"
#include "panel/time_readout.h"
#include "panel/transport_button.h"

namespace deckpipe {
namespace {

constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4, 8, 16};
constexpr int kPixelsABin = 3;
constexpr int kMoreMs = 20;

}  // namespace

TransportBar::TransportBar(QWidget* parent) : QWidget(parent), m_colours(coloursOf(Theme::Light)) {
  setObjectName(QStringLiteral("transportBar"));
  setAccessibleName(tr("Timeline"));
  const auto button = [this](TransportButton::Sign sign, const char* name, const QString& label) {
    auto* made = new TransportButton(sign, this);
    made->setObjectName(QString::fromLatin1(name));
    made->setAccessibleName(label);
    made->setToolTip(label);
    return made;
  };
  m_back = button(TransportButton::Sign::StepBack, "stepBack", tr("Back by one frame"));
  m_play = button(TransportButton::Sign::Play, "play", tr("Play"));
  m_forward = button(TransportButton::Sign::StepForward, "stepForward", tr("On by one frame"));
  m_end = button(TransportButton::Sign::ToEnd, "toEnd", tr("To the end of the log, and on with it"));
  const QString atEnd = tr("At the end"), toEnd = tr("To the end");
  const QFontMetrics metrics(font());
  m_end->setWidestText(metrics.horizontalAdvance(atEnd) > metrics.horizontalAdvance(toEnd) ? atEnd : toEnd);
  m_readout = new TimeReadout(this);
  m_timeline = new Timeline(this);
  m_speed = new QComboBox(this);
  m_speed->setObjectName(QStringLiteral("speed"));
  m_speed->setAccessibleName(tr("Speed of replay"));
  m_speed->setToolTip(tr("Speed of replay"));
  m_speed->setMinimumHeight(40);
  for (const double speed : kSpeeds) m_speed->addItem(tr("%1×").arg(QLocale().toString(speed)), speed);
  setFocusProxy(m_timeline);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(4);
  row->addWidget(m_back);
  row->addWidget(m_play);
  row->addWidget(m_forward);
  row->addSpacing(4);
  row->addWidget(m_readout);
  row->addWidget(m_timeline, 1);
  row->addSpacing(4);
  row->addWidget(m_speed);
  row->addWidget(m_end);

  connect(m_back, &QAbstractButton::clicked, this, [this] { Q_EMIT stepRequested(-1); });
  connect(m_forward, &QAbstractButton::clicked, this, [this] { Q_EMIT stepRequested(1); });
  connect(m_play, &QAbstractButton::clicked, this, &TransportBar::playOrPause);
  connect(m_end, &QAbstractButton::clicked, this, &TransportBar::endRequested);
  connect(m_timeline, &Timeline::seekRequested, this, &TransportBar::seekRequested);
  connect(m_timeline, &Timeline::endRequested, this, &TransportBar::endRequested);
  connect(m_speed, &QComboBox::activated, this,
          [this](int index) { Q_EMIT speedRequested(m_speed->itemData(index).toDouble()); });
  m_more.setInterval(kMoreMs);
  m_more.setSingleShot(true);
  connect(&m_more, &QTimer::timeout, this, &TransportBar::showTimeline);
  setView({}, {});
}

void TransportBar::setView(const LogView& view, const Playback& playback) {
  m_view = view;
  m_playback = playback;
  showControls();
  showTimeline();
}

void TransportBar::setColours(const Colours& colours) {
  m_colours = colours;
  for (TransportButton* button : {m_back, m_play, m_forward, m_end}) button->setColours(colours);
  m_readout->setColours(colours);
  m_timeline->setColours(colours);
  update();
}

void TransportBar::showControls() {
  const bool hasFrames = m_view.document && m_view.frameCount > 0;
  m_play->setEnabled(hasFrames);
  m_back->setEnabled(hasFrames && m_view.cursor.frames > 0);
  m_forward->setEnabled(hasFrames && m_view.cursor.frames < m_view.frameCount);
  m_end->setEnabled(hasFrames);
  m_speed->setEnabled(hasFrames);
  const bool isPlaying = m_playback.isPlaying;
  const QString label = isPlaying ? tr("Pause") : tr("Play");
  if (m_play->accessibleName() != label) {
    m_play->setAccessibleName(label);
    m_play->setToolTip(label);
  }
  m_play->setSign(isPlaying ? TransportButton::Sign::Pause : TransportButton::Sign::Play);
  m_end->setOn(hasFrames && m_view.atEnd);
  m_end->setText(hasFrames && m_view.atEnd ? tr("At the end") : tr("To the end"));
  const int index = m_speed->findData(m_playback.speed);
  if (index != m_speed->currentIndex() && !m_speed->view()->isVisible()) {
    const QSignalBlocker blocker(m_speed);
    m_speed->setCurrentIndex(index);
  }
  m_readout->setView(m_view);
}

void TransportBar::showTimeline() {
  const int bins = std::max(1, m_timeline->width() / kPixelsABin);
  if (!m_marks.take(m_view, bins)) m_more.start();
  TimelineValues values;
  values.isEmpty = !m_view.document || m_view.frameCount == 0;
  if (!values.isEmpty) {
    values.begin = m_view.begin;
    values.end = m_view.end;
    values.cursor = m_view.cursor.time;
    values.atEnd = m_view.atEnd;
    values.density = m_marks.density();
    values.marks = m_marks.marks();
  }
  m_timeline->setValues(values);
  m_timeline->setAccessibleDescription(values.isEmpty ? tr("no frames") : m_readout->elapsed());
}

void TransportBar::playOrPause() {
  if (!m_play->isEnabled()) return;
  if (m_playback.isPlaying) {
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
  QWidget::keyPressEvent(event);
}

void TransportBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showTimeline();
}

void TransportBar::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), m_colours.window);
  p.fillRect(QRect(0, 0, width(), 1), m_colours.outline);
}

}  // namespace deckpipe
