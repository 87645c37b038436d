// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands on a live interface, against the simulator on a virtual bus of this process.
#include <zlib.h>

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTimer>
#include <csignal>

#include "bus/j1939.h"
#include "live.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::kMonitor;
using test::kPatience;
using test::Live;
using test::Outcome;
using test::text;
using test::words;

TEST_F(Live, Rule20SimulateNeedsNoWordOnAVirtualBusAndEndsBySignals) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    QProcess process;
    start(process, "simulate --seed 7");
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return process.readAllStandardError().contains("the simulated truck is on"); }, kPatience));
    ::kill(static_cast<pid_t>(process.processId()), signal);
    EXPECT_EQ(end(process).status, 0) << signal;
  }
}

TEST_F(Live, NodesUnlockedNamesEveryoneAndOurselves) {
  const Outcome r = run("nodes --unlock --seconds 1.5 --identity 77");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  QMap<int, QJsonObject> at;
  for (const QJsonObject& node : r.objects()) at[node[QLatin1String("address")].toInt()] = node;
  const QJsonObject monitor = at[m_status.devices[0].address.value];
  EXPECT_EQ(text(monitor, "pin"), QLatin1String(kMonitor));
  EXPECT_EQ(text(monitor, "what"), QStringLiteral("akron"));
  EXPECT_EQ(text(monitor, "type_name"), QStringLiteral("6032 Universal II"));
  EXPECT_EQ(monitor[QLatin1String("manufacturer_code")].toInt(), 326);
  EXPECT_EQ(text(at[0xF9], "what"), QStringLiteral("own"));
  EXPECT_EQ(at[0xF9][QLatin1String("identity_number")].toInt(), 77);
}

// Devices at 91 and up, which say who they are and that they are disabled, again and again.
class NodesOf : public Live {
 protected:
  Outcome nodesBesides(unsigned devices, const char* command) {
    QTimer speak;
    QObject::connect(&speak, &QTimer::timeout, &speak, [this, devices] {
      for (unsigned i = 1; i <= devices; ++i) {
        Frame frame = test::frame("18EFFF90", "FF83150206021A00");
        frame.id += i;
        frame.data[7] = static_cast<std::uint8_t>(0x20 + i);
        m_witnessLink->write(frame);
        Frame disabled = test::frame("18EFFF90", "834000");
        disabled.id += i;
        m_witnessLink->write(disabled);
      }
    });
    speak.start(200);
    return run(command);
  }
};

TEST_F(NodesOf, ADeviceWithAllThatKeepsItFromBeingFine) {
  const Outcome r = nodesBesides(1, "nodes --seconds 1");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  const QList<QJsonObject> all = r.objects();
  const auto device = std::ranges::find_if(
      all, [](const QJsonObject& node) { return node[QLatin1String("address")].toInt() == 0x91; });
  ASSERT_NE(device, all.end()) << r.out.constData();
  EXPECT_EQ(text(*device, "health"), QStringLiteral("disabled"));
  EXPECT_EQ((*device)[QLatin1String("causes")].toArray().toVariantList(),
            QVariantList({QStringLiteral("disabled"), QStringLiteral("faults_never_asked"),
                          QStringLiteral("status_never_heard")}));
  EXPECT_FALSE(r.err.contains("not followed")) << r.err.constData();
  EXPECT_TRUE(nodesBesides(1, "nodes --seconds 1 --format text")
                  .out.contains("disabled, faults_never_asked, status_never_heard\n"));
}

TEST_F(NodesOf, MoreDevicesThanAreFollowedIsSaid) {
  const Outcome r = nodesBesides(85, "nodes --seconds 1.5");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_TRUE(r.err.contains("frames of devices beyond the first 80, which are not followed"))
      << r.err.constData();
}

