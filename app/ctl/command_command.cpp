// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl command: what changes something in a device. Named, confirmed by --yes, sent once.
#include <algorithm>
#include <cstdio>

#include "arguments.h"
#include "command.h"
#include "device_finder.h"
#include "requester.h"

namespace deckpipe::ctl {
namespace {

struct Word {
  const char* word;
  const char* deed;
};
constexpr KeyTable<kCommands, Word> kWords{{{Request::ZeroAxes, {"zero-axes", "zero the axes of"}},
                                            {Request::Reset, {"reset", "reset"}},
                                            {Request::SetupMode, {"setup-mode", "put into setup mode"}}}};

}  // namespace

ExitStatus commandCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral(
      "Sends one command to one device, once, and waits for its acknowledgement; for a reset, up to 10 s\n"
      "for its announcing itself anew. Without --yes it names the device and does nothing (status 2). One\n"
      "line: pin, address, ask (zero_axes, reset, setup_mode), end (answered, of a reset restarted,\n"
      "no_answer, …; not_on_bus_yet: it may still go out; stopped by Ctrl+C, with on_bus: true, false, or\n"
      "null if the adapter cannot tell), tries, latency_ms. Status 0 only if it was acknowledged or seen."));
  parser.addPositionalArgument(QStringLiteral("COMMAND"), QStringLiteral("zero-axes, reset or setup-mode."));
  const LiveOptions live(parser);
  const DeviceOptions device(parser, false);
  const QCommandLineOption yes(QStringLiteral("yes"), QStringLiteral("Yes, this device."));
  parser.addOption(yes);
  if (const auto status = parse(parser, arguments)) return *status;
  const auto request = std::ranges::find_if(kCommands, [&](Request known) {
    return parser.positionalArguments() == QStringList(QLatin1String(kWords.find(known)->word));
  });
  if (request == kCommands.end())
    return badUsage(QStringLiteral("command: one of zero-axes, reset and setup-mode is wanted"));
  const auto whom = device.read(QStringLiteral("command"));
  if (!whom) return kBadUsage;
  const auto settings = live.read(QStringLiteral("command"), true);
  if (!settings) return kBadUsage;

  LiveRun run(*settings, true);
  DeviceFinder finder(run, *whom);
  Requester requester(run, true);
  bool isAsking = false;
  run.onReady = [&] { finder.begin(); };
  run.onStop = [&] { return requester.interrupted(kNotWhole); };
  run.onTick = [&] {
    if (isAsking) {
      requester.tick();
    } else if (finder.hasFound()) {
      const std::vector<DeviceServices> found = finder.devices();
      if (!parser.isSet(yes)) {
        run.say(QStringLiteral("this would %1 %2; add --yes to do it")
                    .arg(QLatin1String(kWords.find(*request)->deed), deviceText(found.front())));
        return run.finish(kBadUsage);
      }
      isAsking = true;
      requester.begin(found, RequestSet(*request), Requester::NotTaken::IsAFailure);
    }
    if (isAsking && requester.isOver()) run.finish(requester.allAnswered() ? kDone : kNotWhole);
  };
  return run.run();
}

}  // namespace deckpipe::ctl
