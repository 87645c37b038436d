// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl info: what is in a log.
#include "command.h"
#include "info_report.h"
#include "log_input.h"
#include "output.h"

namespace deckpipe::ctl {

ExitStatus infoCommand(const QStringList& given) {
  Arguments arguments(
      given, "Says what is in a log: frames, span, frames by identifier, lines that cannot be read.");
  arguments.addArgument("FILE", logArgumentHelp());
  arguments.add({{"devices", "Add what is known of every device at the end."},
                 {"json", "One JSON object instead of text."},
                 deltasOption()});
  if (const auto status = arguments.parse()) return *status;

  LogInput input(arguments);
  InfoReport report(input.frames, input.notes, arguments.has("devices"));
  const ExitStatus status = input.read([&] {
    report.countNew();
    return true;
  });
  if (status == kCannotRead || status == kNothingRead) return status;
  report.takeNotes(input.hasDeltas() ? InfoReport::Times::Deltas : InfoReport::Times::Known);
  Output output;
  const SkippedPlaces skipped = input.skipped.content();
  output.text() = arguments.has("json") ? report.json(input.name(), skipped, input.lastLine)
                                        : report.text(input.name(), skipped);
  return output.flush() ? status : kNotWhole;
}

}  // namespace deckpipe::ctl
