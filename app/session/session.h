// SPDX-License-Identifier: GPL-3.0-or-later
// The one object that the window talks to: opens a source (log file, adapter, demo), moves the cursor, and
// makes a snapshot on its tick. It composes store, bus thread, walker and simulator; it lives on the window's
// thread. It waits for no bus, nor for a bus to end: a link that is opened next waits until the old bus has ended.
//
// With a link the bus thread's tick is the session's, so that what the bus thread published is drawn at once.
// The session's own timer ticks where there is no link, or where the bus thread has missed its tick.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

#include "control/intent.h"
#include "control/simulator_control.h"
#include "link/can_link.h"
#include "service/claim_service.h"
#include "session/label_notes.h"
#include "session/live_bus.h"
#include "session/log_opening.h"
#include "session/mark_keeper.h"
#include "session/playback.h"
#include "session/recorders.h"
#include "session/snapshot.h"

namespace deckpipe {

class SimulatorRunner;
class BusThreads;
class StateWalker;

class Session : public QObject {
  Q_OBJECT
 public:
  // The times in a log file: of a clock, or differences from frame to frame, to be added up.
  enum class TimesOf : bool { Clock, Differences };

  explicit Session(QObject* parent = nullptr);
  ~Session() override;

  // Each closes what was open before; a log only when its first frames were read.
  void openLog(const QString& path, TimesOf times = TimesOf::Clock);
  void openLink(const LinkSettings& settings);
  // The simulator behind a virtual bus of its own, and a link to it.
  void openDemo();
  // Opens the last link again. It goes on in the same log, after a gap, unless that log is
  // full or a bus that hangs may still write into it.
  void reconnect();
  void closeSource();
  // Waits for the buses that are ending, kThreadPatience at most. For a program that is about to end: the
  // window goes on without.
  void waitForEnd();

  // A person's note at a place of the log. In a log of a file it is kept beside it, on a worker (mark_keeper.h); the
  // snapshot says while it is being written, and where that cannot be.
  void mark(Cursor at, const QString& text);
  // Sets the person's labels of devices. The session notes them in the log of a link (label_notes.h).
  void setLabels(LabelsByPin labels);
  // Links that are opened from now on are recorded there; empty, as at first: they are not.
  void setRecordingFolder(const QString& folder) { m_recordingFolder = folder; }
  QString recordingFolder() const { return m_recordingFolder; }
  // What a faulty disk did not take of a recording is in memory alone, and would be lost by quitting.
  bool holdsUnwritten() const;
  // The first so many frames and notes of a log were saved in a file of the person's own.
  void setSaved(const std::shared_ptr<const LogDocument>& document, std::uint64_t frames, std::size_t notes);
  // For whoever saves logs.
  std::shared_ptr<KnownSidecars> sidecars() const { return m_marks.sidecars(); }
  // Who we are on a bus; for links opened from now on.
  void setClaim(const ClaimSettings& claim) { m_claim = claim; }

  const Snapshot& snapshot() const { return m_snapshot; }
  // The person has read what the snapshot says once.
  void dismiss();

  // Sends an intent to the live bus and returns its serial number, which Snapshot::services names if the services
  // refuse it. Returns 0 if the session refuses it; Snapshot::notSent has the reason. Away from the live edge only
  // intents that stop something are sent.
  std::uint64_t intend(Intent intent);
  // What no frame tells: a Copley drive is at this address of the open link, or is none after all.
  void sayDrive(Address address, bool isDrive);
  // To the demo's simulator, where one runs.
  void intendForSimulator(const SimulatorIntent& intent);

  // Plays from the cursor. At the end of a log that does not grow it starts at the begin.
  void play();
  void pause();
  // To a time, to behind so many frames; both stop at the ends and stop playing.
  void seek(Instant time);
  void seekFrames(std::uint64_t frames);
  void step(int frames);
  // To the end, and from then on with it.
  void goToEnd();
  // playback.h says what these take. A loop that begins starts to play.
  void setSpeed(double speed);
  void setLoop(std::optional<LoopSpan> span);
  void setSkipsSilences(bool skips);

 Q_SIGNALS:
  // The snapshot differs from the one before; at most once a tick, and at once on what a person asked for.
  void changed();

  // The demo's simulator, whenever something about it has changed; without devices where it ended.
  void simulatorChanged(const deckpipe::SimulatorStatus& status);

 private:
  // A log that is being read and not shown yet.
  struct Candidate {
    QString path;
    TimesOf times = TimesOf::Clock;
    std::shared_ptr<LogDocument> document;
    std::unique_ptr<LogOpening> opening;
  };
  void show(Candidate log);
  void followCandidate();
  void beginDocument(std::shared_ptr<LogDocument> document);
  void startLink(LinkSettings settings, const QString& channelName);
  void endBus();
  // Clears the messages that last until the person's next action.
  void forgetSaid();
  void beginRecording();
  void tick();
  void followWalk();
  void updateSource();
  void takeOutcome(const LogOpening::Outcome& outcome);
  // The open log is that of a file, and was read to its end.
  bool isRead() const { return m_snapshot.source.progress == SourceStatus::Progress::Done; }
  void keepMarks();
  void followMarks();
  // Takes into the snapshot where the playback stands.
  void place();
  Cursor endCursor() const;
  // Also between two links of reconnect().
  bool grows() const { return m_board != nullptr; }
  bool isLiveEdge() const { return grows() && m_playback.isAtEnd(); }
  void endSource();

  Snapshot m_snapshot;
  LinkSettings m_lastLink;
  std::shared_ptr<LogDocument> m_document;
  std::unique_ptr<StateWalker> m_walker;
  Playback m_playback;  // of m_document
  std::unique_ptr<LogOpening> m_opening;
  MarkKeeper m_marks;  // of the logs of files that were read
  LabelNotes m_labels;
  std::optional<Candidate> m_candidate;
  BusThreads* m_buses;
  LiveBus* m_live = nullptr;
  std::shared_ptr<const LiveBus::Board> m_board;  // of m_live, or of the one before while the next one waits
  SimulatorRunner* m_simulator = nullptr;
  ClaimSettings m_claim;
  QString m_recordingFolder;
  Recorders m_recorders;
  std::uint64_t m_serial = 0;
  QTimer m_timer;
  Cursor m_indexed;    // the log's end when the walker was last told
  Cursor m_walkedTo;   // where the state of the view stood
  Instant m_walkedAt;  // when m_walkedTo last changed
};

}  // namespace deckpipe
