// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl watch: what changes on a bus, as it happens.
#include "changes.h"
#include "command.h"
#include "live_run.h"

namespace deckpipe::ctl {

ExitStatus watchCommand(const QStringList& given) {
  Arguments arguments(
      given,
      R"(Writes a line for every change on a bus until Ctrl+C: event, t (seconds since 1970), channel, and by
event: device_appeared, device_left, restarted, address_changed, address_lost (pin, address or node;
device_type, type_name; previous), pin_former (former_pin: said before the link was down, and not
since), claimed, claim_lost (address, name), stale, fresh (message),
joystick_began, joystick_ended (since), joystick_timed_out, joystick_back, joystick_gap (ms),
joystick_outranked (axis, by), joystick_outranked_over (axis), malformed, malformed_over: of a source
of joystick messages (address), as 'deckpipectl events' has them, folded: changes left out before it,
link_up, link_down (reason, words), dropped (frames), still_waits (frames), own_address, locked, unlocked;
value: pin and what 'deckpipectl decode' writes of a frame that differs from the last of its kind, or
is an answer.
An interface of Linux that goes down is waited for. Another adapter that is gone ends it with status
1. Listens only, unless --unlock has it claim an address and ask for NAMEs at first; a link that went
down is locked, and stays so.)");
  arguments.add(liveOptions());
  arguments.add({{"seconds", "End after so long.", "N"}});
  if (const auto status = arguments.parse()) return *status;
  const double length = arguments.has("seconds") ? arguments.seconds("seconds") : 0;
  const LiveSettings settings = liveSettings(arguments, false);
  if (arguments.areBad()) return kBadUsage;

  LiveRun run(settings, false);
  const Changes changes(run.follower(), run.channel(), settings.link.interfaceName.toStdString(),
                        run.output().text());
  run.outlivesLink = true;
  run.onStop = [] { return kDone; };
  run.onReady = [&] {
    if (length > 0) run.after(length, [&] { run.finish(kDone); });
  };
  return run.run();
}

}  // namespace deckpipe::ctl
