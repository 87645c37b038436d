// SPDX-License-Identifier: GPL-3.0-or-later
#include "guest_simulator.h"

#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

namespace deckpipe::guest {

bool setInterfaceUp(const char* name, bool up) {
  const int fd = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  ifreq request{};
  std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
  bool done = fd >= 0 && ::ioctl(fd, SIOCGIFFLAGS, &request) == 0;
  const int flags = up ? request.ifr_flags | IFF_UP : request.ifr_flags & ~IFF_UP;
  request.ifr_flags = static_cast<short>(flags);
  done = done && ::ioctl(fd, SIOCSIFFLAGS, &request) == 0;
  if (fd >= 0) ::close(fd);
  return done;
}

Program::Program(const QString& command, const QString& output) {
  if (!output.isEmpty()) m_process.setStandardOutputFile(fileInResults(output));
  m_process.setProcessChannelMode(output.isEmpty() ? QProcess::ForwardedChannels
                                                   : QProcess::ForwardedErrorChannel);
  m_process.startCommand(command);
  m_process.waitForStarted();
}

Program::~Program() {
  m_process.terminate();
  if (!m_process.waitForFinished(kPatience)) m_process.kill();
}

// The event loop goes on meanwhile, and with it whatever listens in this thread.
bool Program::waitForEnd() {
  return QTest::qWaitFor([&] { return m_process.state() == QProcess::NotRunning; }, kPatience) &&
         m_process.exitStatus() == QProcess::NormalExit && m_process.exitCode() == 0;
}

Witness::Witness(const QString& interfaceName, const QString& pokeFrom)
    : m_file(QStringLiteral("candump-%1.log").arg(interfaceName)),
      m_pokeFrom(pokeFrom),
      // Every identifier, and error frames too, which it leaves out by itself.
      m_candump(QStringLiteral("candump -L %1,0:0,#FFFFFFFF").arg(interfaceName), m_file) {
  for (int i = 0; i < 200 && !m_isRunning; ++i) {
    shell(QStringLiteral("cansend %1 %2#").arg(m_pokeFrom, QLatin1String(kFirst)));
    QTest::qWait(50);
    m_isRunning = !linesOf(fileInResults(m_file)).isEmpty();
  }
}

QStringList Witness::lines() {
  shell(QStringLiteral("cansend %1 %2#").arg(m_pokeFrom, QLatin1String(kLast)));
  QStringList lines;
  const QString last = QStringLiteral(" %1#").arg(QLatin1String(kLast));
  const bool isWhole = QTest::qWaitFor(
      [&] {
        lines = linesOf(fileInResults(m_file));
        return !lines.isEmpty() && lines.last().endsWith(last);
      },
      kPatience);
  EXPECT_TRUE(isWhole) << "candump did not hear the last frame";
  return lines;
}

bool Console::hasHeard(std::uint32_t id) const {
  const FrameStore& frames = document().frames;
  for (std::uint64_t i = frames.count(); i-- > 0;) {
    if (frames[i].id == id) return true;
  }
  return false;
}

QStringList Console::lines(const QString& saveAs) const {
  const FrameStore& frames = document().frames;
  std::string text;
  for (std::uint64_t i = 0; i < frames.count(); ++i) {
    writeCandump(frames[i], frames.channelName(frames[i].channel), text);
  }
  QFile file(fileInResults(saveAs));
  if (file.open(QIODevice::WriteOnly)) file.write(text.data(), static_cast<qint64>(text.size()));
  return QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
}

}  // namespace deckpipe::guest
