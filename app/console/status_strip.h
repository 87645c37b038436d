// SPDX-License-Identifier: GPL-3.0-or-later
// The strip across the top of the window: where the frames come from and how that goes, how busy the bus is,
// that nothing is sent, how much is held and whether anything of it is missing. The window gives it each
// snapshot; the sentences are status_text.h's. The lock's button is always at one place, whatever the rest
// says, with a free place beside it for a button that stops what moves. Where the window is narrow, numbers
// go, the recording last.
#pragma once

#include <QWidget>
#include <memory>

#include "model/bus_rates.h"
#include "session/snapshot.h"
#include "status_text.h"

class QPushButton;

namespace deckpipe {

class StatusCell;

class StatusStrip : public QWidget {
  Q_OBJECT
 public:
  explicit StatusStrip(QWidget* parent = nullptr);

  void setSnapshot(const Snapshot& snapshot);
  // Those that are shown.
  const BusRates& rates() const { return m_rates; }
  // The size of those cells that are never hidden.
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void lockToggled();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  StatusCell* addCell(const char* name, const QString& label, const QString& widest);
  bool ratesAreDue(const LogView& view) const;
  bool tellRecording(const Snapshot& snapshot);
  void measureButtons();
  void fit();
  int neededWidth() const;
  // True where it may want another width now.
  bool showLockButton(const Snapshot& snapshot);

  bool m_hasFacts = false;  // of an open log or a link that is up
  StatusCell* m_source;
  StatusCell* m_sent;
  StatusCell* m_load;
  StatusCell* m_rate;
  StatusCell* m_errors;
  StatusCell* m_recording;
  StatusCell* m_completeness;
  StatusCell* m_lock;
  QWidget* m_stopRoom;
  QPushButton* m_lockButton;
  // The rates that are shown, and where they were taken.
  BusRates m_rates;
  std::weak_ptr<const LogDocument> m_ratesOf;
  Cursor m_ratesAt;
  // What is said of the recording, and where the log ended then.
  StatusFact m_recordingSaid;
  Instant m_recordingAt = kNotYet;
};

}  // namespace deckpipe
