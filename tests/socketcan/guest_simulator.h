// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests inside the guest share: other programs on the bus, interfaces set up and down, the kernel's
// own counters, candump as the independent witness. Results for people go to the folder that the host reads
// back.
#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QStringList>
#include <QTest>

#include "log/candump.h"
#include "session/live_bus.h"
#include "session/session.h"

namespace deckpipe::guest {

inline constexpr int kPatience = 90'000;  // ms; only ever used up by a failure. The guest is slow

inline QString fileInResults(const QString& name) {
  return qEnvironmentVariable("DECKPIPE_OUT", QStringLiteral(".")) + QLatin1Char('/') + name;
}
inline QString programOfBuild(const QString& name) {
  return qEnvironmentVariable("DECKPIPE_BUILD", QStringLiteral(".")) + QStringLiteral("/bin/") + name;
}
inline QString readFile(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}
inline QStringList linesOf(const QString& path) {
  return readFile(path).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

// A whole shell command; its exit status.
inline int shell(const QString& command) {
  return QProcess::execute(QStringLiteral("sh"), {QStringLiteral("-c"), command});
}
inline bool ip(const QString& arguments) {
  return QProcess::execute(QStringLiteral("ip"),
                           QStringList{QStringLiteral("link")} + arguments.split(QLatin1Char(' '))) == 0;
}
// Down and up in the program itself, where a new process would take too long.
bool setInterfaceUp(const char* name, bool up);
inline std::uint64_t counterOf(const QString& name, const QString& counter) {
  return readFile(QStringLiteral("/sys/class/net/%1/statistics/%2").arg(name, counter))
      .trimmed()
      .toULongLong();
}

// Another program, for as long as this lives.
class Program {
 public:
  // Output, if it is wanted, goes to a file in the results.
  explicit Program(const QString& command, const QString& output = {});
  ~Program();
  bool waitForEnd();

 private:
  QProcess m_process;
};

// candump -L on one interface into a file of the results; ready when the
// constructor returns, if isRunning().
class Witness {
 public:
  // `pokeFrom`: where a frame is sent from to find out that it listens.
  Witness(const QString& interfaceName, const QString& pokeFrom);
  bool isRunning() const { return m_isRunning; }
  // What it heard, once it has heard the identifier of markTheEnd().
  QStringList lines();
  static constexpr const char* kFirst = "7FE";
  static constexpr const char* kLast = "7FF";

 private:
  QString m_file, m_pokeFrom;
  Program m_candump;
  bool m_isRunning = false;
};

// A session on an interface, as the console has it.
struct Console {
  explicit Console(const QString& interfaceName, int bitRate = 250'000, const ClaimSettings& claim = {}) {
    session.setClaim(claim);
    session.openLink({QStringLiteral("socketcan"), interfaceName, bitRate, {}});
  }
  template <typename Condition>
  bool waitUntil(Condition condition) {
    return QTest::qWaitFor(condition, kPatience);
  }
  bool waitFor(SourceStatus::Progress progress) {
    return waitUntil([&] { return session.snapshot().source.progress == progress; });
  }
  const LogDocument& document() const { return *session.snapshot().view.document; }
  const ChannelState& channel() const { return session.snapshot().view.state->channel(Channel{0}); }
  // All of one kind.
  template <typename Kind>
  std::vector<Note> notes() const {
    std::vector<Note> out = document().notes.all();
    std::erase_if(out, [](const Note& note) { return !std::holds_alternative<Kind>(note.value); });
    return out;
  }
  bool hasHeard(std::uint32_t id) const;
  // As candump -L would have written it, and into a file of the results.
  QStringList lines(const QString& saveAs) const;
  Session session;
};

}  // namespace deckpipe::guest
