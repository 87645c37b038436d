// SPDX-License-Identifier: GPL-3.0-or-later
#include "status_strip.h"
#include "paint/app_style.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <initializer_list>
#include <tuple>
#include <utility>

#include "panel/common/build.h"
#include "panel/common/status_cell.h"

namespace deckpipe {
namespace {

// Figures that change more often cannot be read.
constexpr Duration kCalm = 250ms;
constexpr int kMinSource = 220;  // "can0 · 250 kbit/s"
constexpr int kSpacing = 4, kSideMargin = 8;

QString lockWord(bool isLocked) { return isLocked ? StatusStrip::tr("Unlock…") : StatusStrip::tr("Lock"); }

bool tell(StatusCell* cell, const StatusFact& fact) {
  return cell->setStatus(fact.tone, fact.text, fact.story, fact.glyph);
}

}  // namespace

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent) {
  named(this, "statusStrip", tr("Status"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kSideMargin, 2, kSideMargin, 3);
  layout->setSpacing(kSpacing);
  m_source = addCell("sourceStatus", tr("Source"), {});
  // A long name or reason is cut by the window, never widens it.
  m_source->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->setStretchFactor(m_source, 1);
  m_sent = addCell("sentFrames", tr("Sent frames"), {});
  m_load = addCell("busLoad", tr("Bus load"), loadWords(100));
  m_rate = addCell("frameRate", tr("Frames a second"), rateWords(8'888));
  m_errors = addCell("errorFrames", tr("Error frames"), errorWords(888));
  m_recording =
      addCell("frameCounts", tr("Recording"), recordingWords(true, QStringLiteral("0:00:00"), 888'888));
  m_completeness = addCell("completeness", tr("Completeness"), tr("Complete"));
  m_lock = addCell("transmitLock", tr("Transmit lock"), {});
  ClaimStatus claimed;
  claimed.progress = ClaimStatus::Progress::Claimed;
  claimed.address = Address{0xF9};
  m_lock->setFixedText(unlockedWords(claimed));
  m_stopRoom = new QWidget(this);
  m_stopRoom->setObjectName(QStringLiteral("stopRoom"));
  layout->addWidget(m_stopRoom);
  m_lockButton = new QPushButton(this);
  m_lockButton->setObjectName(QStringLiteral("lockButton"));
  layout->addWidget(m_lockButton);
  connect(m_lockButton, &QPushButton::clicked, this, &StatusStrip::lockToggled);
  measureButtons();
  setSnapshot({});
}

StatusCell* StatusStrip::addCell(const char* name, const QString& label, const QString& widest) {
  auto* cell = new StatusCell(name, label, this);
  if (!widest.isEmpty()) cell->setWidestText(widest);
  layout()->addWidget(cell);
  return cell;
}

bool StatusStrip::ratesAreDue(const LogView& view) const {
  if (m_ratesOf.lock() != view.document || view.cursor.time < m_ratesAt.time) return true;
  // Notes come once all frames of a file are there.
  if (view.state->isFiltered() != (m_rates.basis == BusRates::Basis::Filtered)) return true;
  return view.cursor.time - m_ratesAt.time >= kCalm ||
         (!view.atEnd && view.cursor.frames != m_ratesAt.frames);
}

void StatusStrip::setSnapshot(const Snapshot& snapshot) {
  const LogView& view = snapshot.view;
  const bool isOpen = view.document != nullptr;
  tell(m_source, sourceFact(snapshot.source));
  bool isOther = tell(m_lock, lockFact(snapshot));
  const StatusFact sent = sentFact(snapshot);
  isOther |= tell(m_sent, sent);
  m_sent->setVisible(!sent.text.isEmpty());
  isOther |= showLockButton(snapshot);
  // Of what never came up nothing is complete and nothing is recorded.
  const auto progress = snapshot.source.progress;
  const bool isUp = progress == SourceStatus::Progress::Running || progress == SourceStatus::Progress::Done;
  const bool hasFacts = isOpen && (isUp || view.frameCount > 0);
  isOther |= std::exchange(m_hasFacts, hasFacts) != hasFacts;
  if (!isOpen) return fit();
  if (ratesAreDue(view)) {
    m_rates = ratesAt(view);
    isOther |= tell(m_load, loadFact(snapshot, m_rates));
    isOther |= tell(m_rate, rateFact(m_rates));
    m_ratesOf = view.document;
    m_ratesAt = view.cursor;
  }
  isOther |= tell(m_errors, errorFact(snapshot));
  isOther |= tellRecording(snapshot);
  isOther |= tell(m_completeness, completenessFact(snapshot));
  if (isOther) fit();
}

// The count of a log that grows is shown anew only as often as the rates are; the rest of the fact at once.
bool StatusStrip::tellRecording(const Snapshot& snapshot) {
  const StatusFact fact = recordingFact(snapshot);
  const auto said = [](const StatusFact& f) { return std::tie(f.tone, f.glyph, f.story); };
  const Instant end = snapshot.view.end;
  const bool isCount = said(fact) == said(m_recordingSaid) && snapshot.view.frameCount > 0;
  if (isCount && end > m_recordingAt && end - m_recordingAt < kCalm) return false;
  m_recordingSaid = fact;
  m_recordingAt = end;
  return tell(m_recording, fact);
}

// The button is as wide as the wider of its words.
void StatusStrip::measureButtons() {
  QPushButton probe;
  probe.setFont(m_lockButton->font());
  int width = 0;
  for (const bool isLocked : {true, false}) {
    probe.setText(lockWord(isLocked));
    width = std::max(width, probe.sizeHint().width());
  }
  m_lockButton->setFixedWidth(width);
  m_stopRoom->setFixedWidth(targetHeight(this) * 5 / 2);
}

int StatusStrip::neededWidth() const {
  int width = 2 * kSideMargin + kMinSource;
  for (const QWidget* each : std::initializer_list<const QWidget*>{m_lock, m_stopRoom, m_lockButton}) {
    if (!each->isHidden()) width += kSpacing + std::max(each->minimumWidth(), each->sizeHint().width());
  }
  return width;
}

void StatusStrip::fit() {
  int room = width() - neededWidth();
  if (!m_sent->isHidden()) room -= m_sent->sizeHint().width() + kSpacing;
  bool hasRoom = m_hasFacts;
  for (StatusCell* cell : {m_recording, m_completeness, m_errors, m_load, m_rate}) {
    room -= cell->sizeHint().width() + kSpacing;
    hasRoom = hasRoom && room >= 0;
    cell->setVisible(hasRoom);
  }
}

QSize StatusStrip::minimumSizeHint() const { return {neededWidth(), QWidget::minimumSizeHint().height()}; }

void StatusStrip::resizeEvent(QResizeEvent*) { fit(); }

// Other letters, or another density.
bool StatusStrip::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) {
    measureButtons();
    fit();
  }
  return QWidget::event(event);
}

// The button is there only if there is a bus to send on. A person can always lock, and unlock at the live
// edge of a link that is up.
bool StatusStrip::showLockButton(const Snapshot& snapshot) {
  const bool isLocked = snapshot.services->locked;
  const QString text = lockWord(isLocked);
  const bool isShown = snapshot.source.kind == SourceStatus::Kind::Link;
  const bool isOther = m_lockButton->text() != text || m_lockButton->isHidden() == isShown;
  if (m_lockButton->text() != text) {
    m_lockButton->setText(text);
    m_lockButton->setAccessibleName(isLocked ? tr("Unlock sending") : tr("Lock sending"));
  }
  m_lockButton->setVisible(isShown);
  m_stopRoom->setVisible(isShown);
  m_lockButton->setEnabled(!isLocked || (snapshot.view.atEnd && snapshot.services->linkUp));
  return isOther;
}

void StatusStrip::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(QRect(0, height() - 1, width(), 1), coloursOf(this).outline);
}

}  // namespace deckpipe
