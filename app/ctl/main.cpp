// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipectl: the headless half of Deckpipe.
#include <fcntl.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QLoggingCategory>
#include <clocale>
#include <csignal>
#include <string>

#include "arguments.h"
#include "command.h"

namespace {

struct Command {
  const char* name;
  const char* summary;
  deckpipe::ctl::ExitStatus (*run)(const QStringList&);
};

constexpr Command kCommands[] = {
    {"decode", "decode every frame of a log, one line each", deckpipe::ctl::decodeCommand},
    {"info", "say what is in a log", deckpipe::ctl::infoCommand},
    {"events", "say what changed in a log, and when", deckpipe::ctl::eventsCommand},
    {"recordings", "list what the console recorded on this machine", deckpipe::ctl::recordingsCommand},
    {"simulate", "put the simulated truck on an interface, or write a log of it",
     deckpipe::ctl::simulateCommand},
    {"nodes", "say who is on a bus", deckpipe::ctl::nodesCommand},
    {"watch", "say what changes on a bus, as it happens", deckpipe::ctl::watchCommand},
    {"poll", "ask devices for faults, versions and settings", deckpipe::ctl::pollCommand},
    {"pipe", "talk to a device over its data pipe, send it a file", deckpipe::ctl::pipeCommand},
    {"command", "change something in a device, once", deckpipe::ctl::commandCommand},
    {"move", "move monitors for a few seconds", deckpipe::ctl::moveCommand},
};

std::string helpText() {
  std::string text =
      "Usage: deckpipectl COMMAND [ARGUMENTS]\n\nDiagnostics for fire monitors on CAN, without a "
      "window.\n\nCommands:\n";
  for (const Command& command : kCommands) {
    std::string name(command.name);
    name.resize(11, ' ');
    text += "  " + name + command.summary + "\n";
  }
  return text +
         "\nNothing is sent on an interface without --unlock; simulate and move want --moves-monitors.\n"
         "'deckpipectl COMMAND --help' tells the arguments of one.\n\n" +
         deckpipe::ctl::exitStatusHelp();
}

// A descriptor that was closed before the program began would be given to the next file that is opened, and
// what is written to standard output would go there. These take the place of closed ones, so that reading and
// writing them fails with the system's reason.
void occupyClosedStreams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    if (::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

}  // namespace

int main(int argc, char** argv) {
  occupyClosedStreams();
  // A reader of ours that has enough closes its pipe; that ends us, and is no failure to talk about.
  std::signal(SIGPIPE, SIG_DFL);
  QCoreApplication application(argc, argv);
  QCoreApplication::setApplicationName(QStringLiteral("deckpipectl"));
  QCoreApplication::setApplicationVersion(QStringLiteral(DECKPIPE_VERSION));
  // Numbers in machine-readable output never follow the locale.
  std::setlocale(LC_NUMERIC, "C");
  // Qt tells on standard error what its adapters do; what matters of it comes back as reasons.
  QLoggingCategory::setFilterRules(QStringLiteral("qt.canbus*=false"));
  QStringList arguments = QCoreApplication::arguments();
  const QString name = arguments.value(1);
  if (name == QLatin1String("--help") || name == QLatin1String("-h") || name == QLatin1String("help"))
    return deckpipe::ctl::print(helpText());
  if (name == QLatin1String("--version")) return deckpipe::ctl::printVersion(QStringLiteral("deckpipectl"));
  if (name.isEmpty()) return deckpipe::ctl::badUsage(QStringLiteral("a command is wanted"));
  for (const Command& command : kCommands) {
    if (name != QLatin1String(command.name)) continue;
    arguments.removeFirst();
    arguments[0] = QStringLiteral("deckpipectl ") + name;
    return command.run(arguments);
  }
  return deckpipe::ctl::badUsage(QStringLiteral("no command '%1'").arg(name));
}