TEST_F(Live, WhoIsSaidToBeADriveIsNamedSoAndNeverAsked) {
  const Outcome nodes = run("nodes --seconds 1 --drive 80");
  EXPECT_EQ(nodes.status, 0) << nodes.err.constData();
  int drives = 0;
  for (const QJsonObject& node : nodes.objects()) {
    if (text(node, "what") != QStringLiteral("drive")) continue;
    ++drives;
    EXPECT_EQ(node[QLatin1String("address")].toInt(), 0x80);
  }
  EXPECT_EQ(drives, 1) << nodes.out.constData();
  EXPECT_EQ(run("poll --unlock --all --kinds fault --drive 80").status, 0);
  EXPECT_FALSE(std::ranges::any_of(m_witness.frames, [](const Frame& frame) {
    return (frame.identifier() >> 8 & 0xFF'FF) == 0xEF80 && frame.data[0] == 0x02;
  }));
  EXPECT_EQ(run("nodes --drive 1FF").status, 2);
}

TEST_F(Live, LockedItListensAndSendsNothing) {
  const Outcome r = run("nodes --seconds 1 --format text");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_GE(r.lines().size(), 3) << r.out.constData();
  EXPECT_TRUE(r.out.contains("6039 CAN I/O module")) << "by what it sends\n" << r.out.constData();
  EXPECT_EQ(run("watch --seconds 1").status, 0);
  EXPECT_FALSE(anyFrom(0xF9));
  EXPECT_FALSE(anyFrom(0xFE));
}

TEST_F(Live, PollWritesEveryAnswerWithTheKeysOfDecode) {
  const Outcome r = run("poll --unlock --pin 1032AE100801035 --own-address FB");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  QStringList requests;
  for (const QJsonObject& answer : r.objects()) {
    requests += text(answer, "ask");
    EXPECT_EQ(text(answer, "pin"), QLatin1String(kMonitor));
    EXPECT_EQ(answer[QLatin1String("destination")].toInt(), 0xFB);
  }
  EXPECT_EQ(requests, words("fault firmware pcode config vista vista"));
  EXPECT_EQ(r.objects()[2][QLatin1String("fields")][QLatin1String("style")].toInt(), 3356);
}

TEST_F(Live, PollOfEveryoneSaysWhoDidNotAnswer) {
  intent(2, SimulatedFault::AnswersWrongSource);  // the one without a PIN
  const Outcome r = run("poll --unlock --all --kinds fault");
  EXPECT_EQ(r.status, 1);
  int answers = 0;
  for (const QJsonObject& line : r.objects()) {
    if (!line.contains(QLatin1String("end"))) {
      ++answers;
      continue;
    }
    EXPECT_TRUE(line[QLatin1String("pin")].isNull());
    EXPECT_EQ(line[QLatin1String("address")].toInt(), m_status.devices[2].address.value);
    EXPECT_EQ(text(line, "ask"), QStringLiteral("fault"));
    EXPECT_EQ(text(line, "end"), QStringLiteral("no_answer"));
    EXPECT_EQ(line[QLatin1String("tries")].toInt(), 3);
  }
  EXPECT_EQ(answers, 3);
}

TEST_F(Live, AnAnswerThatComesTwiceIsOneLine) {
  intent(0, SimulatedFault::AnswersTwice);
  const Outcome r = run("poll --unlock --pin 1032AE100801035 --kinds fault,firmware");
  EXPECT_EQ(r.status, 0);
  EXPECT_EQ(r.lines().size(), 2) << r.out.constData();
}

TEST_F(Live, AnswersOfAWrongLengthAreShownAndAreNone) {
  intent(0, SimulatedFault::AnswersWrongLength);
  const Outcome r = run("poll --unlock --pin 1032AE100801035 --kinds fault");
  EXPECT_EQ(r.status, 1);
  ASSERT_EQ(r.lines().size(), 4);
  EXPECT_EQ(text(r.objects()[0], "message"), QStringLiteral("malformed"));
  EXPECT_EQ(text(r.objects()[3], "end"), QStringLiteral("wrong_answer"));
}

TEST_F(Live, PollGoesOnForAsManyRoundsAsWereAskedFor) {
  const Outcome r = run("poll --unlock --address 80 --kinds firmware --every 0.5 --count 3");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_EQ(r.lines().size(), 3);
}

TEST_F(Live, PollUntilStoppedEndsByCtrlC) {
  QProcess process;
  start(process, "poll --unlock --pin 1032AE100801035 --kinds fault --every 0.5");
  ASSERT_TRUE(QTest::qWaitFor([&] { return process.bytesAvailable() > 0; }, kPatience));
  ::kill(static_cast<pid_t>(process.processId()), SIGINT);
  EXPECT_EQ(end(process).status, 0);
}

TEST_F(Live, PollUntilStoppedIsNotWholeIfAnAnswerIsMissing) {
  intent(0, SimulatedFault::AnswersWrongSource);
  QProcess process;
  start(process, "poll --unlock --pin 1032AE100801035 --kinds fault --every 5");
  ASSERT_TRUE(QTest::qWaitFor([&] { return wasSent(0x80, 0x02); }, kPatience));
  ::kill(static_cast<pid_t>(process.processId()), SIGINT);
  const Outcome r = end(process);
  EXPECT_EQ(r.status, 1);
  ASSERT_EQ(r.lines().size(), 1) << r.out.constData();
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("stopped"));
  EXPECT_EQ(r.objects()[0][QLatin1String("on_bus")], QJsonValue(true));
}

