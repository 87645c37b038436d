// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl command: what changes something in a device. Named, confirmed by --yes, sent once.
#include <algorithm>
#include <cstdio>

#include "arguments.h"
#include "command.h"
#include "device_finder.h"
#include "request_words.h"
#include "requester.h"

namespace deckpipe::ctl {
namespace {

constexpr KeyTable<kCommands, const char*> kDeeds{{{Request::ZeroAxes, "zero the axes of"},
                                                   {Request::Reset, "reset"},
                                                   {Request::SetupMode, "put into setup mode"}}};

// "zero_axes, reset, …": as the output says them. They are typed with '-'.
QString commandWords() {
  QStringList words;
  for (const Request request : kCommands) words << requestWordText(request);
  return words.join(QStringLiteral(", "));
}
QString typed(QString words) { return words.replace(QLatin1Char('_'), QLatin1Char('-')); }

}  // namespace

ExitStatus commandCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QStringLiteral(
          "Sends one command to one device, once, and waits for its acknowledgement; for a reset,\n"
          "up to 10 s for its announcing itself anew. Without --yes it names the device and does\n"
          "nothing (status 2). One line: pin, address, ask (%1),\n"
          "end (answered, of a reset restarted, no_answer, …; not_on_bus_yet: it may still go\n"
          "out; stopped by Ctrl+C, with on_bus: true, false, or null if the adapter cannot\n"
          "tell), tries, latency_ms. Status 0 only if it was acknowledged or seen.")
          .arg(commandWords()));
  parser.addPositionalArgument(QStringLiteral("COMMAND"),
                               QStringLiteral("One of %1.").arg(typed(commandWords())));
  const LiveOptions live(parser);
  const DeviceOptions device(parser, false);
  const QCommandLineOption yes(QStringLiteral("yes"), QStringLiteral("Yes, this device."));
  parser.addOption(yes);
  if (const auto status = parse(parser, arguments)) return *status;
  const auto request = std::ranges::find_if(kCommands, [&](Request known) {
    return parser.positionalArguments() == QStringList(typed(requestWordText(known)));
  });
  if (request == kCommands.end())
    return badUsage(QStringLiteral("command: one of %1 is wanted").arg(typed(commandWords())));
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
                    .arg(QLatin1String(*kDeeds.find(*request)), deviceText(found.front())));
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
