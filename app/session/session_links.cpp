// SPDX-License-Identifier: GPL-3.0-or-later
// The session's links: opened, recorded, begun anew, and what the window wants of them and of the demo's truck.
#include <utility>

#include "link/adapters.h"
#include "session/bus_threads.h"
#include "session/clocks.h"
#include "session/recorder.h"
#include "session/session.h"
#include "session/simulator_runner.h"

namespace deckpipe {

void Session::beginRecording() {
  if (m_recordingFolder.isEmpty()) return;
  m_recorders.begin(m_document, recordingIn(m_recordingFolder), m_snapshot.source.simulated);
  m_snapshot.source.recording.emplace();
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
  m_buses->whenEnded([this] { startLink(m_lastLink, m_lastLink.interfaceName); });
  Q_EMIT changed();
}

void Session::startLink(LinkSettings settings, const QString& channelName) {
  settings.channel = {m_document->frames.channel(channelName.toStdString())};
  keepServerOnThisThread(settings.plugin, settings.interfaceName);
  m_live = new LiveBus(m_document, settings, m_claim, m_board);
  m_board = m_live->board();
  connect(m_live, &LiveBus::ticked, this, &Session::tick);
  m_buses->start(
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
  m_buses->whenEnded([this] {
    if (!m_buses->isWriting(m_document)) return startLink(m_lastLink, m_lastLink.interfaceName);
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
  m_snapshot.source.plugin = QStringLiteral("virtualcan");
  m_snapshot.source.interfaceName = QStringLiteral("can0");
  m_snapshot.source.bitRate = LinkSettings{}.bitRate;
  beginRecording();
  m_simulator = new SimulatorRunner;
  // The simulator is on the bus first: frames written before the other end listens reach nobody.
  // A signal of a simulator that was closed meanwhile may still be on its way: it is not for what is open now.
  const std::weak_ptr<LogDocument> own = m_document;
  connect(m_simulator, &SimulatorRunner::busReady, this, [this, own](const QString& interfaceName) {
    if (m_document == nullptr || own.lock() != m_document || m_live != nullptr) return;
    startLink({QStringLiteral("virtualcan"), interfaceName, LinkSettings{}.bitRate, {}},
              QStringLiteral("can0"));
  });
  connect(m_simulator, &SimulatorRunner::simulatorChanged, this, [this, own](const SimulatorStatus& status) {
    if (m_document != nullptr && own.lock() == m_document) Q_EMIT simulatorChanged(status);
  });
  connect(m_simulator, &SimulatorRunner::failed, this, [this, own](const LinkError& why) {
    if (m_document == nullptr || own.lock() != m_document) return;
    m_snapshot.source.progress = SourceStatus::Progress::Failed;
    m_snapshot.source.error = why;
    Q_EMIT changed();
  });
  m_buses->start(
      m_simulator, [simulator = m_simulator] { simulator->startDemo(); }, [] {});
  Q_EMIT changed();
}

std::uint64_t Session::intend(Intent intent) {
  const auto refusal = [&] {
    if (onlyStops(intent)) return Refusal::None;
    if (m_live == nullptr) return Refusal::NoLink;
    if (!m_snapshot.view.atEnd) return Refusal::NotLive;
    return m_live->latest().storeFull ? Refusal::LogFull : Refusal::None;
  }();
  const bool isNew = m_snapshot.notSent != refusal || m_snapshot.notOpened || m_snapshot.leftRecording ||
                     m_snapshot.givenUpFile;
  forgetSaid();
  m_snapshot.notSent = refusal;
  if (isNew) Q_EMIT changed();
  if (refusal != Refusal::None || m_live == nullptr) return 0;
  const StampedIntent stamped{std::move(intent), bootTime(), ++m_serial};
  QMetaObject::invokeMethod(
      m_live, [live = m_live, stamped] { live->apply(stamped); }, Qt::QueuedConnection);
  return stamped.serial;
}

void Session::sayDrive(Address address, bool isDrive) {
  if (m_live == nullptr) return;
  QMetaObject::invokeMethod(
      m_live, [live = m_live, address, isDrive] { live->sayDrive(address, isDrive); }, Qt::QueuedConnection);
}

void Session::intendForSimulator(const SimulatorIntent& intent) {
  if (m_simulator == nullptr) return;
  QMetaObject::invokeMethod(
      m_simulator, [simulator = m_simulator, intent] { simulator->obey(intent); }, Qt::QueuedConnection);
}

}  // namespace deckpipe
