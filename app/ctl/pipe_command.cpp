// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl pipe: standard input and output are a device's data pipe.
#include <QFile>
#include <cstdio>

#include "arguments.h"
#include "command.h"
#include "pipe_talk.h"

namespace deckpipe::ctl {
namespace {

std::optional<std::string> lineEndOf(const QString& word) {
  if (word == QLatin1String("cr")) return "\r";
  if (word == QLatin1String("lf")) return "\n";
  if (word == QLatin1String("crlf")) return "\r\n";
  if (word == QLatin1String("none")) return "";
  return {};
}

std::optional<PipePlan::MissingAck> missingAckOf(const QString& word) {
  if (word == QLatin1String("stop")) return PipePlan::MissingAck::Stop;
  if (word == QLatin1String("skip")) return PipePlan::MissingAck::Skip;
  if (word == QLatin1String("resend")) return PipePlan::MissingAck::Resend;
  return {};
}

ExitStatus cannotRead(const QFile& file) {
  std::fprintf(stderr, "deckpipectl: %s: %s\n", qPrintable(file.fileName()), qPrintable(file.errorString()));
  return kCannotRead;
}

}  // namespace

ExitStatus pipeCommand(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral(
      "Sends standard input, or a file, to a device over its data pipe, and writes what the device says to\n"
      "standard output, both as bytes. The device's acknowledgements pace it: 7 characters at most at a "
      "time.\n"
      "The maker calls the data pipe not available for integrator use and not fit for control: know your\n"
      "device. Exit status 0 only if everything was acknowledged."));
  const LiveOptions live(parser);
  const DeviceOptions device(parser, false);
  const QCommandLineOption file(
      QStringLiteral("file"),
      QStringLiteral("Send this file as it is, instead of standard input; progress\n"
                     "is on standard error."),
      QStringLiteral("FILE"));
  const QCommandLineOption before(
      QStringLiteral("before"), QStringLiteral("Send this line first, and the file once it is acknowledged."),
      QStringLiteral("TEXT"));
  const QCommandLineOption lineEnd(
      QStringLiteral("line-end"),
      QStringLiteral(
          "What a line end (LF or CR LF) of standard input becomes, and what ends the line of --before: "
          "cr (default), lf, crlf or none."),
      QStringLiteral("END"), QStringLiteral("cr"));
  const QCommandLineOption idle(
      QStringLiteral("idle"),
      QStringLiteral("End when all is sent and the device has said nothing for so long; 1 by default."),
      QStringLiteral("SECONDS"), QStringLiteral("1"));
  const QCommandLineOption missing(
      QStringLiteral("on-missing-ack"),
      QStringLiteral("stop (default); skip the packet; or resend it, which may deliver it twice. After %1 in "
                     "a row it stops anyway.")
          .arg(kMaxMissingAcks),
      QStringLiteral("WHAT"), QStringLiteral("stop"));
  parser.addOptions({file, before, lineEnd, idle, missing});
  if (const auto status = parse(parser, arguments)) return *status;
  if (!parser.positionalArguments().isEmpty()) return badUsage(QStringLiteral("pipe: takes options only"));

  PipePlan plan;
  const auto end = lineEndOf(parser.value(lineEnd));
  if (!end) return badUsage(QStringLiteral("pipe: --line-end is cr, lf, crlf or none"));
  plan.lineEnd = *end;
  if (parser.isSet(before)) plan.before = parser.value(before).toStdString() + *end;
  const auto seconds = parseSeconds(parser.value(idle));
  if (!seconds) return badUsage(QStringLiteral("pipe: --idle wants a number of seconds above 0"));
  plan.idle = *seconds;
  const auto missingAck = missingAckOf(parser.value(missing));
  if (!missingAck) return badUsage(QStringLiteral("pipe: --on-missing-ack is stop, skip or resend"));
  plan.missingAck = *missingAck;
  const auto whom = device.read(QStringLiteral("pipe"));
  if (!whom) return kBadUsage;
  plan.whom = *whom;
  const auto settings = live.read(QStringLiteral("pipe"), true);
  if (!settings) return kBadUsage;
  if (parser.isSet(file)) {
    QFile source(parser.value(file));
    if (!source.open(QIODevice::ReadOnly)) return cannotRead(source);
    plan.fileName = parser.value(file).toStdString();
    plan.content = std::make_shared<const std::string>(source.readAll().toStdString());
    if (source.error() != QFileDevice::NoError) return cannotRead(source);
    if (plan.content->empty()) {
      std::fprintf(stderr, "deckpipectl: %s: it is empty\n", qPrintable(source.fileName()));
      return kNothingRead;
    }
  }

  LiveRun run(*settings, true);
  const PipeTalk talk(run, std::move(plan));
  return run.run();
}

}  // namespace deckpipe::ctl
