// SPDX-License-Identifier: GPL-3.0-or-later
// The headless tool as a script meets it: the program itself, its output, its exit status.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <csignal>

#include "run_ctl.h"

namespace {

using deckpipe::test::Outcome;
using deckpipe::test::words;

Outcome run(const QStringList& arguments, const QByteArray& input = {}) {
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), arguments);
  process.write(input);
  process.closeWriteChannel();
  EXPECT_TRUE(process.waitForFinished(60'000));
  return deckpipe::test::outcomeOf(process);
}

QStringList decode(const QStringList& more = {}) {
  return QStringList{QStringLiteral("decode")} + more + QStringList{QStringLiteral("-")};
}

const QByteArray kAnnouncement = "(1700000000.000000) can0 18EFFF80#FF83150206021A0B\n";
const QByteArray kPosition = "(1700000000.123456) can0 18EFFF80#011D940371000041\n";

// The times that a log is told to have, by decode and by info.
struct FewTimes {
  const char* name;
  const char* stamps;
  const char* told;
  const char* span;
};
class LogsOfFewTimes : public testing::TestWithParam<FewTimes> {};

TEST_P(LogsOfFewTimes, HaveOneAnswerEverywhere) {
  QByteArray log;
  for (const QString& stamp : words(GetParam().stamps))
    log += '(' + stamp.toLatin1() + ") can0 18EFFF80#83C051\n";
  QByteArray told;
  for (const QByteArray& line : run(decode(), log).lines()) told += line.mid(5, line.indexOf(',') - 5) + ' ';
  EXPECT_EQ(told.trimmed(), QByteArray(GetParam().told));
  const QByteArray json = run(words("info --json -"), log).out;
  EXPECT_TRUE(json.contains("\"span\":" + QByteArray(GetParam().span) + ',')) << json.constData();
}
INSTANTIATE_TEST_SUITE_P(Stamps, LogsOfFewTimes,
                         testing::Values(FewTimes{"AllZero", "0.0 0.0 0.0", "null null null", "null"},
                                         FewTimes{"OneAtZero", "0.0", "null", "null"},
                                         FewTimes{"FromZeroOn", "0.0 0.5", "0.000000 0.500000", "0.500000"},
                                         FewTimes{"OneFrame", "7.0", "7.000000", "0.000000"},
                                         FewTimes{"TwoFrames", "7.0 7.5", "7.000000 7.500000", "0.500000"},
                                         FewTimes{"AllEqual", "7.0 7.0 7.0", "7.000000 7.000000 7.000000",
                                                  "0.000000"}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Decode, WritesTheLineOfTheProtocolPage) {
  const Outcome r = run(decode(), kAnnouncement + kPosition);
  EXPECT_EQ(r.status, 0) << r.err.constData();
  ASSERT_EQ(r.lines().size(), 2);
  const QByteArray line = r.lines()[1];
  EXPECT_TRUE(line.startsWith(
      R"({"t":1700000000.123456,"channel":"can0","id":"18EFFF80","data":"011D940371000041",)"
      R"("family":"akron","message":"position_limit_status","source":128,"destination":255,)"))
      << line.constData();
  const QJsonObject fields = QJsonDocument::fromJson(line).object()[QStringLiteral("fields")].toObject();
  EXPECT_EQ(fields[QStringLiteral("rotation_deg")].toDouble(), 47.3);
  EXPECT_EQ(fields[QStringLiteral("elevation_deg")].toDouble(), -5.5);
  EXPECT_TRUE(line.contains(R"("rotation_deg":47.3,)"));
}

struct LineCase {
  const char* name;
  const char* input;
  const char* expected;
};

class DecodeLine : public testing::TestWithParam<LineCase> {};
TEST_P(DecodeLine, IsExactly) {
  const Outcome r = run(decode(), QByteArray(GetParam().input) + '\n');
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_EQ(r.out, QByteArray(GetParam().expected) + '\n');
}
INSTANTIATE_TEST_SUITE_P(
    Contract, DecodeLine,
    testing::Values(
        LineCase{
            "NoTime", "  can0  123   [2]  01 02",
            R"({"t":null,"channel":"can0","id":"123","data":"0102","family":null,"message":null,"fields":null})"},
        LineCase{
            "UnknownPgn", "(1.5) can0 18FF0005#",
            R"({"t":1.500000,"channel":"can0","id":"18FF0005","data":"","family":null,"message":null,"source":5,)"
            R"("pgn":65280,"pgn_name":"Proprietary B","fields":null})"},
        LineCase{
            "NamedPgn", "(1.5) can0 0CF00400#11",
            R"({"t":1.500000,"channel":"can0","id":"0CF00400","data":"11","family":null,"message":null,"source":0,)"
            R"-("pgn":61444,"pgn_name":"Electronic engine controller 1 (EEC1)","fields":null})-"},
        LineCase{
            "PgnWithoutName", "(1.5) can0 18FE0005#11",
            R"({"t":1.500000,"channel":"can0","id":"18FE0005","data":"11","family":null,"message":null,"source":5,)"
            R"("pgn":65024,"fields":null})"},
        LineCase{
            "Remote", "(1.0) can0 724#R1",
            R"({"t":1.000000,"channel":"can0","id":"724","data":"","family":null,"message":null,"node":36,)"
            R"("remote":true,"fields":null})"},
        LineCase{"Error", "(1.0) can0 20000080#0000000000000000",
                 R"({"t":1.000000,"channel":"can0","id":"20000080","data":"0000000000000000","family":null,)"
                 R"("message":null,"error":true,"fields":null})"},
        LineCase{
            "Malformed", "(1.0) can0 0CFDD633#0100",
            R"({"t":1.000000,"channel":"can0","id":"0CFDD633","data":"0100","family":"j1939","message":"malformed",)"
            R"("source":51,"reason":"8 bytes wanted, 2 came","fields":null})"},
        LineCase{
            "NoFields", "(1.0) can0 18EF8005#02",
            R"({"t":1.000000,"channel":"can0","id":"18EF8005","data":"02","family":"presumed","message":"fault_poll",)"
            R"("source":5,"destination":128,"fields":{}})"},
        LineCase{
            "Faults", "(1.0) can0 18EF0580#02002010000000",
            R"({"t":1.000000,"channel":"can0","id":"18EF0580","data":"02002010000000","family":"presumed",)"
            R"("message":"fault_response","source":128,"destination":5,)"
            R"("fields":{"faults":["internal_fuse"],"reserved_bits":[12],"pcode_error":0}})"},
        LineCase{
            "OneDecimalAtMost", "(1.0) can0 18EFFF80#810000FFFF80",
            R"({"t":1.000000,"channel":"can0","id":"18EFFF80","data":"810000FFFF80","family":"presumed",)"
            R"("message":"rotation_soft_limits","source":128,"destination":255,)"
            R"("fields":{"left_deg":0,"right_deg":-0.1,"oscillating":true}})"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Decode, NamesNumbersInTextAlone) {
  const QByteArray log = "(1.0) can0 18EF0580#0200000000000B\n(2.0) can0 000#8100\n";
  const Outcome text = run(decode({QStringLiteral("--format"), QStringLiteral("text")}), log);
  EXPECT_TRUE(text.lines()[0].endsWith("pcode_error 11 (rotation sensor error)")) << text.out.constData();
  EXPECT_TRUE(text.lines()[1].endsWith("command 129 (reset node), node 0 (all nodes)"))
      << text.out.constData();
  EXPECT_TRUE(run(decode({}), log).lines()[0].endsWith(R"("pcode_error":11}})"));
}

TEST(Decode, TakesDrivesOnOneChannelOrAll) {
  const QByteArray log = "(1.0) can0 18EF2105#022101\n(1.0) can1 18EF2105#022101\n";
  const Outcome all = run(decode({QStringLiteral("--drive"), QStringLiteral("21")}), log);
  EXPECT_EQ(all.out.count("copley_get_parameter"), 2);
  const Outcome one = run(decode({QStringLiteral("--drive"), QStringLiteral("can1:21")}), log);
  EXPECT_EQ(one.out.count("copley_get_parameter"), 1);
  EXPECT_TRUE(one.lines()[1].contains("copley_get_parameter"));
}

TEST(Decode, WritesCsvWithTheFieldsAsOneCell) {
  const Outcome r = run(decode({QStringLiteral("--format"), QStringLiteral("csv")}), kPosition);
  ASSERT_EQ(r.lines().size(), 2);
  EXPECT_EQ(r.lines()[0], "t,channel,id,data,family,message,source,destination,node,fields");
  EXPECT_TRUE(r.lines()[1].startsWith(
      R"(1700000000.123456,can0,18EFFF80,011D940371000041,presumed,position_limit_status,128,255,,"{""rotation_deg"":47.3,)"))
      << r.lines()[1].constData();
}

TEST(Decode, SaysUnreadableLinesWithNumberAndReasonAndGoesOn) {
  const Outcome r = run(decode(), kPosition + "(1.0) can0 nonsense\n" + kPosition);
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.lines().size(), 2);
  EXPECT_TRUE(r.err.contains("standard input:2: ")) << r.err.constData();
}

TEST(Decode, SaysOfWhatIsNoLogWhichFormatsAreRead) {
  const Outcome r = run(decode(), "no log\n");
  EXPECT_EQ(r.status, 3);
  EXPECT_TRUE(r.err.contains("standard input: not a log of a known format: Deckpipe recording, candump"))
      << r.err.constData();
}

TEST(Decode, CountsSkippedCanFdFramesOnStandardError) {
  const Outcome r = run(decode(), kPosition + "(1.0) can0 123##0112233\n");
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.lines().size(), 1);
  EXPECT_TRUE(r.err.contains("1 not kept")) << r.err.constData();
}

struct ReadCase {
  const char* name;
  QByteArray content;
  int status;
  const char* said;       // on standard error; empty: nothing is said at all
  bool hasReport = true;  // of info
};
class ReadStatus : public testing::TestWithParam<ReadCase> {
 protected:
  static void expect(const Outcome& r, bool hasOutput) {
    EXPECT_EQ(r.status, GetParam().status) << r.err.constData();
    if (*GetParam().said == '\0') {
      EXPECT_TRUE(r.err.isEmpty()) << r.err.constData();
    } else {
      EXPECT_EQ(r.err.count(GetParam().said), 1) << r.err.constData();
      EXPECT_EQ(r.err.count('\n'), 1) << "told once: " << r.err.constData();
    }
    if (!hasOutput) {
      EXPECT_TRUE(r.out.isEmpty()) << r.out.constData();
    }
  }
};
TEST_P(ReadStatus, IsTheSameOfFileAndPipeAndOfInfoAndDecode) {
  QTemporaryDir dir;
  QFile file(dir.filePath(QStringLiteral("a log")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(GetParam().content);
  file.close();
  expect(run(decode(), GetParam().content), true);
  expect(run({QStringLiteral("decode"), file.fileName()}), true);
  expect(run(words("info -"), GetParam().content), GetParam().hasReport);
  expect(run({QStringLiteral("info"), QStringLiteral("--json"), file.fileName()}), GetParam().hasReport);
}
INSTANTIATE_TEST_SUITE_P(
    Contract, ReadStatus,
    testing::Values(
        ReadCase{"Whole", kPosition, 0, ""},
        ReadCase{"RecorderLostFrames", kPosition + "DROPCOUNT: dropped 3 CAN frames\n", 0, "recorder lost"},
        ReadCase{"AFractionNotRead", "(1700000000.4011223344) can0 123#11\n", 1, "1 not kept: fraction"},
        ReadCase{"LinesEndInCr", "(1.0) can0 123#11\r(2.0) can0 123#22\r", 0, ""},
        ReadCase{"ALastLineWithoutItsEnd", kPosition + kPosition.chopped(1), 0,
                 "the last line has no line end: it may be cut"},
        ReadCase{"ALastLineThatIsCut", kPosition + kPosition.chopped(3), 1, "it is cut and was left out"},
        ReadCase{"ALineNotRead", kPosition + "nonsense\n", 1, ":2: "},
        ReadCase{"AFrameSkipped", kPosition + "(1.0) can0 123##0112233\n", 1, "1 not kept"},
        ReadCase{"OnlySkippedFrames", "(1.0) can0 123##0112233\n", 4, "1 not kept", false},
        ReadCase{"NoLog", "no log\n", 3, "not a log of a known format", false},
        ReadCase{"OfAnotherProgram", "date Fri Apr 27 08:24:13 2018\nbase hex  timestamps absolute\n", 3,
                 "seems to be Vector ASC", false},
        ReadCase{"Empty", "", 4, "it is empty", false},
        ReadCase{"BlankLines", "\n \n\n", 4, "it holds no frame", false},
        ReadCase{"OnlyComments", "# nothing yet\n", 4, "it holds no frame", false}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(ReadStatusOfAFile, ThatIsNotThereIsThree) {
  for (const char* command :
       {"decode /nonexistent/x.log", "info /nonexistent/x.log", "decode /", "info --json /",
        "pipe --interface x --address 80 --unlock --file /nonexistent"}) {
    const Outcome r = run(words(command));
    EXPECT_EQ(r.status, 3) << command;
    EXPECT_TRUE(r.out.isEmpty()) << command;
    EXPECT_EQ(r.err.count('\n'), 1) << r.err.constData();
  }
}

TEST(ReadStatusOfAFile, ToSendThatIsEmptyIsFour) {
  const Outcome r = run(words("pipe --interface x --address 80 --unlock --file /dev/null"));
  EXPECT_EQ(r.status, 4);
  EXPECT_TRUE(r.err.contains("/dev/null: it is empty")) << r.err.constData();
}

TEST(ReadStatusOfAFile, ThatIsNoneWritesNoCsvHeader) {
  EXPECT_TRUE(run(decode(words("--format csv")), "no log\n").out.isEmpty());
}

struct UsageCase {
  const char* name;
  QStringList arguments;
};
class BadUsage : public testing::TestWithParam<UsageCase> {};
TEST_P(BadUsage, IsStatusTwoAndSaysWhy) {
  const Outcome r = run(GetParam().arguments);
  EXPECT_EQ(r.status, 2);
  EXPECT_TRUE(r.out.isEmpty());
  EXPECT_FALSE(r.err.isEmpty());
}
INSTANTIATE_TEST_SUITE_P(
    Contract, BadUsage,
    testing::Values(
        UsageCase{"Nothing", {}}, UsageCase{"NoSuchCommand", words("frobnicate")},
        UsageCase{"NoFile", words("decode")}, UsageCase{"TwoFiles", words("decode a b")},
        UsageCase{"NoSuchOption", words("decode --nope x")},
        UsageCase{"NoSuchFormat", words("decode --format xml -")},
        UsageCase{"DriveNotHex", words("decode --drive zz -")},
        UsageCase{"DriveGlobal", words("decode --drive FF -")},
        UsageCase{"DriveEmptyChannel", words("decode --drive :21 -")},
        UsageCase{"SimulateNowhere", words("simulate")},
        UsageCase{"SimulateNegative", words("simulate --log - --seconds -3")},
        UsageCase{"SimulateNoSuchFault", words("simulate --log - --misbehave monitor:dances")},
        UsageCase{"SimulateValueMissing", words("simulate --log - --misbehave monitor:pcode")},
        UsageCase{"SimulateValueEmpty", words("simulate --log - --misbehave monitor:late=")},
        UsageCase{"SimulateValueUnwanted", words("simulate --log - --misbehave monitor:silent=3")},
        UsageCase{"SimulateMoreLostThanThereAre", words("simulate --log - --misbehave io:acks-lost=3/2")},
        UsageCase{"SimulateNoSuchFaultBit", words("simulate --log - --misbehave io:fault=32")},
        UsageCase{"SimulateNoSuchMonitor", words("simulate --log - --misbehave monitor-2:silent")},
        UsageCase{"SimulateTooManyMonitors", words("simulate --log - --monitors 61")},
        UsageCase{"SimulateTooMuchLoad", words("simulate --log - --load 96")},
        UsageCase{"SimulateNoLoad", words("simulate --log - --load much")},
        UsageCase{"NodesNoInterface", words("nodes")},
        UsageCase{"NodesFormat", words("nodes --interface x --format xml")},
        UsageCase{"WatchSeconds", words("watch --interface x --seconds -1")},
        UsageCase{"PollLocked", words("poll --interface x --all")},
        UsageCase{"PollNobody", words("poll --interface x --unlock")},
        UsageCase{"PollTwo", words("poll --interface x --unlock --all --address 80")},
        UsageCase{"PollNoPin", words("poll --interface x --unlock --pin 1032")},
        UsageCase{"PollNoAddress", words("poll --interface x --unlock --address FE")},
        UsageCase{"PollNoSuchKind", words("poll --interface x --unlock --all --kinds reset")},
        UsageCase{"PollCountAlone", words("poll --interface x --unlock --all --count 2")},
        UsageCase{"PollIdentity", words("poll --interface x --unlock --all --identity 2097152")},
        UsageCase{"PollOwnAddress", words("poll --interface x --unlock --all --own-address 1FF")},
        UsageCase{"CommandLocked", words("command reset --interface x --address 80 --yes")},
        UsageCase{"CommandNone", words("command --interface x --address 80 --unlock --yes")},
        UsageCase{"CommandNoSuch", words("command explode --interface x --address 80 --unlock --yes")},
        UsageCase{"PipeLocked", words("pipe --interface x --address 80")},
        UsageCase{"PipeLineEnd", words("pipe --interface x --address 80 --unlock --line-end x")},
        UsageCase{"PipeMissingAck", words("pipe --interface x --address 80 --unlock --on-missing-ack x")}),
    [](const auto& row) { return std::string(row.param.name); });

constexpr const char* kCommands[] = {"decode", "info", "simulate", "nodes",
                                     "watch",  "poll", "pipe",     "command"};

TEST(Help, IsOnStandardOutputWithStatusZeroAndNamesTheSubcommand) {
  EXPECT_EQ(run(words("--help")).status, 0);
  for (const char* command : kCommands) {
    const Outcome r = run({QLatin1String(command), QStringLiteral("--help")});
    EXPECT_EQ(r.status, 0) << command;
    EXPECT_TRUE(r.out.startsWith("Usage: deckpipectl " + QByteArray(command) + " ")) << r.out.constData();
    for (const char* status : {"  0  ", "  1  ", "  2  ", "  3  ", "  4  "})
      EXPECT_TRUE(r.out.contains(status)) << command << status;
  }
}

TEST(Version, NamesTheSubcommand) {
  EXPECT_TRUE(run(words("--version")).out.startsWith("deckpipectl "));
  for (const char* command : kCommands) {
    const Outcome r = run({QLatin1String(command), QStringLiteral("--version")});
    EXPECT_EQ(r.status, 0) << command;
    EXPECT_TRUE(r.out.startsWith("deckpipectl " + QByteArray(command) + " ")) << r.out.constData();
  }
}

TEST(Help, SaysWhenItCannotBeWritten) {
  if (!QFile::exists(QStringLiteral("/dev/full"))) GTEST_SKIP() << "no /dev/full";
  for (const char* arguments : {"--help", "--version", "poll --help", "poll --version"}) {
    QProcess process;
    process.setStandardOutputFile(QStringLiteral("/dev/full"));
    process.start(QStringLiteral(DECKPIPECTL), words(arguments));
    ASSERT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitCode(), 1) << arguments;
  }
}

TEST(Link, ThatCannotBeHadIsSaid) {
  for (const char* command : {"nodes", "watch", "poll --unlock --all"}) {
    const Outcome r = run(words(command) + words("--interface nosuch0"));
    EXPECT_EQ(r.status, 1) << command;
    EXPECT_TRUE(r.err.contains("nosuch0: ")) << r.err.constData();
  }
}

TEST(OwnAddress, OfAJoystickOrAMonitorIsRefusedWithTheReason) {
  for (const char* address : {"33", "38", "80", "E0", "F7"}) {
    for (const char* command : {"nodes", "watch", "poll --unlock --all"}) {
      const Outcome r = run(words(command) + words("--interface nosuch0 --own-address") + words(address));
      EXPECT_EQ(r.status, 2) << command << address;
      EXPECT_TRUE(r.err.contains("are joysticks' addresses")) << r.err.constData();
      EXPECT_TRUE(r.err.contains("F8 to FD can be had")) << r.err.constData();
    }
  }
}

TEST(OwnAddress, BelowThemIsWarnedOfAndTaken) {
  const Outcome fixed = run(words("nodes --interface nosuch0 --own-address 42"));
  EXPECT_EQ(fixed.status, 1) << "it went on to the interface";
  EXPECT_TRUE(fixed.err.contains("warning: --own-address 42: ")) << fixed.err.constData();
  const Outcome tool = run(words("nodes --interface nosuch0 --own-address FA"));
  EXPECT_FALSE(tool.err.contains("warning")) << tool.err.constData();
}

constexpr const char* kMovers[] = {"simulate", "move --unlock --pin 1032AE100801035 --x 10 --for 100"};

TEST(Rule20Programs, OnWhatMayBeARealBusDoNothingWithoutTheWord) {
  for (const char* mover : kMovers) {
    const Outcome r = run(words(mover) + words("--plugin peakcan --interface usb0"));
    if (r.err.contains("no such plugin")) GTEST_SKIP() << "no plugin of an adapter";
    EXPECT_EQ(r.status, 2) << mover;
    EXPECT_TRUE(r.err.contains("--moves-monitors is the word for it")) << r.err.constData();
  }
}

TEST(Rule04, NoMonitorIsMovedOnABusWhoseEchoIsNotProven) {
  const Outcome r = run(words(kMovers[1]) + words("--plugin peakcan --interface usb0 --moves-monitors"));
  if (r.err.contains("no such plugin")) GTEST_SKIP() << "no plugin of an adapter";
  EXPECT_EQ(r.status, 2);
  EXPECT_TRUE(r.err.contains("real monitors are not moved yet")) << r.err.constData();
}

TEST(Rule20Programs, LookForTheInterfaceBeforeTheyAskForTheWord) {
  for (const char* mover : kMovers) {
    for (const char* where : {"nosuch0", "vcan-by-name", "lo", "nosuch0 --moves-monitors"}) {
      const Outcome r = run(words(mover) + words("--plugin socketcan --interface") + words(where));
      EXPECT_EQ(r.status, 2) << where;
      EXPECT_TRUE(r.err.contains("no such CAN interface: '")) << r.err.constData();
    }
  }
}

TEST(Plugin, ThatIsNotThereIsAnUnusableArgument) {
  for (const char* plugin : {"nosuch", ""}) {
    for (const char* command :
         {"nodes", "watch", "poll --unlock --all", "command reset --unlock --address 80",
          "pipe --unlock --address 80", "simulate"}) {
      const Outcome r =
          run(words(command) + QStringList{QStringLiteral("--plugin"), QLatin1String(plugin),
                                           QStringLiteral("--interface"), QStringLiteral("can0")});
      EXPECT_EQ(r.status, 2) << command;
      EXPECT_TRUE(r.err.contains("no such plugin: '" + QByteArray(plugin) + "'; installed are "))
          << r.err.constData();
    }
  }
}

TEST(Output, EndsQuietlyWhenItsReaderGoesAway) {
  QProcess shell;
  shell.start(
      QStringLiteral("/bin/sh"),
      {QStringLiteral("-c"), QStringLiteral("%1 simulate --log - --seconds 600 | head -n 1; echo done >&2")
                                 .arg(QStringLiteral(DECKPIPECTL))});
  ASSERT_TRUE(shell.waitForFinished(60'000));
  EXPECT_EQ(shell.readAllStandardOutput().count('\n'), 1);
  EXPECT_EQ(shell.readAllStandardError(), "done\n");
}

TEST(Output, SaysWhenItCannotBeWritten) {
  if (!QFile::exists(QStringLiteral("/dev/full"))) GTEST_SKIP() << "no /dev/full";
  QProcess shell;
  shell.start(
      QStringLiteral("/bin/sh"),
      {QStringLiteral("-c"),
       QStringLiteral("%1 simulate --log - --seconds 5 > /dev/full").arg(QStringLiteral(DECKPIPECTL))});
  ASSERT_TRUE(shell.waitForFinished(60'000));
  EXPECT_EQ(shell.exitCode(), 1);
  EXPECT_TRUE(shell.readAllStandardError().contains("standard output"));
}

TEST(Simulate, SaysWhyADiskTakesOnlyAPartOfIt) {
  const QTemporaryDir dir;
  const QString path = dir.filePath(QStringLiteral("a.log"));
  QProcess shell;
  shell.start(
      QStringLiteral("bash"),
      {QStringLiteral("-c"), QStringLiteral("trap '' XFSZ; ulimit -f 100; %1 simulate --log %2 --seconds 60")
                                 .arg(QStringLiteral(DECKPIPECTL), path)});
  ASSERT_TRUE(shell.waitForFinished(60'000));
  EXPECT_EQ(shell.exitCode(), 1);
  EXPECT_EQ(shell.readAllStandardError(), "deckpipectl: " + path.toUtf8() + ": File too large\n");
  EXPECT_FALSE(QFile::exists(path));
  const Outcome full = run(words("simulate --log /dev/full --seconds 5"));
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.err, "deckpipectl: /dev/full: No space left on device\n");
}

TEST(Simulate, WritesIntoAPipeThatALinkLeadsToAndLeavesTheLink) {
  const QTemporaryDir dir;
  const QString link = dir.filePath(QStringLiteral("out"));
  ASSERT_TRUE(QFile::link(QStringLiteral("/proc/self/fd/1"), link));
  const Outcome r = run({QStringLiteral("simulate"), QStringLiteral("--log"), link,
                         QStringLiteral("--seconds"), QStringLiteral("5")});
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_GT(r.lines().size(), 100);
  EXPECT_TRUE(QFileInfo(link).isSymbolicLink());
}

TEST(Simulate, ReplacesMarksOfAPersonOnlyIfItIsTold) {
  const QTemporaryDir dir;
  const QString path = dir.filePath(QStringLiteral("a.log")),
                notes = path + QStringLiteral(".deckpipe-notes");
  const auto write = [](const QString& to, const char* text) {
    QFile file(to);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  };
  write(path, "(1.0) can0 123#\n");
  write(notes, "Deckpipe notes 1\n");
  const QStringList simulate{QStringLiteral("simulate"), QStringLiteral("--log"), path};
  const Outcome refused = run(simulate);
  EXPECT_EQ(refused.status, 2);
  EXPECT_TRUE(refused.err.contains(notes.toUtf8() + ": the marks and labels of the log that is there"))
      << refused.err.constData();
  EXPECT_EQ(QFile(path).size(), 16);
  EXPECT_TRUE(QFile::exists(notes));
  EXPECT_EQ(run(simulate + QStringList{QStringLiteral("--replace-notes")}).status, 0);
  EXPECT_GT(QFile(path).size(), 16);
  EXPECT_FALSE(QFile::exists(notes));
}

TEST(Info, CountsTheFramesOfChannelsThatItCannotTellApart) {
  QByteArray log;
  for (int i = 0; i < 300; ++i) log += "(1.5) can" + QByteArray::number(i) + " 123#\n";
  const Outcome text = run(words("info -"), log);
  EXPECT_TRUE(
      text.out.contains("  300 frames over 0.000000 s on 255 channels\n"
                        "  45 frames are of further channels, which are all taken for one: 'other'\n"))
      << text.out.left(300).constData();
  EXPECT_EQ(run(words("info --json -"), log).objects()[0][QLatin1String("of_further_channels")].toInt(), 45);
}

TEST(Info, TellsNoSpanFinerThanTheTimesOfALog) {
  QByteArray log;
  for (int i = 0; i < 20; ++i) log += "(" + QByteArray::number(1'700'000'000 + i) + ") can0 123#\n";
  EXPECT_TRUE(run(words("info -"), log).out.contains("  20 frames over about 19 s on 1 channel\n"));
}

TEST(Simulate, WritesTheSameLogForTheSameSeedAndInfoKnowsItsDevices) {
  QTemporaryDir dir;
  const QString a = dir.filePath(QStringLiteral("a.log")), b = dir.filePath(QStringLiteral("b.log"));
  const auto simulate = [](const QString& file, const char* seed) {
    return run({QStringLiteral("simulate"), QStringLiteral("--log"), file, QStringLiteral("--seconds"),
                QStringLiteral("20"), QStringLiteral("--seed"), QString::fromLatin1(seed)});
  };
  EXPECT_EQ(simulate(a, "7").status, 0);
  EXPECT_EQ(simulate(b, "7").status, 0);
  const auto content = [](const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  EXPECT_EQ(content(a), content(b));
  simulate(b, "8");
  EXPECT_NE(content(a), content(b));

  const Outcome info =
      run({QStringLiteral("info"), QStringLiteral("--json"), QStringLiteral("--devices"), a});
  EXPECT_EQ(info.status, 0);
  const QJsonObject object = QJsonDocument::fromJson(info.out).object();
  EXPECT_EQ(object[QStringLiteral("frames")].toInt(), content(a).count('\n'));
  QStringList pins;
  for (const QJsonValue& device : object[QStringLiteral("devices")].toArray())
    pins += device[QStringLiteral("pin")].toString();
  EXPECT_TRUE(pins.contains(QStringLiteral("1032AE100801035"))) << info.out.constData();
}

TEST(Simulate, SaysHowManyFramesItWroteWhenItIsStopped) {
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), words("simulate --log - --seconds 1000000"));
  ASSERT_TRUE(process.waitForReadyRead(60'000));
  ::kill(static_cast<pid_t>(process.processId()), SIGINT);
  ASSERT_TRUE(process.waitForFinished(60'000));
  const Outcome r = deckpipe::test::outcomeOf(process);
  EXPECT_EQ(r.status, 1);
  const QByteArray frames = QByteArray::number(r.out.count('\n'));
  EXPECT_TRUE(r.err.contains("stopped; " + frames + " frames were written to standard output"))
      << r.err.constData();
}

TEST(Streams, ThatAreClosedAreSaidToBe) {
  const auto shell = [](const char* command) {
    QProcess process;
    process.start(
        QStringLiteral("/bin/sh"),
        {QStringLiteral("-c"), QStringLiteral(DECKPIPECTL) + QLatin1Char(' ') + QLatin1String(command)});
    EXPECT_TRUE(process.waitForFinished(60'000));
    return deckpipe::test::outcomeOf(process);
  };
  const Outcome input = shell("decode - <&-");
  EXPECT_EQ(input.status, 3);
  EXPECT_TRUE(input.err.contains("standard input: cannot be read further: Bad file descriptor"))
      << input.err.constData();
  const Outcome output = shell("--version >&-");
  EXPECT_EQ(output.status, 1);
  EXPECT_TRUE(output.err.contains("standard output: Bad file descriptor")) << output.err.constData();
}

TEST(Simulate, MisbehavesFromTheTimeItWasAskedFor) {
  const Outcome r = run(words("simulate --log - --seconds 20 --misbehave monitor:wrong-lengths@10"));
  ASSERT_EQ(r.status, 0);
  const Outcome decoded = run(decode(), r.out);
  bool early = false, late = false;
  for (const QByteArray& line : decoded.lines()) {
    if (!line.contains("\"malformed\"")) continue;
    (QJsonDocument::fromJson(line).object()[QStringLiteral("t")].toDouble() < 1'700'000'010 ? early : late) =
        true;
  }
  EXPECT_FALSE(early);
  EXPECT_TRUE(late);
}

TEST(Simulate, ManyMonitorsEachWithItsPinAndOneGoneForAWhile) {
  const Outcome r =
      run(words("simulate --log - --seconds 12 --monitors 30 --misbehave monitor-30:off=2000@6 "
                "--misbehave monitor-30:elsewhere"));
  ASSERT_EQ(r.status, 0);
  QSet<QString> pins;
  QList<int> addresses;
  for (const QByteArray& line : run(decode(), r.out).lines()) {
    if (!line.contains("\"address_announcement\"")) continue;
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    const QString pin = object[QStringLiteral("fields")][QStringLiteral("pin")].toString();
    pins.insert(pin);
    if (pin == QLatin1String("1032AE100801129")) addresses += object[QStringLiteral("source")].toInt();
  }
  EXPECT_EQ(pins.size(), 32) << "30 monitors, a riser and a joystick; the I/O module has no PIN";
  ASSERT_GE(addresses.size(), 2);
  EXPECT_NE(addresses.last(), addresses[addresses.size() - 2]);
}

TEST(Simulate, ListsEveryMisbehaviourOnRequest) {
  const Outcome r = run(words("simulate --misbehave help"));
  EXPECT_EQ(r.status, 0);
  for (const char* part : {"off[=MS]", "reset-never", "acks-lost[=[K/]N]", "fault=FAULT", "vanish-after=N"})
    EXPECT_TRUE(r.out.contains(part)) << part;
}

TEST(Info, OffersToAddUpTheDifferencesOfCandump) {
  const QByteArray log =
      " (000.000000)  can0  123   [1]  11\n (000.100200)  can0  123   [1]  11\n"
      " (000.099800)  can0  123   [1]  11\n (000.100000)  can0  123   [1]  11\n";
  const Outcome asTheyAre = run(words("info --json -"), log);
  EXPECT_EQ(asTheyAre.status, 0);
  EXPECT_TRUE(asTheyAre.err.contains("--deltas adds them up")) << asTheyAre.err.constData();
  EXPECT_TRUE(asTheyAre.objects()[0][QLatin1String("span")].isNull());
  EXPECT_TRUE(asTheyAre.objects()[0][QLatin1String("delta_times")].toBool());
  EXPECT_TRUE(
      run(words("info -"), log)
          .lines()[1]
          .startsWith("  4 frames over a time that is not known, as their times look like differences"));
  const Outcome added = run(words("info --json --deltas -"), log);
  EXPECT_EQ(added.status, 0);
  EXPECT_TRUE(added.err.isEmpty()) << added.err.constData();
  EXPECT_EQ(added.objects()[0][QLatin1String("span")].toDouble(), 0.3);
  EXPECT_FALSE(added.objects()[0][QLatin1String("delta_times")].toBool());
  EXPECT_EQ(added.objects()[0][QLatin1String("time_jumps")].toInt(), 0);
  EXPECT_TRUE(run(decode({QStringLiteral("--deltas")}), log).lines().last().startsWith("{\"t\":0.300000,"));
}

TEST(Info, CountsOneAsOne) {
  const Outcome r =
      run(words("info --devices -"), "(1.0) can0 18EFFF80#FF83150206021A0B\n(1.0) can0 nonsense\n");
  EXPECT_TRUE(r.out.contains("  1 frame over 0.000000 s on 1 channel\n")) << r.out.constData();
  EXPECT_TRUE(r.out.contains("  1 unreadable line\n")) << r.out.constData();
  EXPECT_TRUE(r.out.contains("address 80  1 frame,")) << r.out.constData();
  EXPECT_FALSE(
      QRegularExpression(QStringLiteral("\\b1 [a-z]+s\\b")).match(QString::fromUtf8(r.out)).hasMatch());
}

TEST(Info, CountsFramesByIdentifierAndUnreadableLines) {
  const Outcome r = run({QStringLiteral("info"), QStringLiteral("--json"), QStringLiteral("-")},
                        kPosition + kPosition + "(1.0) can0 nonsense\n");
  EXPECT_EQ(r.status, 1);
  const QJsonObject object = QJsonDocument::fromJson(r.out).object();
  EXPECT_EQ(object[QStringLiteral("frames")].toInt(), 2);
  EXPECT_EQ(object[QStringLiteral("unreadable")].toInt(), 1);
  EXPECT_EQ(object[QStringLiteral("last_line")].toString(), QStringLiteral("whole"));
  EXPECT_EQ(object[QStringLiteral("ids")].toArray()[0][QStringLiteral("frames")].toInt(), 2);
}

}  // namespace