TEST_F(Live, CommandThatIsStoppedSaysThatItIsOnTheBus) {
  intent(0, SimulatedFault::ResetNever);
  QProcess process;
  start(process, "command reset --unlock --yes --address 80");
  ASSERT_TRUE(QTest::qWaitFor([&] { return wasSent(0x80, 0x45); }, kPatience));
  ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
  const Outcome r = end(process);
  EXPECT_EQ(r.status, 1);
  ASSERT_EQ(r.lines().size(), 1) << r.out.constData();
  EXPECT_EQ(text(r.objects()[0], "ask"), QStringLiteral("reset"));
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("stopped"));
  EXPECT_EQ(r.objects()[0][QLatin1String("on_bus")], QJsonValue(true));
}

// Without an echo nobody can tell.
TEST_F(Live, CommandThatIsStoppedSaysThatItCannotTellOnALinkWithoutEcho) {
  intent(0, SimulatedFault::ResetNever);
  ASSERT_TRUE(m_interface.endsWith(QLatin1String("?echo")));
  m_interface.chop(5);
  QProcess process;
  start(process, "command reset --unlock --yes --address 80");
  ASSERT_TRUE(QTest::qWaitFor([&] { return wasSent(0x80, 0x45); }, kPatience));
  ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
  const Outcome r = end(process);
  EXPECT_EQ(r.status, 1);
  ASSERT_EQ(r.lines().size(), 1) << r.out.constData();
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("stopped"));
  EXPECT_TRUE(r.objects()[0].contains(QLatin1String("on_bus")));
  EXPECT_TRUE(r.objects()[0][QLatin1String("on_bus")].isNull());
}

TEST_F(Live, WhatADeviceDoesNotTakeIsSaid) {
  const Outcome r = run("poll --unlock --pin 1033AE100802117 --kinds vista,fault");
  EXPECT_EQ(r.status, 1);
  ASSERT_EQ(r.lines().size(), 2);
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("not_taken"));
  EXPECT_EQ(text(r.objects()[1], "message"), QStringLiteral("fault_response"));
}

TEST_F(Live, ADeviceThatIsNotThereIsSaid) {
  const Outcome r = run("poll --unlock --pin 1032AE999999999");
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.out.isEmpty());
  EXPECT_TRUE(r.err.contains("1032AE999999999 is not heard")) << r.err.constData();
}

// A foreign node with the lowest of all NAMEs, at an address of the simulator's.
class AddressTaken : public Live {
 protected:
  void take(Address address) {
    Frame claim;
    claim.id = J1939Id{6, pgn::kAddressClaimed, address, kGlobalAddress}.frameId();
    claim.data = {1};
    claim.length = 8;
    m_claim = claim;
    QObject::connect(&m_again, &QTimer::timeout, &m_again, [this] { m_witnessLink->write(m_claim); });
    m_witnessLink->write(m_claim);
    m_again.start(100);
  }
  Frame m_claim;
  QTimer m_again;
};

TEST_F(AddressTaken, CommandSaysWhoHoldsIt) {
  take(Address{0x80});
  const Outcome r = run("command setup-mode --unlock --yes --address 80");
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.out.isEmpty()) << r.out.constData();
  EXPECT_TRUE(r.err.contains("address 80 is held by NAME 0000000000000001")) << r.err.constData();
}

