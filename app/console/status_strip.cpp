// SPDX-License-Identifier: GPL-3.0-or-later
#include "status_strip.h"
#include "paint/app_style.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <tuple>
#include <utility>

#include "panel/common/build.h"
#include "panel/common/status_cell.h"

namespace deckpipe {
namespace {

// Figures that change more often cannot be read.
constexpr Duration kCalm = 250ms;
constexpr int kMinSource = 220;  // "can0 · 250 kbit/s"
constexpr int kMargins = 24;

bool tell(StatusCell* cell, const StatusFact& fact) {
  return cell->setStatus(fact.tone, fact.text, fact.story, fact.glyph);
}

}  // namespace

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent) {
  named(this, "statusStrip", tr("Status"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 2, 8, 3);
  layout->setSpacing(4);
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
  m_lockButton = new QPushButton(this);
  m_lockButton->setObjectName(QStringLiteral("lockButton"));
  layout->addWidget(m_lockButton);
  connect(m_lockButton, &QPushButton::clicked, this, &StatusStrip::lockToggled);
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

// Where the window is narrow, numbers go before what link, lock, losses and frames that wait say.
void StatusStrip::fit() {
  int room = width() - kMinSource - m_lock->sizeHint().width() -
             (m_lockButton->isHidden() ? 0 : m_lockButton->sizeHint().width()) -
             (m_sent->isHidden() ? 0 : m_sent->sizeHint().width() + layout()->spacing()) - kMargins;
  bool hasRoom = m_hasFacts;
  for (StatusCell* cell : {m_completeness, m_errors, m_recording, m_load, m_rate}) {
    room -= cell->sizeHint().width() + layout()->spacing();
    hasRoom = hasRoom && room >= 0;
    cell->setVisible(hasRoom);
  }
}

QSize StatusStrip::minimumSizeHint() const {
  return {kMinSource + m_lockButton->sizeHint().width() + kMargins, QWidget::minimumSizeHint().height()};
}

void StatusStrip::resizeEvent(QResizeEvent*) { fit(); }

// The button is there only if there is a bus to send on. A person can always lock, and unlock at the live
// edge of a link that is up.
bool StatusStrip::showLockButton(const Snapshot& snapshot) {
  const bool isLocked = snapshot.services->locked;
  const QString text = isLocked ? tr("Unlock…") : tr("Lock");
  const bool isShown = snapshot.source.kind == SourceStatus::Kind::Link;
  const bool isOther = m_lockButton->text() != text || m_lockButton->isHidden() == isShown;
  if (m_lockButton->text() != text) {
    m_lockButton->setText(text);
    m_lockButton->setAccessibleName(isLocked ? tr("Unlock sending") : tr("Lock sending"));
  }
  m_lockButton->setVisible(isShown);
  m_lockButton->setEnabled(!isLocked || (snapshot.view.atEnd && snapshot.services->linkUp));
  return isOther;
}

void StatusStrip::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(QRect(0, height() - 1, width(), 1), coloursOf(this).outline);
}

}  // namespace deckpipe
