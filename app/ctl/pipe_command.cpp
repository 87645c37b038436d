// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl pipe: standard input and output are a device's data pipe.
#include <QFile>
#include <cstdio>

#include "command.h"
#include "pipe_talk.h"

namespace deckpipe::ctl {
namespace {

ExitStatus cannotRead(const QFile& file) {
  std::fprintf(stderr, "deckpipectl: %s: %s\n", qPrintable(file.fileName()), qPrintable(file.errorString()));
  return kCannotRead;
}

}  // namespace

ExitStatus pipeCommand(const QStringList& given) {
  Arguments arguments(
      given,
      R"(Sends standard input, or a file, to a device over its data pipe, and writes what the device says to
standard output, both as bytes. The device's acknowledgements pace it: 7 characters at most at a time.
The maker calls the data pipe not available for integrator use and not fit for control: know your
device. Exit status 0 only if everything was acknowledged.)");
  arguments.add(liveOptions());
  arguments.add(deviceOptions(false));
  arguments.add({
      {"file", "Send this file as it is, instead of standard input; progress\nis on standard error.", "FILE"},
      {"before", "Send this line first, and the file once it is acknowledged.", "TEXT"},
      {"line-end",
       "What a line end (LF or CR LF) of standard input becomes, and what ends the line of --before: "
       "cr (default), lf, crlf or none.",
       "END", "cr"},
      {"idle", "End when all is sent and the device has said nothing for so long; 1 by default.", "SECONDS",
       "1"},
      {"on-missing-ack",
       "stop (default); skip the packet; or resend it, which may deliver it twice. After " +
           std::to_string(kMaxMissingAcks) + " in a row it stops anyway.",
       "WHAT", "stop"},
  });
  if (const auto status = arguments.parse()) return *status;

  PipePlan plan;
  constexpr const char* kLineEnds[] = {"\r", "\n", "\r\n", ""};
  const std::size_t lineEnd = arguments.oneOf("line-end", {"cr", "lf", "crlf", "none"});
  plan.idle = arguments.seconds("idle");
  plan.missingAck =
      static_cast<PipePlan::MissingAck>(arguments.oneOf("on-missing-ack", {"stop", "skip", "resend"}));
  plan.whom = deviceName(arguments, false);
  const LiveSettings settings = liveSettings(arguments, true);
  if (arguments.areBad()) return kBadUsage;
  plan.lineEnd = kLineEnds[lineEnd];
  if (arguments.has("before")) plan.before = arguments.text("before").toStdString() + plan.lineEnd;
  if (arguments.has("file")) {
    QFile source(arguments.text("file"));
    if (!source.open(QIODevice::ReadOnly)) return cannotRead(source);
    plan.fileName = arguments.text("file").toStdString();
    plan.content = std::make_shared<const std::string>(source.readAll().toStdString());
    if (source.error() != QFileDevice::NoError) return cannotRead(source);
    if (plan.content->empty()) {
      std::fprintf(stderr, "deckpipectl: %s: it is empty\n", qPrintable(source.fileName()));
      return kNothingRead;
    }
  }

  LiveRun run(settings, true);
  const PipeTalk talk(run, std::move(plan));
  return run.run();
}

}  // namespace deckpipe::ctl