TEST_F(AddressTaken, PollOfWhoIsThereNoMoreSaysSo) {
  const Address address = m_status.devices[2].address;  // the one without a PIN
  QProcess process;
  start(process, "poll --unlock --kinds fault --every 0.5 --count 8",
        {QStringLiteral("--address"), QString::number(address.value, 16)});
  ASSERT_TRUE(QTest::qWaitFor([&] { return process.bytesAvailable() > 0; }, kPatience));
  take(address);
  const Outcome r = end(process);
  EXPECT_EQ(r.status, 1);
  ASSERT_FALSE(r.lines().empty());
  EXPECT_EQ(text(r.objects().last(), "end"), QStringLiteral("refused"));
  EXPECT_EQ(text(r.objects().last(), "reason"), QStringLiteral("address_taken"));
}

TEST_F(AddressTaken, NodesCountsTheFramesOfWhoHoldsIt) {
  QProcess process;
  start(process, "nodes --unlock --seconds 4");
  ASSERT_TRUE(QTest::qWaitFor([&] { return anyFrom(0xF9); }, kPatience));
  m_witness.frames.clear();
  ASSERT_TRUE(QTest::qWaitFor([&] { return anyFrom(0x80); }, kPatience));  // which it hears too
  take(Address{0x80});
  const Outcome r = end(process);
  int frames = 0;
  for (const QJsonObject& node : r.objects()) {
    if (node[QLatin1String("address")].toInt() == 0x80) frames = node[QLatin1String("frames")].toInt();
  }
  const auto taken = std::ranges::find_if(
      m_witness.frames, [this](const Frame& f) { return f.id == m_claim.id && f.data == m_claim.data; });
  const auto since = std::count_if(taken, m_witness.frames.end(), [](const Frame& f) {
    return f.isExtended() && (f.identifier() & 0xFF) == 0x80;
  });
  EXPECT_GT(frames, 0) << r.out.constData();
  EXPECT_LE(frames, since) << "those before are the monitor's";
}

TEST_F(Live, CommandWithoutYesNamesTheDeviceAndSendsNone) {
  const Outcome r = run("command setup-mode --unlock --address 80");
  EXPECT_EQ(r.status, 2);
  EXPECT_TRUE(r.err.contains("setup mode 1032AE100801035 (6032 Universal II)")) << r.err.constData();
  EXPECT_FALSE(std::ranges::any_of(m_witness.frames, [](const Frame& frame) {
    return (frame.identifier() >> 8 & 0xFF'FF) == 0xEF80 && frame.data[0] == 0x46;
  }));
}

TEST_F(Live, CommandIsDoneOnceItIsAcknowledged) {
  const Outcome r = run("command zero-axes --unlock --yes --pin 1032AE100801035");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  ASSERT_EQ(r.lines().size(), 1);
  EXPECT_EQ(text(r.objects()[0], "ask"), QStringLiteral("zero_axes"));
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("answered"));
}

TEST_F(Live, ResetIsDoneOnceTheDeviceAnnouncesItselfAnew) {
  const Outcome r = run("command reset --unlock --yes --address 80");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("restarted"));
}

TEST_F(Live, ResetOfADeviceThatNeverReturnsIsNotDone) {
  intent(0, SimulatedFault::ResetNever);
  const Outcome r = run("command reset --unlock --yes --pin 1032AE100801035");
  EXPECT_EQ(r.status, 1) << r.err.constData();
  ASSERT_EQ(r.lines().size(), 1);
  EXPECT_EQ(text(r.objects()[0], "ask"), QStringLiteral("reset"));
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("no_answer"));
  EXPECT_EQ(r.objects()[0][QLatin1String("tries")].toInt(), 1) << "never sent again";
}

TEST_F(Live, CommandThatIsNotAcknowledgedIsNotDone) {
  intent(0, SimulatedFault::AnswersWrongSource);
  const Outcome r = run("command setup-mode --unlock --yes --pin 1032AE100801035");
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(text(r.objects()[0], "end"), QStringLiteral("no_answer"));
  EXPECT_EQ(r.objects()[0][QLatin1String("tries")].toInt(), 1);
}

TEST_F(Live, PipeSendsStandardInputAndWritesWhatTheDeviceSays) {
  const Outcome r = run("pipe --unlock --pin 1032AE100801035", "ECHO over the pipe\n");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_EQ(r.out, "over the pipe\r\n");
}

