// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl nodes: who is on a bus.
#include <QTimer>

#include "command.h"
#include "live_run.h"
#include "node_lines.h"

namespace deckpipe::ctl {

ExitStatus nodesCommand(const QStringList& given) {
  Arguments arguments(
      given, R"(Listens for a while, then writes a line for everyone on the bus. With --unlock it claims an
address and asks everyone for their NAME; without, whoever keeps silent is not found.
Keys: channel, address or node, what (own, akron, drive, joystick, foreign, canopen_node, unknown,
or presumed: it speaks as Akron's do, and nothing else is known), sends_joystick, pin,
device_type, type_name, former_pin and former_name (of before the link was down, if nobody has said
since who is there), claim, name and its parts, part_number, frames and malformed (of who holds the
address, since then), last_heard (seconds since 1970), health (fine, or the worst of what keeps
it from being fine), causes (all of that, the worst first). What is beyond )" +
                 std::to_string(kMaxDevices) + " devices or " + std::to_string(kMaxChannels) +
                 R"( channels
is not followed: that is said on standard error. An interface that is lost ends it with 1, after
the lines of who was heard so far.)");
  arguments.add(liveOptions());
  arguments.add({{"seconds", "Listen so long; 3 by default.", "N", "3"},
                 {"format", "jsonl (default) or text.", "FORMAT", "jsonl"}});
  if (const auto status = arguments.parse()) return *status;
  const double length = arguments.seconds("seconds");
  const bool asText = arguments.oneOf("format", {"jsonl", "text"}) == 1;
  const LiveSettings settings = liveSettings(arguments, false);
  if (arguments.areBad()) return kBadUsage;

  LiveRun run(settings, false);
  NodeCounts counts;
  run.follower().onFrame = [&](const Frame& frame, const Classified& what) {
    const State& state = run.follower().state();
    counts.count(frame, state.cursor().time, what, state.channel(run.channel()).book);
  };
  bool isTold = false;
  const auto tellFollowed = [&] {
    isTold = true;
    run.output().text() +=
        nodeLines(run.follower().state(), counts, run.channel(), settings.link.interfaceName.toStdString(),
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
    if (settings.unlock) request.start(std::chrono::seconds(1));
    run.after(length, [&] { run.finish(tell()); });
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
