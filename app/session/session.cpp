// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <thread>
#include <utility>

#include "session/bus_threads.h"
#include "session/clocks.h"
#include "session/live_bus.h"
#include "session/log_opening.h"
#include "session/state_walker.h"

namespace deckpipe {
namespace {

// With a link the session ticks by itself only where the bus thread has missed its tick.
constexpr std::chrono::milliseconds kUnlessTold = 3 * LiveBus::kTick;

// A state that is not found by then is said to be on its way.
constexpr Duration kCatchesUp = 500ms;

SourceError errorOf(const LiveBus::Published& published) {
  const LinkStatus& link = published.link;
  if (published.storeFull) return StoreFull{};
  if (link.fault == LinkFault::None && link.reason.empty()) return {};
  return link.error();
}

// An interface that went down, or is another one since, holds no frame any more.
bool holdsNothing(LinkFault fault) {
  return fault == LinkFault::InterfaceDown || fault == LinkFault::Gone || fault == LinkFault::NoInterface;
}

// Copies link state, error, bit rate and counters from what the bus has published.
void takeLink(Snapshot& snapshot, const LiveBus::Published& published) {
  SourceStatus& source = snapshot.source;
  const auto& waiting = snapshot.leftWaiting;
  if (waiting && waiting->interfaceName == source.interfaceName && holdsNothing(published.link.fault))
    snapshot.leftWaiting.reset();
  source.error = errorOf(published);
  if (const auto& hardware = published.link.hardware) {
    source.isListenOnly = hardware->isListenOnly;
    source.controller = hardware->controller;
    if (hardware->bitRate != 0) source.bitRate = static_cast<int>(hardware->bitRate);
  }
  switch (published.link.state) {
    case LinkState::Up: source.progress = SourceStatus::Progress::Running; break;
    case LinkState::Connecting: source.progress = SourceStatus::Progress::Opening; break;
    case LinkState::Lost: source.progress = SourceStatus::Progress::Lost; break;
    case LinkState::Closed:
      if (published.link.fault != LinkFault::None) source.progress = SourceStatus::Progress::Failed;
      break;
  }
  if (published.storeFull) source.progress = SourceStatus::Progress::Failed;
}

// The link is left: what waits then stays in the snapshot.
void keepWaiting(Snapshot& snapshot, const ServiceStatus& services) {
  if (services.unconfirmed == 0 || snapshot.source.simulated) return;
  snapshot.leftWaiting = {.interfaceName = snapshot.source.interfaceName,
                          .frames = services.unconfirmed,
                          .commands = services.waitingCommands};
}

// The source has got a fault. What was said before that is old.
bool isWorse(const SourceStatus& source, const SourceStatus& before) {
  using Progress = SourceStatus::Progress;
  const bool hasFailed = source.progress == Progress::Lost || source.progress == Progress::Failed;
  if (hasFailed && source.progress != before.progress) return true;
  return source.recording && source.recording->fault && !(before.recording && before.recording->fault);
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent), m_buses(new BusThreads(this)) {
  m_snapshot.view.state = std::make_shared<const State>();
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &Session::tick);
  connect(m_buses, &BusThreads::ended, this,
          [this](const std::shared_ptr<LogDocument>& document) { m_recorders.endOf(document); });
}

Session::~Session() {
  endSource();
  waitForEnd();
}

void Session::closeSource() {
  m_candidate.reset();
  const bool hadSimulator = m_simulator != nullptr;
  endSource();
  if (hadSimulator) Q_EMIT simulatorChanged({});
}

void Session::endBus() {
  if (m_live != nullptr) keepWaiting(m_snapshot, *m_live->latest().services);
  m_simulator = nullptr;
  m_buses->end(std::exchange(m_live, nullptr), m_document);
}

void Session::waitForEnd() {
  for (const auto& document : m_buses->waitForEnd()) m_recorders.endOf(document);
}

void Session::endSource() {
  m_timer.stop();
  m_buses->forgetWhenEnded();
  endBus();
  m_board.reset();
  std::optional<JournalStatus> left = m_recorders.leave(m_buses->isWriting(m_document));
  if (left && (m_snapshot.source.simulated || (left->path.empty() && !left->fault))) left.reset();
  m_opening.reset();
  m_walker.reset();
  m_document.reset();
  m_playback.open(nullptr);
  std::optional<LeftWaiting> waiting = std::move(m_snapshot.leftWaiting);
  m_snapshot = {};
  m_snapshot.leftRecording = left;
  m_snapshot.leftWaiting = std::move(waiting);
  m_snapshot.speed = m_playback.speed();
  m_snapshot.skipsSilences = m_playback.skipsSilences();
  m_snapshot.view.state = std::make_shared<const State>();
}

void Session::forgetSaid() {
  m_snapshot.notSent = Refusal::None;
  m_snapshot.notOpened.reset();
  m_snapshot.leftRecording.reset();
  m_snapshot.givenUpFile.reset();
}

void Session::dismiss() {
  forgetSaid();
  Q_EMIT changed();
}

void Session::beginDocument(std::shared_ptr<LogDocument> document) {
  closeSource();
  m_document = std::move(document);
  m_labels.begin();
  m_indexed = {};
  m_walker = std::make_unique<StateWalker>(m_document);
  m_playback.open(&m_document->frames);
  m_snapshot.view.document = m_document;
  m_timer.start(LiveBus::kTick);
}

bool Session::holdsUnwritten() const { return m_recorders.holdUnwritten(); }

void Session::setSaved(const std::shared_ptr<const LogDocument>& document, std::uint64_t frames,
                       std::size_t notes) {
  if (document == m_document && frames >= document->frames.count() && notes >= document->notes.count() &&
      std::exchange(m_snapshot.source.unkeptMarks, {})) {
    if (isRead()) m_marks.forget();
    Q_EMIT changed();
  }
  if (m_recorders.setSaved(document, frames, notes)) return;
  // A recording of earlier that is open as a file.
  const SourceStatus& source = m_snapshot.source;
  const ReadSummary& read = source.read;
  if (document != m_document || source.progress != SourceStatus::Progress::Done || frames < read.frames ||
      read.isOpenEnded || !read.isWhole())
    return;
  if (read.isOwn)
    std::thread([path = QFile::encodeName(source.name).toStdString()] { markJournalSaved(path); }).detach();
}

void Session::openLog(const QString& path, TimesOf times) {
  forgetSaid();
  // To open it would end it.
  if (const auto open = m_recorders.status();
      open && QFileInfo(path) == QFileInfo(QFile::decodeName(open->path.c_str()))) {
    m_snapshot.notOpened = NotOpened{.path = path, .error = {}, .isInView = true};
    Q_EMIT changed();
    return;
  }
  Candidate log{path, times, std::make_shared<LogDocument>(), nullptr};
  log.opening = std::make_unique<LogOpening>(log.document, path, times == TimesOf::Differences);
  const bool isWorthKeeping = m_board != nullptr || m_simulator != nullptr || m_buses->isAwaited() ||
                              (m_document != nullptr && m_document->frames.count() > 0);
  if (!isWorthKeeping) return show(std::move(log));
  m_candidate = std::move(log);
  Q_EMIT changed();
}

void Session::show(Candidate log) {
  beginDocument(log.document);
  m_playback.open(&m_document->frames, Playback::Start::AtBegin);
  m_snapshot.source.kind = SourceStatus::Kind::File;
  m_snapshot.source.progress = SourceStatus::Progress::Opening;
  m_snapshot.source.name = log.path;
  m_snapshot.source.addsUpTimes = log.times == TimesOf::Differences;
  m_opening = std::move(log.opening);
  place();
  Q_EMIT changed();
}

void Session::followCandidate() {
  if (!m_candidate || m_snapshot.source.isKeepingMarks) return;
  const auto* outcome = m_candidate->opening->outcome();
  if (m_candidate->document->frames.count() > 0) {
    // A mark made meanwhile that could not be kept would be lost.
    if (m_snapshot.source.unkeptMarks) return m_candidate.reset();
    return show(*std::exchange(m_candidate, {}));
  }
  if (outcome == nullptr) return;
  m_snapshot.notOpened = NotOpened{.path = m_candidate->path, .error = {}};
  if (!*outcome) m_snapshot.notOpened->error = outcome->error();
  m_candidate.reset();
  Q_EMIT changed();
}

Cursor Session::endCursor() const {
  if (grows()) return m_board->latest().state->cursor();
  return m_document == nullptr ? Cursor{} : endOf(m_document->frames, m_document->notes);
}

void Session::place() {
  LogView& view = m_snapshot.view;
  view.begin = m_playback.begin();
  view.end = m_playback.end().time;
  view.frameCount = m_playback.end().frames;
  view.cursor = m_playback.cursor();
  view.atEnd = m_playback.isAtEnd();
  m_snapshot.playing = m_playback.isPlaying();
  m_snapshot.speed = m_playback.speed();
  m_snapshot.isLooping = m_playback.loop().has_value();
  m_snapshot.skipsSilences = m_playback.skipsSilences();
  m_snapshot.skipped = m_playback.skipped();
  if (m_walker != nullptr && !isLiveEdge()) m_walker->request(view.cursor);
}

void Session::play() {
  if (m_document == nullptr || m_playback.isPlaying()) return;
  forgetSaid();
  m_playback.reach(endCursor(), grows());
  if (!m_playback.play(monotonicTime())) return;
  place();
  Q_EMIT changed();
}

void Session::pause() {
  if (m_document == nullptr) return;
  forgetSaid();
  if (!m_playback.pause()) return;
  place();
  Q_EMIT changed();
}

void Session::seek(Instant time) {
  if (m_document == nullptr) return;
  forgetSaid();
  m_playback.seek(time);
  place();
  Q_EMIT changed();
}

void Session::seekFrames(std::uint64_t frames) {
  if (m_document == nullptr) return;
  forgetSaid();
  m_playback.seekFrames(frames);
  place();
  Q_EMIT changed();
}

void Session::step(int frames) {
  if (m_document == nullptr) return;
  forgetSaid();
  m_playback.step(frames);
  place();
  Q_EMIT changed();
}

void Session::goToEnd() {
  if (m_document == nullptr) return;
  forgetSaid();
  m_playback.goToEnd();
  tick();
  Q_EMIT changed();
}

void Session::mark(Cursor at, const QString& text) {
  if (m_document == nullptr) return;
  forgetSaid();
  m_document->notes.append({.frame = at.frames, .time = at.time, .value = note::Mark{text.toStdString()}});
  keepMarks();
  Q_EMIT changed();
}

void Session::keepMarks() {
  SourceStatus& source = m_snapshot.source;
  if (source.kind != SourceStatus::Kind::File) return;
  if (source.progress == SourceStatus::Progress::Opening) {
    source.unkeptMarks = UnkeptMarks{UnkeptMarks::Why::LogIsBeingRead};
  } else if (!isRead()) {
    source.unkeptMarks = UnkeptMarks{UnkeptMarks::Why::LogIsCut};
  } else {
    m_marks.keep(m_document);
    followMarks();
  }
}

void Session::followMarks() {
  MarkKeeper::Status status = m_marks.status(bootTime());
  m_snapshot.source.isKeepingMarks = status.isBusy;
  m_snapshot.source.unkeptMarks = std::move(status.unkept);
}

void Session::setLabels(LabelsByPin labels) {
  m_labels.set(std::move(labels));
  if (grows()) m_labels.note(*m_document, *m_board->latest().state);
}

void Session::setSpeed(double speed) {
  forgetSaid();
  m_playback.setSpeed(speed);
  place();
  Q_EMIT changed();
}

void Session::setLoop(std::optional<LoopSpan> span) {
  if (m_document == nullptr) return;
  forgetSaid();
  const bool begins = span && !m_playback.loop();
  m_playback.setLoop(span);
  if (begins) m_playback.play(monotonicTime());
  place();
  Q_EMIT changed();
}

void Session::setSkipsSilences(bool skips) {
  m_playback.setSkipsSilences(skips);
  place();
  Q_EMIT changed();
}

void Session::updateSource() {
  SourceStatus& source = m_snapshot.source;
  if (m_opening != nullptr) {
    source.fraction = m_opening->fraction();
    source.unreadable = m_document->skipped.content().unreadable();
    const auto* outcome = m_opening->outcome();
    if (outcome != nullptr && source.progress == SourceStatus::Progress::Opening) takeOutcome(*outcome);
    if (isRead()) followMarks();
  }
  if (const auto recording = m_recorders.status()) {
    if (source.recording && source.recording->givenUp != recording->givenUp)
      m_snapshot.givenUpFile = recording->givenUp;
    source.recording = recording;
  }
}

void Session::takeOutcome(const LogOpening::Outcome& outcome) {
  SourceStatus& source = m_snapshot.source;
  source.fraction = 1;
  source.progress = outcome ? SourceStatus::Progress::Done : SourceStatus::Progress::Failed;
  if (outcome) {
    source.read = outcome.value();
    if (source.read.hasSidecar) m_walker->notesCame();
    m_marks.opened(source.name, source.read, m_opening->sidecarTime());
  } else {
    source.error = outcome.error();
  }
  if (source.unkeptMarks) keepMarks();
}

// While a log is played the state moves on a tick behind the cursor. Far from every keyframe it stands still until the
// walker has found it.
void Session::followWalk() {
  const Cursor here = m_snapshot.view.state->cursor();
  const Instant now = monotonicTime();
  if (here == m_snapshot.view.cursor || std::exchange(m_walkedTo, here) != here) m_walkedAt = now;
  m_snapshot.isCatchingUp = now - m_walkedAt >= kCatchesUp;
}

void Session::tick() {
  followCandidate();
  if (m_document == nullptr) return;
  const Snapshot before = m_snapshot;
  LiveBus::Published published;
  if (grows()) published = m_live != nullptr ? m_live->take() : m_board->latest();
  m_timer.start(m_live != nullptr ? kUnlessTold : LiveBus::kTick);
  if (m_live != nullptr) {
    m_snapshot.services = published.services;
    takeLink(m_snapshot, published);
  }
  updateSource();
  if (isWorse(m_snapshot.source, before.source)) {
    m_snapshot.notSent = Refusal::None;
    m_snapshot.notOpened.reset();
  }
  if (grows()) m_labels.note(*m_document, *published.state);
  const Cursor end = grows() ? published.state->cursor() : endCursor();
  m_playback.reach(end, grows());
  m_playback.timeCame(monotonicTime(), m_walker->latest()->cursor());
  place();
  LogView& view = m_snapshot.view;
  view.state = isLiveEdge() ? published.state : m_walker->latest();
  followWalk();
  view.found = m_document->events.count() + m_document->exchanges.list()->size();
  // The walker's indexes grow with the log, wherever the cursor stands, and its events with time alone.
  if (end != m_indexed) m_walker->index(end);
  m_indexed = end;
  const bool same = before.view.state == view.state && before.view.cursor == view.cursor &&
                    before.view.frameCount == view.frameCount && before.view.found == view.found &&
                    before.source == m_snapshot.source && before.playing == m_snapshot.playing &&
                    before.skipped == m_snapshot.skipped && before.isCatchingUp == m_snapshot.isCatchingUp &&
                    before.services == m_snapshot.services;
  if (!same) Q_EMIT changed();
}

}  // namespace deckpipe
