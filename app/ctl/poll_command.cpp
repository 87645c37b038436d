// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl poll: asks devices what they can be asked without changing anything.
#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <limits>

#include "command.h"
#include "control/intent.h"
#include "device_finder.h"
#include "request_words.h"
#include "requester.h"

namespace deckpipe::ctl {
namespace {

// "fault,firmware,…"
std::string pollWords() {
  std::string words;
  kPolls.forEach(
      [&](Request request) { words.append(words.empty() ? "" : ",").append(requestWord(request)); });
  return words;
}

std::optional<RequestSet> parseKinds(const QString& text) {
  RequestSet set;
  for (const QString& word : text.split(QLatin1Char(','))) {
    const auto found = std::ranges::find(kAllOf<Request>, word.toStdString(), requestWord);
    if (found == kAllOf<Request>.end() || isCommand(*found)) return {};
    set.add(*found);
  }
  return set;
}

struct Plan {
  DeviceName whom;
  std::optional<RequestSet> kinds;  // nothing: all that a device takes
  double every = 0;                 // s; 0: once
  unsigned rounds = 1;              // 0: until Ctrl+C
};

class Poll {
 public:
  Poll(LiveRun& run, const Plan& plan)
      : m_run(run), m_plan(plan), m_finder(run, plan.whom), m_requester(run, false) {
    run.onReady = [this] { m_finder.begin(); };
    run.onTick = [this] { tick(); };
    // Between two rounds, what is asked until Ctrl+C ends well by it; everything else is cut short.
    run.onStop = [this] {
      return m_requester.interrupted(m_plan.rounds == 0 && m_rounds > 0 ? status() : kNotWhole);
    };
    m_next.setSingleShot(true);
    QObject::connect(&m_next, &QTimer::timeout, [this] { beginRound(); });
  }

 private:
  ExitStatus status() const { return m_requester.allAnswered() ? kDone : kNotWhole; }

  void tick() {
    if (m_rounds == 0) {
      if (m_finder.hasFound()) beginRound();
      return;
    }
    if (!m_isAsking) return;
    m_requester.tick();
    if (m_requester.isOver()) endRound();
  }

  void beginRound() {
    ++m_rounds;
    m_isAsking = true;
    m_since.start();
    // Everyone there now; who was named stays, gone or not.
    if (m_devices.empty() || isAll()) m_devices = m_finder.devices();
    m_requester.begin(
        m_devices, m_plan.kinds.value_or(kPolls),
        isAll() || !m_plan.kinds ? Requester::NotTaken::IsLeftOut : Requester::NotTaken::IsAFailure);
  }

  void endRound() {
    m_isAsking = false;
    if (m_rounds == m_plan.rounds || m_requester.isStopping()) return m_run.finish(status());
    const auto left = static_cast<qint64>(m_plan.every * 1000) - m_since.elapsed();
    m_next.start(std::chrono::milliseconds(std::max<qint64>(left, 0)));
  }

  bool isAll() const { return !m_plan.whom.pin && !m_plan.whom.address; }

  LiveRun& m_run;
  Plan m_plan;
  DeviceFinder m_finder;
  Requester m_requester;
  std::vector<DeviceServices> m_devices;
  QTimer m_next;
  QElapsedTimer m_since;
  unsigned m_rounds = 0;  // begun
  bool m_isAsking = false;
};

}  // namespace

ExitStatus pollCommand(const QStringList& given) {
  Arguments arguments(
      given,
      R"(Asks devices for faults, versions and settings, which changes nothing in them. One line an answer:
pin, ask, and what 'deckpipectl decode' writes of the frame; one for what came to another end:
pin, address, ask, end (wrong_answer, no_answer, cancelled, link_lost, gone, answered_late,
not_on_bus, not_taken, refused with its reason, stopped with on_bus: true, false, or null if the
adapter cannot tell), tries.
Status 0 only if everything asked was answered in time. With --every, Ctrl+C ends it by the same
rule, and what is open then counts as not answered. It ends with 1 when the interface is lost: sending
is locked then, and is unlocked again only by --unlock.)");
  arguments.add(liveOptions());
  arguments.add(deviceOptions(true));
  arguments.add({{"kinds", "Some of " + pollWords() + "; by default all that the device takes.", "KINDS"},
                 {"every", "Ask again so often, from round to round; until Ctrl+C.", "SECONDS"},
                 {"count", "… or until so many rounds.", "N"}});
  if (const auto status = arguments.parse()) return *status;

  Plan plan;
  if (arguments.has("kinds")) {
    plan.kinds = parseKinds(arguments.text("kinds"));
    if (!plan.kinds)
      return arguments.bad(QStringLiteral("--kinds '%1' is not some of %2")
                               .arg(arguments.text("kinds"), QString::fromStdString(pollWords())));
  }
  if (arguments.has("every")) {
    plan.every = arguments.seconds("every");
    plan.rounds = 0;
    if (std::chrono::duration<double>(plan.every) < intent::Repeat::kShortestPeriod)
      arguments.bad(QStringLiteral("--every takes 0.5 s or more: devices have other work to do"));
  }
  if (arguments.has("count")) {
    plan.rounds = static_cast<unsigned>(arguments.number("count", 1, std::numeric_limits<unsigned>::max()));
    if (!arguments.has("every")) arguments.bad(QStringLiteral("--count wants --every"));
  }
  plan.whom = deviceName(arguments, true);
  const LiveSettings settings = liveSettings(arguments, true);
  if (arguments.areBad()) return kBadUsage;

  LiveRun run(settings, true);
  const Poll poll(run, plan);
  return run.run();
}

}  // namespace deckpipe::ctl
