// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl watch: what changes on a bus, as it happens.
#include <QTimer>

#include "arguments.h"
#include "changes.h"
#include "command.h"
#include "live_run.h"

namespace deckpipe::ctl {

ExitStatus watchCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral(
      "Writes a line for every change on a bus until Ctrl+C: event, t (seconds since 1970), channel, and by\n"
      "event: device_appeared, device_left, address_changed, address_lost (pin, address or node;\n"
      "device_type, type_name; previous), claimed, claim_lost (address, name), stale, fresh (message),\n"
      "link_up, link_down (reason), dropped (frames), still_waits (frames), own_address, locked, unlocked;\n"
      "value: pin and what 'deckpipectl decode' writes of a frame that differs from the last of its kind, "
      "or\n"
      "is an answer.\n"
      "An interface of Linux that goes down is waited for. Another adapter that is gone ends it with status\n"
      "1. Listens only, unless --unlock has it claim an address and ask for NAMEs at first; a link that "
      "went\n"
      "down is locked, and stays so."));
  const LiveOptions live(parser);
  const QCommandLineOption seconds(QStringLiteral("seconds"), QStringLiteral("End after so long."),
                                   QStringLiteral("N"));
  parser.addOption(seconds);
  if (const auto status = parse(parser, arguments)) return *status;
  if (!parser.positionalArguments().isEmpty()) return badUsage(QStringLiteral("watch: takes options only"));
  const auto length = parseSeconds(parser.value(seconds));
  if (!length && parser.isSet(seconds))
    return badUsage(QStringLiteral("watch: --seconds wants a number above 0"));
  const auto settings = live.read(QStringLiteral("watch"), false);
  if (!settings) return kBadUsage;

  LiveRun run(*settings, false);
  const Changes changes(run.follower(), run.channel(), settings->link.interfaceName.toStdString(),
                        run.output().text());
  run.outlivesLink = true;
  run.onStop = [] { return kDone; };
  run.onReady = [&] {
    if (length)
      QTimer::singleShot(std::chrono::milliseconds(static_cast<int>(*length * 1000)), &run,
                         [&] { run.finish(kDone); });
  };
  return run.run();
}

}  // namespace deckpipe::ctl
