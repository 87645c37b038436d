// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <QDeadlineTimer>
#include <QFile>
#include <QFileInfo>
#include <QThread>
#include <algorithm>
#include <thread>
#include <utility>

#include "session/bench_runner.h"
#include "session/live_bus.h"
#include "session/log_opening.h"
#include "session/recorder.h"
#include "session/state_walker.h"
#include "session/worker_thread.h"

namespace deckpipe {
namespace {

SourceError errorOf(const LiveBus::Published& published) {
  const LinkStatus& link = published.link;
  if (published.storeFull) return StoreFull{};
  if (link.fault == LinkFault::None && link.reason.empty()) return {};
  return LinkError{link.fault, link.reason};
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
  m_snapshot.view.state = std::make_shared<const State>();
  m_timer.setInterval(kTick);
  connect(&m_timer, &QTimer::timeout, this, &Session::tick);
}

Session::~Session() {
  endSource();
  waitForEnd();
}

// Links, and in the demo the twin, live on one thread with an event loop. When it ends, each is stopped and
// deleted there.
void Session::startOnBusThread(QObject* worker, std::function<void()> start, std::function<void()> stop) {
  if (m_busThread == nullptr) {
    m_busThread = new QThread(this);
    m_busThread->setObjectName(QStringLiteral("bus"));
    m_busThread->start();
  }
  worker->moveToThread(m_busThread);
  connect(m_busThread, &QThread::finished, worker, std::move(stop));
  connect(m_busThread, &QThread::finished, worker, &QObject::deleteLater);
  QMetaObject::invokeMethod(worker, std::move(start), Qt::QueuedConnection);
}

void Session::closeSource() {
  m_candidate.reset();
  const bool hadTwin = m_bench != nullptr;
  endSource();
  if (hadTwin) Q_EMIT twinChanged({});
}

void Session::endBus() {
  LiveBus* live = std::exchange(m_live, nullptr);
  m_bench = nullptr;
  QThread* thread = std::exchange(m_busThread, nullptr);
  if (thread == nullptr) return;
  const std::uint64_t number = ++m_busNumber;
  m_ending.push_back({number, thread, m_document});
  connect(thread, &QThread::finished, this, [this, number] { busHasEnded(number); });
  QTimer::singleShot(kThreadPatience, this, [this, number] { busHangs(number); });
  if (live != nullptr) {
    QMetaObject::invokeMethod(live, &LiveBus::close, Qt::QueuedConnection);
  } else {
    thread->quit();
  }
}

void Session::busHasEnded(std::uint64_t number) {
  const auto ended = std::ranges::find(m_ending, number, &EndingBus::number);
  if (ended == m_ending.end()) return;
  const auto document = ended->document;
  ended->thread->deleteLater();
  m_ending.erase(ended);
  if (!isWrittenByEndingBus(document)) {
    for (const auto& recorder : m_oldRecorders) {
      if (recorder->isOf(document)) recorder->end();
    }
  }
  whenBusHasEnded(std::exchange(m_whenBusHasEnded, nullptr));
}

void Session::busHangs(std::uint64_t number) {
  const auto found = std::ranges::find(m_ending, number, &EndingBus::number);
  if (found == m_ending.end()) return;
  found->hangs = true;
  leaveThread(found->thread);
  whenBusHasEnded(std::exchange(m_whenBusHasEnded, nullptr));
}

void Session::waitForEnd() {
  const QDeadlineTimer deadline(kThreadPatience);
  for (const EndingBus& bus : std::vector(m_ending)) {
    if (bus.hangs) continue;
    bus.thread->wait(deadline) ? busHasEnded(bus.number) : busHangs(bus.number);
  }
}

bool Session::isWrittenByEndingBus(const std::shared_ptr<LogDocument>& document) const {
  return std::ranges::find(m_ending, document, &EndingBus::document) != m_ending.end();
}

void Session::whenBusHasEnded(std::function<void()> start) {
  m_whenBusHasEnded = std::move(start);
  if (m_whenBusHasEnded && std::ranges::all_of(m_ending, &EndingBus::hangs))
    std::exchange(m_whenBusHasEnded, nullptr)();
}

void Session::endSource() {
  m_timer.stop();
  m_whenBusHasEnded = nullptr;
  endBus();
  m_board.reset();
  std::optional<JournalStatus> left;
  if (m_recorder != nullptr) {
    left = m_recorder->status();
    if (m_snapshot.source.simulated || left->path.empty()) left.reset();
    if (!isWrittenByEndingBus(m_document)) m_recorder->end();
    m_oldRecorders.push_back(std::move(m_recorder));
  }
  m_opening.reset();
  m_walker.reset();
  m_document.reset();
  m_snapshot = {};
  m_snapshot.leftRecording = left;
  m_snapshot.view.state = std::make_shared<const State>();
}

void Session::forgetSaid() {
  m_snapshot.notSent = Refusal::None;
  m_snapshot.notOpened.reset();
  m_snapshot.leftRecording.reset();
}

void Session::beginDocument(std::shared_ptr<LogDocument> document) {
  closeSource();
  m_document = std::move(document);
  m_indexed = {};
  m_walker = std::make_unique<StateWalker>(m_document);
  m_snapshot.view.document = m_document;
  m_timer.start();
}

void Session::beginRecording() {
  if (m_recordingFolder.isEmpty()) return;
  m_recorder =
      std::make_unique<Recorder>(m_document, recordingIn(m_recordingFolder), m_snapshot.source.simulated);
  m_snapshot.source.recording.emplace();
}

bool Session::holdsUnwritten() const {
  const auto isUnwritten = [](const auto& recorder) { return recorder && recorder->status().fault; };
  return isUnwritten(m_recorder) || std::ranges::any_of(m_oldRecorders, isUnwritten);
}

void Session::setSaved(const std::shared_ptr<const LogDocument>& document, std::uint64_t frames) {
  if (m_recorder != nullptr && m_recorder->isOf(document)) return m_recorder->setSaved(frames);
  for (const auto& recorder : m_oldRecorders) {
    if (recorder->isOf(document)) return recorder->setSaved(frames);
  }
  // A recording of earlier that is open as a file.
  const SourceStatus& source = m_snapshot.source;
  const ReadSummary& read = source.read;
  if (document != m_document || source.progress != SourceStatus::Progress::Done || frames < read.frames ||
      read.isOpenEnded || read.cutBytes > 0 || read.newerParts > 0)
    return;
  if (source.name.endsWith(QLatin1String(".deckpipe")))
    std::thread([path = QFile::encodeName(source.name).toStdString()] { markJournalSaved(path); }).detach();
}

void Session::openLog(const QString& path, TimesOf times) {
  forgetSaid();
  // To open it would end it.
  if (m_recorder != nullptr &&
      QFileInfo(path) == QFileInfo(QFile::decodeName(m_recorder->status().path.c_str()))) {
    m_snapshot.notOpened = NotOpened{.path = path, .error = {}, .isInView = true};
    Q_EMIT changed();
    return;
  }
  Candidate log{path, times, std::make_shared<LogDocument>(), nullptr};
  log.opening = std::make_unique<LogOpening>(log.document, path, times == TimesOf::Differences);
  const bool isWorthKeeping = m_board != nullptr || m_bench != nullptr || m_whenBusHasEnded != nullptr ||
                              (m_document != nullptr && m_document->frames.count() > 0);
  if (!isWorthKeeping) return show(std::move(log));
  m_candidate = std::move(log);
  Q_EMIT changed();
}

void Session::show(Candidate log) {
  beginDocument(log.document);
  m_snapshot.source.kind = SourceStatus::Kind::File;
  m_snapshot.source.progress = SourceStatus::Progress::Opening;
  m_snapshot.source.name = log.path;
  m_snapshot.source.addsUpTimes = log.times == TimesOf::Differences;
  m_opening = std::move(log.opening);
  Q_EMIT changed();
}

void Session::followCandidate() {
  if (!m_candidate) return;
  const auto* outcome = m_candidate->opening->outcome();
  if (m_candidate->document->frames.count() > 0) return show(*std::exchange(m_candidate, {}));
  if (outcome == nullptr) return;
  m_snapshot.notOpened = NotOpened{.path = m_candidate->path, .error = {}};
  if (!*outcome) m_snapshot.notOpened->error = outcome->error();
  m_candidate.reset();
  Q_EMIT changed();
}

void Session::openLink(const LinkSettings& wanted) {
  const LinkSettings settings = wanted;  // may be our own last ones
  beginDocument(std::make_shared<LogDocument>());
  m_lastLink = settings;
  m_snapshot.source.kind = SourceStatus::Kind::Link;
  m_snapshot.source.progress = SourceStatus::Progress::Opening;
  m_snapshot.source.plugin = settings.plugin;
  m_snapshot.source.interfaceName = settings.interfaceName;
  m_snapshot.source.name = settings.plugin + QLatin1Char(' ') + settings.interfaceName;
  m_snapshot.source.bitRate = settings.bitRate;
  beginRecording();
  whenBusHasEnded([this] { startLink(m_lastLink, m_lastLink.interfaceName); });
  Q_EMIT changed();
}

void Session::startLink(LinkSettings settings, const QString& channelName) {
  settings.channel = {m_document->frames.channel(channelName.toStdString())};
  m_live = new LiveBus(m_document, settings, m_claim, m_board);
  m_board = m_live->board();
  startOnBusThread(
      m_live, [live = m_live] { live->start(); }, [live = m_live] { live->stop(); });
}

void Session::reconnect() {
  if (m_snapshot.source.simulated) return openDemo();
  if (m_board == nullptr || m_board->latest().storeFull) return openLink(m_lastLink);
  forgetSaid();
  endBus();
  m_snapshot.source.progress = SourceStatus::Progress::Opening;
  m_snapshot.source.error = {};
  m_snapshot.services = std::make_shared<const ServiceStatus>();
  whenBusHasEnded([this] {
    if (!isWrittenByEndingBus(m_document)) return startLink(m_lastLink, m_lastLink.interfaceName);
    // A bus that hangs may still write into the log, and one log has one writer.
    std::optional<Candidate> candidate = std::exchange(m_candidate, {});
    openLink(m_lastLink);
    m_candidate = std::move(candidate);
  });
  Q_EMIT changed();
}

void Session::openDemo() {
  beginDocument(std::make_shared<LogDocument>());
  m_snapshot.source.kind = SourceStatus::Kind::Link;
  m_snapshot.source.progress = SourceStatus::Progress::Opening;
  m_snapshot.source.simulated = true;
  m_snapshot.source.name = tr("Bench twin");
  m_snapshot.source.plugin = QStringLiteral("virtualcan");
  m_snapshot.source.interfaceName = QStringLiteral("can0");
  m_snapshot.source.bitRate = LinkSettings{}.bitRate;
  beginRecording();
  m_bench = new BenchRunner;
  // The twin is on the bus first: frames written before the other end listens reach nobody.
  // A signal of a twin that was closed meanwhile may still be on its way: it is not for what is open now.
  const std::weak_ptr<LogDocument> own = m_document;
  connect(m_bench, &BenchRunner::busReady, this, [this, own](const QString& interfaceName) {
    if (m_document == nullptr || own.lock() != m_document || m_live != nullptr) return;
    startLink({QStringLiteral("virtualcan"), interfaceName, LinkSettings{}.bitRate, {}},
              QStringLiteral("can0"));
  });
  connect(m_bench, &BenchRunner::twinChanged, this, [this, own](const TwinStatus& status) {
    if (m_document != nullptr && own.lock() == m_document) Q_EMIT twinChanged(status);
  });
  connect(m_bench, &BenchRunner::failed, this, [this, own](const QString& reason) {
    if (m_document == nullptr || own.lock() != m_document) return;
    m_snapshot.source.progress = SourceStatus::Progress::Failed;
    m_snapshot.source.error = LinkError{LinkFault::Other, reason.toStdString()};
    Q_EMIT changed();
  });
  startOnBusThread(
      m_bench, [bench = m_bench] { bench->startDemo(); }, [] {});
  Q_EMIT changed();
}

std::uint64_t Session::want(Wish wish) {
  const auto refusal = [&] {
    if (onlyStops(wish)) return Refusal::None;
    if (m_live == nullptr) return Refusal::NoLink;
    if (!m_snapshot.view.atEnd) return Refusal::NotLive;
    return m_live->latest().storeFull ? Refusal::LogFull : Refusal::None;
  }();
  if (std::exchange(m_snapshot.notSent, refusal) != refusal) Q_EMIT changed();
  if (refusal != Refusal::None || m_live == nullptr) return 0;
  const Intent intent{std::move(wish), bootTime(), ++m_serial};
  QMetaObject::invokeMethod(
      m_live, [live = m_live, intent] { live->apply(intent); }, Qt::QueuedConnection);
  return intent.serial;
}

void Session::sayDrive(Address address, bool isDrive) {
  if (m_live == nullptr) return;
  QMetaObject::invokeMethod(
      m_live, [live = m_live, address, isDrive] { live->sayDrive(address, isDrive); }, Qt::QueuedConnection);
}

void Session::wantOfTwin(const TwinWish& wish) {
  if (m_bench == nullptr) return;
  QMetaObject::invokeMethod(
      m_bench, [bench = m_bench, wish] { bench->obey(wish); }, Qt::QueuedConnection);
}

Cursor Session::endCursor() const {
  if (grows()) return m_board->latest().state->cursor();
  return m_document == nullptr ? Cursor{} : endOf(m_document->frames, m_document->notes);
}

void Session::setCursor(Cursor cursor) {
  m_snapshot.view.cursor = cursor;
  if (m_walker != nullptr) m_walker->request(cursor);
}

void Session::play() {
  if (m_document == nullptr || m_snapshot.playing) return;
  forgetSaid();
  LogView& view = m_snapshot.view;
  if (view.atEnd && grows()) return;  // it goes on by itself
  const Cursor end = endCursor();
  if (view.cursor.frames >= end.frames && !grows()) setCursor({0, view.begin});
  view.atEnd = false;
  m_snapshot.playing = true;
  m_playClock.start();
  Q_EMIT changed();
}

void Session::pause() {
  if (m_document == nullptr) return;
  forgetSaid();
  if (!m_snapshot.playing && !m_snapshot.view.atEnd) return;
  m_snapshot.playing = false;
  m_snapshot.view.atEnd = false;
  Q_EMIT changed();
}

void Session::seek(Instant time) {
  if (m_document == nullptr) return;
  forgetSaid();
  m_snapshot.playing = false;
  m_snapshot.view.atEnd = false;
  setCursor(cursorAt(m_document->frames, std::clamp(time, m_snapshot.view.begin,
                                                    std::max(m_snapshot.view.begin, m_snapshot.view.end))));
  Q_EMIT changed();
}

void Session::seekFrames(std::uint64_t frames) {
  if (m_document == nullptr) return;
  forgetSaid();
  m_snapshot.playing = false;
  m_snapshot.view.atEnd = false;
  setCursor(cursorAfter(m_document->frames, std::min(frames, m_document->frames.count())));
  Q_EMIT changed();
}

void Session::step(int frames) {
  const std::uint64_t here = m_snapshot.view.cursor.frames;
  const auto back = static_cast<std::uint64_t>(std::abs(frames));
  seekFrames(frames < 0 ? here - std::min(here, back) : here + back);
}

void Session::goToEnd() {
  if (m_document == nullptr) return;
  forgetSaid();
  m_snapshot.playing = false;
  m_snapshot.view.atEnd = true;
  tick();
  Q_EMIT changed();
}

void Session::mark(Cursor at, const QString& text) {
  if (m_document == nullptr) return;
  m_document->notes.append({.frame = at.frames, .time = at.time, .value = note::Mark{text.toStdString()}});
  Q_EMIT changed();
}

void Session::setSpeed(double speed) {
  m_snapshot.speed = std::clamp(speed, kSlowest, kFastest);
  Q_EMIT changed();
}

void Session::movePlayingCursor() {
  const Duration passed{
      static_cast<std::int64_t>(static_cast<double>(m_playClock.nsecsElapsed()) * m_snapshot.speed)};
  m_playClock.start();
  const Instant target = m_snapshot.view.cursor.time + passed;
  const Cursor end = endCursor();
  if (target < end.time) {
    setCursor(cursorAt(m_document->frames, target));
    return;
  }
  setCursor(end);
  m_snapshot.playing = false;
  m_snapshot.view.atEnd = true;
}

void Session::updateSource() {
  SourceStatus& source = m_snapshot.source;
  if (m_opening != nullptr) {
    source.fraction = m_opening->fraction();
    const UnkeptPlaces unkept = m_document->unkept.content();
    source.unreadable = unkept.unreadable();
    source.notKept = unkept.skipped();
    if (const auto* outcome = m_opening->outcome()) {
      const bool isNews = source.progress == SourceStatus::Progress::Opening;
      if (isNews && *outcome && outcome->value().hasSidecar) m_walker->notesCame();
      source.fraction = 1;
      source.progress = *outcome ? SourceStatus::Progress::Done : SourceStatus::Progress::Failed;
      if (*outcome) {
        source.read = outcome->value();
        source.notKept += m_document->notes.missedFrames();
      } else {
        source.error = outcome->error();
      }
    }
  }
  if (m_recorder != nullptr) source.recording = m_recorder->status();
  if (m_live == nullptr) return;
  const LiveBus::Published published = m_live->latest();
  m_snapshot.services = published.services;
  source.notKept = published.notKept;
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

void Session::tick() {
  followCandidate();
  if (m_document == nullptr) return;
  const Snapshot before = m_snapshot;
  updateSource();
  LogView& view = m_snapshot.view;
  const FrameStore& frames = m_document->frames;
  const Cursor end = endCursor();
  view.frameCount = end.frames;
  view.begin = end.frames == 0 ? end.time : frames.timeAt(0);
  view.end = end.time;
  if (view.atEnd) {
    view.cursor = end;
  } else if (m_snapshot.playing) {
    movePlayingCursor();
  }
  if (view.atEnd && grows()) {
    view.state = m_board->latest().state;
    view.cursor = view.state->cursor();
  } else {
    m_walker->request(view.cursor);
    view.state = m_walker->latest();
  }
  // The walker's indexes grow with the log, wherever the cursor stands, and its events with time alone.
  if (end != m_indexed) m_walker->index(end);
  m_indexed = end;
  const bool same = before.view.state == view.state && before.view.cursor == view.cursor &&
                    before.view.frameCount == view.frameCount && before.source == m_snapshot.source &&
                    before.playing == m_snapshot.playing && before.services == m_snapshot.services;
  if (!same) Q_EMIT changed();
}

}  // namespace deckpipe
