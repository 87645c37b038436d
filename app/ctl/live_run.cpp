// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_run.h"

#include <QCoreApplication>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "counts.h"
#include "link/adapters.h"
#include "link_words.h"
#include "request_words.h"
#include "session/stop_signals.h"

namespace deckpipe::ctl {

namespace {

QString reasonOf(const SourceError& error) {
  if (std::holds_alternative<StoreFull>(error))
    return QStringLiteral("No room for more frames, neither in memory nor on disk.");
  const auto* link = std::get_if<LinkError>(&error);
  return linkErrorText(link != nullptr ? *link : LinkError{});
}

}  // namespace

LiveRun::LiveRun(const LiveSettings& settings, bool wantsAddress)
    : onStop([] { return kNotWhole; }), m_settings(settings), m_wantsAddress(wantsAddress) {}

void LiveRun::say(const QString& message) const {
  std::fprintf(stderr, "deckpipectl: %s\n", qPrintable(message));
}

void LiveRun::after(double seconds, std::function<void()> call) {
  QTimer::singleShot(std::chrono::milliseconds(static_cast<int>(seconds * 1000)), this, std::move(call));
}

ExitStatus LiveRun::run() {
  // Before the session starts its threads.
  onStopSignals([this] { stop(); });
  m_session.setClaim(m_settings.claim);
  connect(&m_session, &Session::changed, this, &LiveRun::changed);
  m_session.openLink(m_settings.link);
  for (const Address drive : m_settings.drives) m_session.sayDrive(drive, true);
  QCoreApplication::exec();
  // What is said at the end is waited for, 1 s at most; what waits in the adapter then is not.
  const auto log = snapshot().view.document;
  const std::size_t before = log->notes.count();
  m_session.closeSource();
  m_session.waitForEnd();
  std::vector<Note> notes = log->notes.all();
  notes.erase(notes.begin(), notes.begin() + static_cast<std::ptrdiff_t>(std::min(before, notes.size())));
  for (const Note& note : notes) {
    if (const auto* waits = std::get_if<note::StillWaits>(&note.value))
      say(QString::fromStdString(framesThat(waits->count, "is", "are")) +
          QStringLiteral(" not on the bus yet and may still go out"));
  }
  return m_status;
}

void LiveRun::stop() {
  if (m_isOver) return;
  const std::optional<ExitStatus> status = m_isReady ? onStop() : kNotWhole;
  if (status) finish(*status);
}

void LiveRun::finish(ExitStatus status) {
  if (m_isOver) return;
  m_isOver = true;
  m_status = m_output.flush() ? status : kNotWhole;
  QCoreApplication::quit();
}

bool LiveRun::isLinkUp() {
  const SourceStatus& source = snapshot().source;
  using Progress = SourceStatus::Progress;
  if (source.progress == Progress::Failed) {
    say(m_settings.link.interfaceName + QStringLiteral(": ") + reasonOf(source.error));
    finish(kNotWhole);
  } else if (m_follower.linkDowns() != m_linkDowns) {
    m_linkDowns = m_follower.linkDowns();
    // A link that is back already has no error any more; only its note tells the reason.
    const auto* error = std::get_if<LinkError>(&source.error);
    linkWentDown(linkErrorText(error != nullptr ? *error : m_follower.linkDownReason()));
  }
  if (m_isOver || source.progress != Progress::Running) return false;
  if (std::exchange(m_isWaiting, false)) say(m_settings.link.interfaceName + QStringLiteral(": is back"));
  return true;
}

void LiveRun::linkWentDown(const QString& reason) {
  const QString why = m_settings.link.interfaceName + QStringLiteral(": ") + reason;
  if (!outlivesLink || !isSocketCan(m_settings.link.plugin)) {
    say(why);
    return finish(kNotWhole);
  }
  m_isWaiting = true;
  // The lost link has locked sending.
  const bool wasUnlocked = std::exchange(m_settings.unlock, false);
  say(why + (wasUnlocked ? QStringLiteral("; waiting for it; sending is locked from now on.")
                         : QStringLiteral("; waiting for it.")));
}

void LiveRun::unlock() {
  m_unlockSerial = m_session.intend(intent::Unlock{});
  if (m_unlockSerial == 0) return unlockRefused(snapshot().notSent);
  if (!m_wantsAddress) return;
  QTimer::singleShot(kAddressPatience, this, [this] {
    if (m_isReady || m_isOver) return;
    say(QStringLiteral("no address after %1 s: our claim is not on the bus, or is contested again and again")
            .arg(kAddressPatience.count()));
    finish(kNotWhole);
  });
}

void LiveRun::unlockRefused(Refusal why) {
  m_unlockSerial = 0;
  say(m_settings.link.interfaceName + QStringLiteral(": cannot send: ") +
      QLatin1String(kRefusalWords[why].sentence));
  if (m_wantsAddress) finish(kNotWhole);
}

bool LiveRun::hasAddress() {
  using Progress = ClaimStatus::Progress;
  const ClaimStatus& claim = services().claim;
  if (claim.progress == Progress::Claimed) return true;
  if (claim.progress != Progress::CannotClaim && claim.progress != Progress::SameName) return false;
  if (!std::exchange(m_saidClaim, true))
    say(claim.progress == Progress::SameName
            ? QStringLiteral("another node on the bus has our very NAME; give another --identity")
            : QStringLiteral("no address can be had: all are taken"));
  if (m_wantsAddress) finish(kNotWhole);
  return false;
}

void LiveRun::saySent() {
  const ServiceStatus& now = services();
  if (!now.echoes && !now.locked && !std::exchange(m_saidCannotTell, true))
    say(QStringLiteral("cannot tell whether frames reach the bus: this adapter does not say"));
  if (now.unconfirmed > m_unconfirmed)
    say(QStringLiteral("not on the bus yet, and may still go out: ") +
        QString::fromStdString(framesText(now.unconfirmed)));
  if (now.notTaken > m_notTaken)
    say(QStringLiteral("not taken by the adapter, and so not sent: ") +
        QString::fromStdString(framesText(now.notTaken)));
  m_unconfirmed = now.unconfirmed;
  m_notTaken = now.notTaken;
}

void LiveRun::changed() {
  if (m_isOver) return;
  // The requests that the link took along get their lines before the run ends.
  m_follower.follow(snapshot().view);
  const bool isUp = isLinkUp();
  if (m_isOver) return;
  if (isUp && m_settings.unlock && !m_askedToUnlock && mayUnlock()) {
    m_askedToUnlock = true;
    unlock();
  }
  if (m_isOver) return;
  if (m_unlockSerial != 0 && services().refusedSerial == m_unlockSerial) unlockRefused(services().refusal);
  if (m_isOver) return;
  if (std::exchange(m_wasUnlocked, !services().locked) && services().locked && m_settings.unlock)
    return unlockRefused(services().isListenOnly ? Refusal::ListenOnly : Refusal::Locked);
  saySent();
  const bool has = m_settings.unlock && hasAddress();
  if (m_isOver) return;
  if (!m_isReady && isUp && (has || !m_wantsAddress)) {
    m_isReady = true;
    onReady();
  }
  if (m_isReady && !m_isOver) onTick();
  if (!m_isOver && !m_output.flush()) finish(kNotWhole);
}

}  // namespace deckpipe::ctl
