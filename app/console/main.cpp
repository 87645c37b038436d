// SPDX-License-Identifier: GPL-3.0-or-later
// deckpipe: the console.
#include <QApplication>
#include <QLoggingCategory>
#include <QTimer>
#include <cstdio>

#include "kept_settings.h"
#include "language.h"
#include "main_window.h"
#include "options.h"
#include "session/recordings.h"
#include "session/stop_signals.h"

namespace {

// For pictures of the running program, and for people who report what they saw.
void grabLater(deckpipe::MainWindow& window, const deckpipe::Options& options) {
  QTimer::singleShot(static_cast<int>(options.grabAfter * 1000), &window,
                     [&window, file = options.grabFile, size = options.grabSize] {
                       if (window.size() != size)
                         std::fprintf(stderr, "deckpipe: the window is %dx%d, it cannot be smaller\n",
                                      window.width(), window.height());
                       const bool saved = window.grab().save(file, "PNG");
                       if (!saved)
                         std::fprintf(stderr, "deckpipe: %s: cannot be written\n", qPrintable(file));
                       QCoreApplication::exit(saved ? 0 : 1);
                     });
}

}  // namespace

int main(int argc, char** argv) {
  // Without it the C library looks at /etc/localtime anew for each local time, of which virtualcan takes one a frame.
  if (!qEnvironmentVariableIsSet("TZ")) qputenv("TZ", ":/etc/localtime");
  // Qt would take --plugin for an option of its own.
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments += QString::fromLocal8Bit(argv[i]);
  argc = 1;
  QCoreApplication::setOrganizationName(QStringLiteral("Deckpipe"));
  QCoreApplication::setApplicationName(QStringLiteral("deckpipe"));
  QCoreApplication::setApplicationVersion(QStringLiteral(DECKPIPE_VERSION));
  deckpipe::Options options;
  {
    // --help and --version need no display.
    QCoreApplication withoutDisplay(argc, argv);
    deckpipe::installLanguage(withoutDisplay);
    if (const auto status = deckpipe::parseOptions(arguments, options)) return *status;
  }
  deckpipe::MainWindow* asked = nullptr;  // to quit; Qt has threads as soon as there is an application
  deckpipe::onStopSignals([&asked] {
    if (asked != nullptr) asked->quit();
  });
  QApplication application(argc, argv);
  deckpipe::installLanguage(application);
  // Qt tells on standard error what its adapters do; what matters of it comes back as reasons.
  QLoggingCategory::setFilterRules(QStringLiteral("qt.canbus*=false"));

  deckpipe::Session session;
  session.setRecordingFolder(deckpipe::recordingsFolder());
  deckpipe::MainWindow window(session);
  if (options.grabFile.isEmpty()) {
    window.restoreLayout();
  } else {
    window.resize(options.grabSize);
  }
  window.setLook(deckpipe::themeOfKey(options.theme).value_or(window.theme()),
                 deckpipe::densityOfKey(options.density).value_or(window.density()));
  window.show();
  asked = &window;
  if (!options.logFile.isEmpty()) session.openLog(options.logFile);
  if (options.demo) session.openDemo();
  if (options.link) session.openLink(*options.link);
  if (!options.grabFile.isEmpty()) grabLater(window, options);
  return QApplication::exec();
}