// With CR LF as the end of line too: the simulator's shell would answer an empty line of its own to a second CR.
TEST_F(Live, PipeMakesOneLineEndOfCrLf) {
  const Outcome r = run("pipe --unlock --pin 1032AE100801035 --line-end crlf", "ECHO one\r\nECHO two\r\n");
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_EQ(r.out, "one\r\ntwo\r\n");
  EXPECT_EQ(piped(), "ECHO one\r\nECHO two\r\n");
}

TEST_F(Live, PipeMakesOneLineEndOfCrLfInTwoReads) {
  QProcess process;
  start(process, "pipe --unlock --pin 1032AE100801035");
  process.write("ECHO one\r");
  ASSERT_TRUE(QTest::qWaitFor([&] { return piped() == "ECHO one"; }, kPatience));
  process.write("\nECHO two\r\n");
  process.closeWriteChannel();
  EXPECT_EQ(end(process).status, 0);
  EXPECT_EQ(piped(), "ECHO one\rECHO two\r");
}

TEST_F(Live, PipeSaysWhatWasExpectedOnAClosedStandardInput) {
  QProcess shell;
  shell.start(QStringLiteral("/bin/sh"),
              {QStringLiteral("-c"),
               QStringLiteral("exec \"$0\" pipe --unlock --address 80 --plugin virtualcan "
                              "--interface \"$1\" <&-"),
               QStringLiteral(DECKPIPECTL), m_interface});
  const Outcome r = end(shell);
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("What to send was expected there")) << r.err.constData();
}

TEST_F(Live, PipeSendsAFileWhoseSumTheDeviceConfirms) {
  QTemporaryDir dir;
  const QString path = dir.filePath(QStringLiteral("content"));
  QByteArray content;
  for (int i = 0; i < 1500; ++i) content += static_cast<char>(i * 7 + i / 256);
  const uLong crc = crc32(0, reinterpret_cast<const Bytef*>(content.constData()), 1500);
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
  file.close();
  const Outcome r =
      run("pipe --unlock --address 80", {},
          {QStringLiteral("--before"), QStringLiteral("FILE 1500"), QStringLiteral("--file"), path});
  EXPECT_EQ(r.status, 0) << r.err.constData();
  const QByteArray sum = QByteArray::number(static_cast<quint64>(crc), 16).toUpper().rightJustified(8, '0');
  EXPECT_TRUE(r.out.contains("OK 1500 CRC32 " + sum)) << r.out.constData();
  EXPECT_TRUE(r.err.contains("1500 bytes in ")) << r.err.constData();
  EXPECT_TRUE(r.err.contains("acknowledgements")) << r.err.constData();
}

// More than ten packets, of which the tenth is not acknowledged; less than the simulator's shell takes as a line.
constexpr const char* kLong = "ECHO a line that takes more than ten packets on its way to the device shell\n";

TEST_F(Live, PipeStopsAtAMissingAckAndSaysHowMuchWasAcknowledged) {
  intent(0, SimulatedFault::AcksLost);
  const Outcome r = run("pipe --unlock --pin 1032AE100801035", kLong);
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("no acknowledgement; 63 of 76 bytes were acknowledged")) << r.err.constData();
}

TEST_F(Live, PipeSkipsAPacketOnlyWhenToldTo) {
  intent(0, SimulatedFault::AcksLost);
  const Outcome r = run("pipe --unlock --pin 1032AE100801035 --on-missing-ack skip", kLong);
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("going on with the next packet")) << r.err.constData();
  EXPECT_TRUE(r.out.startsWith("a line that takes more")) << r.out.constData();
}

TEST_F(Live, PipeSendsAgainOnlyWhenToldTo) {
  intent(0, SimulatedFault::AcksLost);
  const Outcome r = run("pipe --unlock --pin 1032AE100801035 --on-missing-ack resend", kLong);
  EXPECT_EQ(r.status, 0);
  EXPECT_TRUE(r.err.contains("it may arrive twice")) << r.err.constData();
}

