// SPDX-License-Identifier: GPL-3.0-or-later
// One subcommand's time on a live interface: it connects, with --unlock claims an address, and then calls the
// subcommand until that, Ctrl+C or a lost link ends it. What stands in the way is said on standard error.
//
// 1. A link that goes down, for however short a time, ends the run with status 1 and the reason.
// 2. Unless outlivesLink: then an interface of Linux is waited for, which comes back by itself. Other adapters
//    do not, so there the run ends all the same. The lost link locks sending.
// 3. Whoever wants an address and has none kAddressPatience after the link came up ends with status 1.
#pragma once

#include <QObject>
#include <functional>

#include "bus_follower.h"
#include "exit_status.h"
#include "live_options.h"
#include "output.h"
#include "session/session.h"

namespace deckpipe::ctl {

class LiveRun : public QObject {
 public:
  static constexpr std::chrono::seconds kAddressPatience{10};

  // `wantsAddress`: nothing can be done without one, so ready only then.
  LiveRun(const LiveSettings& settings, bool wantsAddress);

  // Asked while the link is up, until it says so: whether sending may be unlocked now. It may end the run.
  std::function<bool()> mayUnlock = [] { return true; };
  // Once, when the link is up and, if wanted, an address is ours.
  std::function<void()> onReady = [] {};
  // At most 30 times a second from then on, after the follower.
  std::function<void()> onTick = [] {};
  // Ctrl+C: how it ends, or nothing where it will soon end by itself.
  std::function<std::optional<ExitStatus>()> onStop;
  // Whether it waits for an interface that went down.
  bool outlivesLink = false;

  // Until finish(); the exit status.
  ExitStatus run();
  // What is in the output goes out first.
  void finish(ExitStatus status);

  Session& session() { return m_session; }
  const Snapshot& snapshot() const { return m_session.snapshot(); }
  const ServiceStatus& services() const { return *snapshot().services; }
  BusFollower& follower() { return m_follower; }
  Output& output() { return m_output; }
  Channel channel() const { return {0}; }
  Address ownAddress() const { return m_follower.state().channel(channel()).ownAddress; }
  // Calls it once the run has lasted so long.
  void after(double seconds, std::function<void()> call);
  // "deckpipectl: …" on standard error.
  void say(const QString& message) const;

 private:
  void changed();
  void stop();
  // Whether it is there; what went wrong is said and, where that is the end, ends it.
  bool isLinkUp();
  void linkWentDown(const QString& reason);
  void unlock();
  void unlockRefused(Refusal why);
  bool hasAddress();
  // What does not reach the bus, whenever that has become more.
  void saySent();

  LiveSettings m_settings;
  bool m_wantsAddress;
  Session m_session;
  BusFollower m_follower;
  Output m_output;
  bool m_isReady = false, m_isOver = false, m_askedToUnlock = false, m_saidClaim = false;
  bool m_saidCannotTell = false, m_isWaiting = false, m_wasUnlocked = false;
  unsigned m_linkDowns = 0;  // as seen last
  std::uint64_t m_unlockSerial = 0;
  std::uint64_t m_unconfirmed = 0, m_notTaken = 0;  // as said last
  ExitStatus m_status = kDone;
};

}  // namespace deckpipe::ctl
