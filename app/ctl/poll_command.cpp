// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl poll: asks devices what they can be asked without changing anything.
#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>

#include "arguments.h"
#include "command.h"
#include "control/intent.h"
#include "device_finder.h"
#include "request_words.h"
#include "requester.h"

namespace deckpipe::ctl {
namespace {

// "fault,firmware,…"
QString pollWords() {
  QStringList words;
  kPolls.forEach([&](Request request) { words << requestWordText(request); });
  return words.join(QLatin1Char(','));
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

ExitStatus pollCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral(
      "Asks devices for faults, versions and settings, which changes nothing in them. One line an answer:\n"
      "pin, ask, and what 'deckpipectl decode' writes of the frame; one for what came to another end:\n"
      "pin, address, ask, end (wrong_answer, no_answer, cancelled, link_lost, gone, answered_late,\n"
      "not_on_bus, not_taken, refused with its reason, stopped with on_bus: true, false, or null if the\n"
      "adapter cannot tell), tries.\n"
      "Status 0 only if everything asked was answered in time. With --every, Ctrl+C ends it by the same\n"
      "rule, and what is open then counts as not answered. It ends with 1 when the interface is lost: "
      "sending\n"
      "is locked then, and is unlocked again only by --unlock."));
  const LiveOptions live(parser);
  const DeviceOptions device(parser, true);
  const QCommandLineOption kinds(
      QStringLiteral("kinds"),
      QStringLiteral("Some of %1; by default all that the device takes.").arg(pollWords()),
      QStringLiteral("KINDS"));
  const QCommandLineOption every(QStringLiteral("every"),
                                 QStringLiteral("Ask again so often, from round to round; until Ctrl+C."),
                                 QStringLiteral("SECONDS"));
  const QCommandLineOption count(QStringLiteral("count"), QStringLiteral("… or until so many rounds."),
                                 QStringLiteral("N"));
  parser.addOptions({kinds, every, count});
  if (const auto status = parse(parser, arguments)) return *status;
  if (!parser.positionalArguments().isEmpty()) return badUsage(QStringLiteral("poll: takes options only"));

  Plan plan;
  if (parser.isSet(kinds)) {
    plan.kinds = parseKinds(parser.value(kinds));
    if (!plan.kinds)
      return badUsage(
          QStringLiteral("poll: --kinds '%1' is not some of %2").arg(parser.value(kinds), pollWords()));
  }
  if (parser.isSet(every)) {
    const auto seconds = parseSeconds(parser.value(every));
    if (!seconds) return badUsage(QStringLiteral("poll: --every wants a number of seconds above 0"));
    if (std::chrono::duration<double>(*seconds) < intent::Repeat::kShortestPeriod)
      return badUsage(QStringLiteral("poll: --every takes 0.5 s or more: devices have other work to do"));
    plan.every = *seconds;
    plan.rounds = 0;
  }
  if (parser.isSet(count)) {
    bool ok = false;
    plan.rounds = parser.value(count).toUInt(&ok);
    if (!ok || plan.rounds == 0 || !parser.isSet(every))
      return badUsage(QStringLiteral("poll: --count wants a number above 0, and --every"));
  }
  const auto whom = device.read(QStringLiteral("poll"));
  if (!whom) return kBadUsage;
  plan.whom = *whom;
  const auto settings = live.read(QStringLiteral("poll"), true);
  if (!settings) return kBadUsage;

  LiveRun run(*settings, true);
  const Poll poll(run, plan);
  return run.run();
}

}  // namespace deckpipe::ctl