// The adapter's queue is full at the third packet, once.
class FullQueue : public Live {
 protected:
  Outcome pipe(const QStringList& more) const {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_PLUGIN_PATH"), QStringLiteral(TEST_PLUGINS));
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(DECKPIPECTL),
                  words("pipe --unlock --pin 1032AE100801035 --plugin fullqueue --interface") +
                      QStringList{m_interface} + more);
    process.write(kLong);
    process.closeWriteChannel();
    return end(process);
  }
};

TEST_F(FullQueue, StopsThePipeWhichSaysThatThePacketWasNotSent) {
  const Outcome r = pipe({});
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains(
      "the adapter did not take the packet: it was not sent; 14 of 76 bytes were acknowledged"))
      << r.err.constData();
  EXPECT_EQ(piped(), QByteArray(kLong).left(14)) << "nothing goes out behind it";
}

TEST_F(FullQueue, LetsThePipeSendThePacketAgainOnlyWhenToldTo) {
  const Outcome r = pipe(words("--on-missing-ack resend"));
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_TRUE(r.err.contains("it was not sent; sending the packet again")) << r.err.constData();
  EXPECT_FALSE(r.err.contains("twice")) << r.err.constData();
  EXPECT_EQ(piped(), QByteArray(kLong).replace('\n', '\r'));
}

TEST_F(Live, PipeEndsWhereTheDeviceRestartsInTheMiddle) {
  intent(0, SimulatedFault::AcksLate);
  QTemporaryDir dir;
  QFile file(dir.filePath(QStringLiteral("content")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(QByteArray(70'000, 'x')) == 70'000);
  file.close();
  QProcess process;
  start(process, "pipe --unlock --pin 1032AE100801035 --on-missing-ack resend",
        {QStringLiteral("--file"), file.fileName()});
  ASSERT_TRUE(QTest::qWaitFor([&] { return wasSent(0x80, 0xFE); }, kPatience));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return process.readAllStandardError().contains(" bytes/s"); }, kPatience));
  m_simulator.obey({0, SimulatorButton::Reset});
  const Outcome r = end(process);
  EXPECT_EQ(r.status, 1);
  // Where the ack that is missing is noticed before the device is back, its silence is the reason.
  EXPECT_TRUE(r.err.contains("the device restarted meanwhile") ||
              r.err.contains("the device was not heard for 1 s"))
      << r.err.constData();
}

TEST_F(Live, PipeEndsPolitelyByCtrlC) {
  QProcess process;
  start(process, "pipe --unlock --pin 1032AE100801035");
  process.write("A?\n");
  ASSERT_TRUE(QTest::qWaitFor([&] { return process.bytesAvailable() > 0; }, kPatience));
  ::kill(static_cast<pid_t>(process.processId()), SIGINT);
  EXPECT_EQ(end(process).status, 0);
}

// The packet in flight is waited for, no other is sent, and it is told how far it came.
TEST_F(Live, PipeEndsAFileByCtrlCAfterThePacketInFlight) {
  QTemporaryDir dir;
  QFile file(dir.filePath(QStringLiteral("content")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(QByteArray(70'000, 'x')) == 70'000);
  file.close();
  intent(0, SimulatedFault::AcksLate);  // so that one is in flight
  QProcess process;
  start(
      process, "pipe --unlock --pin 1032AE100801035",
      {QStringLiteral("--before"), QStringLiteral("FILE 70000"), QStringLiteral("--file"), file.fileName()});
  const auto packets = [&](std::uint32_t from, std::size_t least) {
    return std::ranges::count_if(m_witness.frames, [=](const Frame& frame) {
      return (frame.identifier() & 0xFF'FF'FF) == from && frame.data[0] == 0xFE && frame.length >= least;
    });
  };
  const auto sent = [&] { return packets(0xEF80F9, 2); };
  const auto acks = [&] { return packets(0xEFF980, 1) - packets(0xEFF980, 2); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return sent() >= 4 && sent() > acks(); }, kPatience));
  ::kill(static_cast<pid_t>(process.processId()), SIGINT);
  const Outcome r = end(process);
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("stopped; ")) << r.err.constData();
  EXPECT_TRUE(r.err.contains(" of 70000 bytes were acknowledged")) << r.err.constData();
  ASSERT_TRUE(QTest::qWaitFor([&] { return acks() == sent(); }, kPatience));
}

