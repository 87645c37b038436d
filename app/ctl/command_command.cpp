// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl command: what changes something in a device. Named, confirmed by --yes, sent once.
#include <algorithm>
#include <string>

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
std::string commandWords() {
  std::string words;
  for (const Request request : kCommands)
    words.append(words.empty() ? "" : ", ").append(requestWord(request));
  return words;
}
std::string typed(std::string words) {
  std::ranges::replace(words, '_', '-');
  return words;
}

}  // namespace

ExitStatus commandCommand(const QStringList& given) {
  Arguments arguments(
      given,
      R"(Sends one command to one device, once, and waits for its acknowledgement; for a reset,
up to 10 s for its announcing itself anew. Without --yes it names the device and does
nothing (status 2). One line: pin, address, ask ()" +
          commandWords() + R"(),
end (answered, of a reset restarted, no_answer, …; not_on_bus_yet: it may still go
out; stopped by Ctrl+C, with on_bus: true, false, or null if the adapter cannot
tell), tries, latency_ms. Status 0 only if it was acknowledged or seen.)");
  arguments.addArgument("COMMAND", "One of " + typed(commandWords()) + '.');
  arguments.add(liveOptions());
  arguments.add(deviceOptions(false));
  arguments.add({{"yes", "Yes, this device."}});
  if (const auto status = arguments.parse()) return *status;
  const auto request = std::ranges::find_if(kCommands, [&](Request known) {
    return arguments.argument().toStdString() == typed(std::string(requestWord(known)));
  });
  if (request == kCommands.end())
    return arguments.bad(
        QStringLiteral("one of %1 is wanted").arg(QString::fromStdString(typed(commandWords()))));
  const DeviceName whom = deviceName(arguments, false);
  const LiveSettings settings = liveSettings(arguments, true);
  if (arguments.areBad()) return kBadUsage;

  LiveRun run(settings, true);
  DeviceFinder finder(run, whom);
  Requester requester(run, true);
  bool isAsking = false;
  run.onReady = [&] { finder.begin(); };
  run.onStop = [&] { return requester.interrupted(kNotWhole); };
  run.onTick = [&] {
    if (isAsking) {
      requester.tick();
    } else if (finder.hasFound()) {
      const std::vector<DeviceServices> found = finder.devices();
      if (!arguments.has("yes")) {
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
