// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl info: what is in a log.
#include "arguments.h"
#include "command.h"
#include "info_report.h"
#include "log_input.h"
#include "output.h"

namespace deckpipe::ctl {

ExitStatus infoCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral(
      "Says what is in a log: frames, span, frames by identifier, lines that cannot be read."));
  parser.addPositionalArgument(QStringLiteral("FILE"), logArgumentHelp());
  const QCommandLineOption devices(QStringLiteral("devices"),
                                   QStringLiteral("Add what is known of every device at the end."));
  const QCommandLineOption json(QStringLiteral("json"), QStringLiteral("One JSON object instead of text."));
  const QCommandLineOption deltas = deltasOption();
  parser.addOptions({devices, json, deltas});
  if (const auto status = parse(parser, arguments)) return *status;
  if (parser.positionalArguments().size() != 1) return badUsage(QStringLiteral("info: one FILE is wanted"));

  LogInput input(parser.positionalArguments().first().toStdString(), parser.isSet(deltas));
  InfoReport report(input.frames, input.notes, parser.isSet(devices));
  const ExitStatus status = input.read([&] {
    report.countNew();
    return true;
  });
  if (status == kCannotRead || status == kNothingRead) return status;
  report.takeNotes(input.hasDeltas() ? InfoReport::Times::Deltas : InfoReport::Times::Known);
  Output output;
  const SkippedPlaces skipped = input.skipped.content();
  output.text() =
      parser.isSet(json) ? report.json(input.name(), skipped) : report.text(input.name(), skipped);
  return output.flush() ? status : kNotWhole;
}

}  // namespace deckpipe::ctl