TEST_F(Live, WatchTellsDevicesValuesAndSilence) {
  QProcess process;
  start(process, "watch --unlock");
  const auto heard = [&, all = QByteArray()](const char* part) mutable {
    return QTest::qWaitFor([&] { return (all += process.readAllStandardOutput()).contains(part); },
                           kPatience);
  };
  auto says = heard;
  EXPECT_TRUE(says("\"event\":\"link_up\""));
  EXPECT_TRUE(says("\"event\":\"claimed\""));
  EXPECT_TRUE(says("\"event\":\"own_address\""));
  EXPECT_TRUE(says("\"pin\":\"1032AE100801035\",\"address\":128,\"device_type\":1032"));
  EXPECT_TRUE(says("\"event\":\"value\",\"pin\":\"1032AE100801035\""));
  m_simulator.obey({0, SimulatorButton::PowerOff});
  EXPECT_TRUE(says("\"event\":\"stale\""));
  m_simulator.obey({0, SimulatorButton::PowerOn});
  EXPECT_TRUE(says("\"event\":\"fresh\""));
  EXPECT_TRUE(says("\"event\":\"restarted\""));
  ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
  EXPECT_EQ(end(process).status, 0);
}

TEST_F(Live, TwoOfOneIdentityCannotBeOnOneBus) {
  QProcess first;
  start(first, "watch --unlock --identity 7");
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return first.readAllStandardOutput().contains("own_address"); }, kPatience));
  const Outcome second = run("poll --unlock --identity 7 --all");
  EXPECT_EQ(second.status, 1);
  EXPECT_TRUE(second.err.contains("another --identity")) << second.err.constData();
  first.terminate();
  end(first);
}

TEST_F(Live, TwoIdentitiesHaveAnAddressEach) {
  QProcess first;
  start(first, "watch --unlock --identity 7");
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return first.readAllStandardOutput().contains("own_address"); }, kPatience));
  const Outcome second = run("poll --unlock --identity 8 --address 80 --kinds fault");
  EXPECT_EQ(second.status, 0) << second.err.constData();
  EXPECT_EQ(second.objects()[0][QLatin1String("destination")].toInt(), 0xFA);
  first.terminate();
  end(first);
}

// The bus of an adapter that does not come back by itself goes away.
class BusGone : public testing::TestWithParam<const char*> {};
TEST_P(BusGone, EndsWithTheReason) {
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), words(GetParam()) + words("--plugin virtualcan --interface") +
                                                 QStringList{bus.interfaceName(0)});
  ASSERT_TRUE(QTest::qWaitFor([&] { return bus.clients(0) == 1; }, kPatience));
  bus.stop();
  ASSERT_TRUE(QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, kPatience));
  const Outcome r = test::outcomeOf(process);
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.err.contains("/can0?echo: ")) << r.err.constData();
}
INSTANTIATE_TEST_SUITE_P(Ctl, BusGone,
                         testing::Values("watch", "watch --unlock", "nodes --seconds 100",
                                         "poll --unlock --all --every 1", "pipe --unlock --address 80",
                                         "command reset --yes --unlock --address 80", "simulate"));

TEST(NodesOfABusThatGoes, AreToldAsFarAsTheyWereHeard) {
  VirtualBus bus;
  ASSERT_TRUE(bus.start());
  RecordingListener peer;
  CanLink link({QStringLiteral("virtualcan"), bus.interfaceName(0), 250'000, {}});
  link.open(peer);
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL),
                words("nodes --unlock --seconds 100 --plugin virtualcan --interface") +
                    QStringList{bus.interfaceName(0)});
  const auto asksAgain = [&] {
    peer.forget();
    return QTest::qWaitFor([&] { return !peer.frames.empty(); }, kPatience);
  };
  ASSERT_TRUE(asksAgain());
  link.write(test::frame("18EFFF80", "FF83150206021A0B"));
  ASSERT_TRUE(asksAgain() && asksAgain()) << "the frame has arrived by then";
  bus.stop();
  ASSERT_TRUE(QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, kPatience));
  const Outcome r = test::outcomeOf(process);
  EXPECT_EQ(r.status, 1);
  EXPECT_TRUE(r.out.contains("1032AE100801035")) << r.out.constData();
}

}  // namespace
}  // namespace deckpipe
