// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl nodes: who is on a bus.
#include <QTimer>

#include "arguments.h"
#include "command.h"
#include "live_run.h"
#include "node_lines.h"

namespace deckpipe::ctl {

ExitStatus nodesCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QStringLiteral(
          "Listens for a while, then writes a line for everyone on the bus. With --unlock it claims an\n"
          "address and asks everyone for their NAME; without, whoever keeps silent is not found.\n"
          "Keys: channel, address or node, what (own, akron, drive, joystick, foreign, canopen_node, "
          "unknown,\n"
          "or presumed: it speaks as Akron's do, and nothing else is known), sends_joystick, pin,\n"
          "device_type, type_name, claim, name and its parts, part_number, frames and malformed (of who "
          "holds\n"
          "the address, since then), last_heard (seconds since 1970), health (fine, or the worst of what "
          "keeps\n"
          "it from being fine), causes (all of that, the worst first). What is beyond %1 devices or %2 "
          "channels\n"
          "is not followed: that is said on standard error. An interface that is lost ends it with 1, after\n"
          "the lines of who was heard so far.")
          .arg(kMaxDevices)
          .arg(kMaxChannels));
  const LiveOptions live(parser);
  const QCommandLineOption seconds(QStringLiteral("seconds"), QStringLiteral("Listen so long; 3 by default."),
                                   QStringLiteral("N"), QStringLiteral("3"));
  const QCommandLineOption format(QStringLiteral("format"), QStringLiteral("jsonl (default) or text."),
                                  QStringLiteral("FORMAT"), QStringLiteral("jsonl"));
  parser.addOptions({seconds, format});
  if (const auto status = parse(parser, arguments)) return *status;
  if (!parser.positionalArguments().isEmpty()) return badUsage(QStringLiteral("nodes: takes options only"));
  const auto length = parseSeconds(parser.value(seconds));
  if (!length) return badUsage(QStringLiteral("nodes: --seconds wants a number above 0"));
  const bool asText = parser.value(format) == QLatin1String("text");
  if (!asText && parser.value(format) != QLatin1String("jsonl"))
    return badUsage(QStringLiteral("nodes: --format is jsonl or text"));
  const auto settings = live.read(QStringLiteral("nodes"), false);
  if (!settings) return kBadUsage;

  LiveRun run(*settings, false);
  NodeCounts counts;
  run.follower().onFrame = [&](const Frame& frame, const Classified& what) {
    const State& state = run.follower().state();
    counts.count(frame, state.cursor().time, what, state.channel(run.channel()).book);
  };
  bool isTold = false;
  const auto tellFollowed = [&] {
    isTold = true;
    run.output().text() +=
        nodeLines(run.follower().state(), counts, run.channel(), settings->link.interfaceName.toStdString(),
                  asText ? NodeFormat::Text : NodeFormat::JsonLines);
    for (const std::string& line : untrackedLines(run.follower().state()))
      run.say(QString::fromStdString(line));
  };
  const auto tell = [&] {
    run.follower().follow(run.snapshot().view);
    tellFollowed();
    return kDone;
  };
  run.onStop = tell;
  // Again every second: an answer may get lost on a busy bus.
  QTimer request;
  QObject::connect(&request, &QTimer::timeout, [&] { run.session().intend(intent::RequestNames{}); });
  run.onReady = [&] {
    if (settings->unlock) request.start(std::chrono::seconds(1));
    QTimer::singleShot(std::chrono::milliseconds(static_cast<int>(*length * 1000)), &run,
                       [&] { run.finish(tell()); });
  };
  const ExitStatus status = run.run();
  // The interface was lost: the lines of whoever was heard before still go out.
  if (!isTold) {
    tellFollowed();
    run.output().flush();
  }
  return status;
}

}  // namespace deckpipe::ctl
