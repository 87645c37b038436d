// SPDX-License-Identifier: GPL-3.0-or-later
// `deckpipectl events` as a script meets it: of a log, of a pipe, of a recording.
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <fstream>
#include <memory>

#include "base/event_kind.h"
#include "log/candump.h"
#include "log/journal_writer.h"
#include "log/sidecar.h"
#include "run_ctl.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

using test::Outcome;

Outcome eventsOf(const QByteArray& log, bool asJson = true) {
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), test::words(asJson ? "events --json -" : "events -"));
  process.write(log);
  process.closeWriteChannel();
  EXPECT_TRUE(process.waitForFinished(60'000));
  return test::outcomeOf(process);
}

const QByteArray kStory =
    "(1700000000.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(1700000000.100000) can0 18EFFF80#83C051\n"
    "(1700000000.200000) can0 18EFFF80#834051\n"
    "(1700000000.300000) can0 18EF80F9#02\n"
    "(1700000000.310000) can0 18EFF980#0200200000000B\n"
    "(1700000000.400000) can0 18EFFF80#011D940371400041\n"
    "(1700000000.500000) can0 18EFFF80#011D940371000041\n"
    "(1700000000.600000) can0 18EFFF80#81FC7C038400\n"
    "(1700000000.700000) can0 18EFFF80#81FC7C02BD00\n"
    "(1700000009.000000) can0 18FEF100#FF\n";

TEST(EventsOfTheTool, AreOneObjectALine) {
  const Outcome r = eventsOf(kStory);
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_EQ(
      r.lines(),
      (QList<QByteArray>{
          R"({"event":"disabled","t":1700000000.200000,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"warning","was":true,"now":false})",
          R"({"event":"fault","t":1700000000.310000,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"fault","fault":"internal_fuse"})",
          R"({"event":"error_code","t":1700000000.310000,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"fault","code":11,"was":0,"now":11})",
          R"({"event":"stop_left","t":1700000000.500000,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"info","axis":1,"side":"plus","was":"on","now":"off"})",
          R"({"event":"soft_limit_changed","t":1700000000.700000,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"info","axis":1,"side":"plus","was":90,"now":70.1})",
          R"({"event":"silent","t":1700000003.700000,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"fault","since":1700000000.700000})"}));
}

TEST(EventsOfTheTool, AreLinesForPeople) {
  const Outcome r = eventsOf(kStory, false);
  EXPECT_EQ(r.status, 0);
  ASSERT_EQ(r.lines().size(), 6);
  EXPECT_EQ(r.lines()[0], "       0.200  can0   1032AE100801035  warning  disabled");
  EXPECT_EQ(r.lines()[4],
            "       0.700  can0   1032AE100801035  info     soft limit changed, axis 1 +: 90 -> 70.1");
  EXPECT_EQ(r.lines()[5], "       3.700  can0   1032AE100801035  fault    silent, since 0.700");
}

TEST(EventsOfTheTool, HaveTheirTimesCutToMillisecondsAsInTheWindow) {
  const Outcome r = eventsOf(
      "(1700000000.000000) can0 18EFFF80#83C051\n"
      "(1700000000.199600) can0 18EFFF80#834051\n",
      false);
  ASSERT_EQ(r.lines().size(), 1);
  EXPECT_TRUE(r.lines()[0].startsWith("       0.199  can0 ")) << r.lines()[0].constData();
}

TEST(EventsOfTheTool, HaveNoTimesWhereEveryStampIsZero) {
  const QByteArray log = "(0.000000) can0 18EFFF80#83C051\n(0.000000) can0 18EFFF80#834051\n";
  const Outcome r = eventsOf(log, false);
  ASSERT_EQ(r.lines().size(), 1);
  EXPECT_TRUE(r.lines()[0].startsWith("           -  can0 ")) << r.lines()[0].constData();
  EXPECT_TRUE(eventsOf(log).out.contains(R"("t":null)"));
}

TEST(EventsOfTheTool, HaveTheTimesThatTheFramesHaveWhereTheClockWasSetBack) {
  const Outcome r = eventsOf(
      "(1700000000.0) can0 18EFFF80#83C051\n(1700000001.0) can0 18EFFF80#83C051\n"
      "(1699996402.0) can0 18EFFF80#83C051\n(1699996403.0) can0 18EFFF80#834051\n"
      "(1699996410.0) can0 18FEF100#FF\n");
  QStringList told;
  for (const QJsonObject& event : r.objects())
    told << event[QStringLiteral("event")].toString() + QLatin1Char(' ') +
                QString::number(event[QStringLiteral("t")].toDouble(), 'f', 1);
  EXPECT_EQ(told,
            (QStringList{QStringLiteral("clock_jump 1699996402.0"), QStringLiteral("disabled 1699996403.0"),
                         QStringLiteral("silent 1699996406.0")}));
  EXPECT_TRUE(r.out.contains(R"("since":1699996403.000000)")) << r.out.constData();
}

TEST(EventsOfTheTool, TellTwoDevicesAtOneAddress) {
  QByteArray log =
      "(1700000000.000000) can0 18EEFF80#0B1AC22800420090\n"
      "(1700000000.001000) can0 18EFFF80#FF83150206021A0B\n"
      "(1700000000.500000) can0 18EEFF80#0C1AC22800420090\n"
      "(1700000000.501000) can0 18EFFF80#FF83150206021A0C\n";
  for (int i = 0; i < 8; ++i)
    log += QByteArray("(1700000000.") + QByteArray::number(600 + 50 * i) + "000) can0 18EFFF80#" +
           (i % 2 == 0 ? "011D9412C4000041\n" : "0112C10644000041\n");
  const auto events = eventsOf(log).objects();
  const auto shared = std::ranges::find_if(events, [](const QJsonObject& event) {
    return event[QStringLiteral("event")].toString() == QStringLiteral("two_at_one_address");
  });
  ASSERT_NE(shared, events.end());
  EXPECT_EQ((*shared)[QStringLiteral("address")].toInt(), 128);
  EXPECT_EQ((*shared)[QStringLiteral("pin")].toString(), QStringLiteral("1032AE100801036"));
  EXPECT_EQ((*shared)[QStringLiteral("other_pin")].toString(), QStringLiteral("1032AE100801035"));
  EXPECT_EQ((*shared)[QStringLiteral("weight")].toString(), QStringLiteral("fault"));
}

const QByteArray kTimeless =
    "  can0  18EFFF80   [8]  FF 83 15 02 06 02 1A 0B\n"
    "  can0  18EFFF80   [3]  83 C0 51\n"
    "  can0  18EFFF80   [3]  83 40 51\n";

TEST(EventsOfTheTool, HaveNoTimeInALogWithoutTimes) {
  EXPECT_EQ(
      eventsOf(kTimeless).lines(),
      (QList<QByteArray>{
          R"({"event":"disabled","t":null,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"warning","was":true,"now":false})"}));
  EXPECT_EQ(eventsOf(kTimeless, false).lines(),
            (QList<QByteArray>{"           -  can0   1032AE100801035  warning  disabled"}));
}

TEST(EventsOfTheTool, HaveNoTimeWhereTimesAreDifferences) {
  QByteArray log = "(0.000000) can0 18EFFF80#FF83150206021A0B\n";
  for (int i = 0; i < 200; ++i) {
    log += i % 9 == 8 ? "(5.100000) " : "(0.010000) ";
    log += i < 100 ? "can0 18EFFF80#83C051\n" : "can0 18EFFF80#834051\n";
  }
  const Outcome r = eventsOf(log);
  EXPECT_EQ(r.status, 0);
  EXPECT_TRUE(r.err.contains("--deltas adds them up")) << r.err.constData();
  EXPECT_EQ(
      r.lines(),
      (QList<QByteArray>{
          R"({"event":"disabled","t":null,"channel":"can0","pin":"1032AE100801035","address":128,"weight":"warning","was":true,"now":false})"}));
}

TEST(EventsOfTheTool, SayOnceThatTimesAreGoodToTheSecond) {
  QByteArray log;
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 50; ++k)
      log += "(17000000" + QByteArray::number(10 + i) + ") can0 0CFDD633#0100010000000000\n";
  const Outcome r = eventsOf(log);
  EXPECT_EQ(r.status, 0);
  EXPECT_EQ(r.out, QByteArray());
  EXPECT_EQ(r.err.count("good to the second only"), 1) << r.err.constData();
}

TEST(EventsOfTheTool, SayWhatIsNotFollowed) {
  QByteArray devices, channels;
  for (int i = 0; i < 90; ++i) {
    const QByteArray address = QByteArray::number(0x80 + i, 16).toUpper();
    devices +=
        "(1700000000.0" + QByteArray::number(10 + i) + ") can0 18EFFF" + address + "#011D940371000041\n";
  }
  for (int i = 0; i < 18; ++i)
    channels += "(1700000000.0" + QByteArray::number(10 + i) + ") can" + QByteArray::number(i) + " 123#11\n";
  for (const auto& [log, words] : {std::pair(devices, "10 frames of devices beyond the first 80"),
                                   std::pair(channels, "2 frames on channels beyond the first 16")}) {
    const Outcome r = eventsOf(log);
    EXPECT_EQ(r.status, 1);
    EXPECT_TRUE(r.err.contains(words)) << r.err.constData();
  }
}

TEST(EventsOfTheTool, SayLongTimesInWordsForPeople) {
  const Outcome r = eventsOf(
      "(1700000000.000000) can0 18EFFF80#FF83150206021A0B\n"
      "(1700000000.100000) can0 18EFFF80#83C051\n"
      "(1700003500.000000) can0 18EFFF80#83C051\n"
      "(1700003500.100000) can0 18EFFF80#83C051\n",
      false);
  ASSERT_EQ(r.lines().size(), 2) << r.out.constData();
  EXPECT_TRUE(r.lines()[1].endsWith("back, after 58 min 19 s")) << r.out.constData();
}

TEST(EventsOfTheTool, NameTheRateOfALoad) {
  QByteArray log = "(1700000000.000000) can0 18EFFF80#FF83150206021A0B\n";
  for (int i = 0; i < 5'000; ++i)
    log += "(170000000" + QByteArray::number(i * 600 / 1'000'000) + "." +
           QByteArray::number(i * 600 % 1'000'000).rightJustified(6, '0') +
           ") can0 18FEF100#1122334455667788\n";
  const Outcome json = eventsOf(log);
  ASSERT_FALSE(json.lines().isEmpty());
  EXPECT_EQ(json.objects()[0][QStringLiteral("event")].toString(), QStringLiteral("load_high"));
  EXPECT_EQ(json.objects()[0][QStringLiteral("bit_rate")].toInt(), 250'000);
  EXPECT_TRUE(json.objects()[0][QStringLiteral("rate_assumed")].toBool());
  EXPECT_TRUE(eventsOf(log, false).lines()[0].endsWith(" % of 250 kbit/s, which is assumed"));
}

TEST(EventsOfTheTool, EndWithTheStatusOfWhatReadsFiles) {
  EXPECT_EQ(eventsOf({}).status, 4);
  EXPECT_EQ(eventsOf("no log\n").status, 3);
  const Outcome r = eventsOf(kStory + "no frame\n");
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.lines().size(), 6);
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), test::words("events"));
  ASSERT_TRUE(process.waitForFinished(60'000));
  EXPECT_EQ(test::outcomeOf(process).status, 2);
}

TEST(EventsOfTheTool, AreAllNamedByHelp) {
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), test::words("events --help"));
  ASSERT_TRUE(process.waitForFinished(60'000));
  const QByteArray help = test::outcomeOf(process).out;
  for (const EventFacts& facts : kEvents)
    EXPECT_TRUE(help.contains("  " + QByteArray(facts.key.data(), static_cast<int>(facts.key.size())) + " "))
        << facts.key;
}

// The silence falls due between the last frame and the last note.
TEST(EventsOfTheTool, GoOnBehindTheLastFrameAndHaveTheNotesOfASidecarAmongThem) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("one.log"));
  std::string log;
  FrameStore frames;
  const std::uint8_t channel = frames.channel("can0");
  SidecarMaker sidecar;
  sidecar.channel("can0");
  for (int i = 0; i < 20; ++i) {
    const Frame frame =
        test::frame("18EFFF80", "83C051", channel, (1000 + 100 * i) * std::int64_t{1'000'000});
    ASSERT_TRUE(frames.append({&frame, 1}));
    writeCandump(frame, "can0", log);
    sidecar.frame(frame, frames.timeAt(frames.count() - 1));
  }
  sidecar.note({.frame = 20, .time = frames.timeAt(19) + 1s, .value = note::Mark{"valve\n\x1B[2J"}});
  sidecar.note({.frame = 20, .time = frames.timeAt(19) + 60s, .value = note::LinkDown{}});
  std::ofstream(path.toStdString()) << log;
  std::ofstream(sidecarPath(path.toStdString())) << sidecar.text();
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), {QStringLiteral("events"), path});
  ASSERT_TRUE(process.waitForFinished(60'000));
  const Outcome r = test::outcomeOf(process);
  EXPECT_EQ(r.status, 0) << r.err.constData();
  EXPECT_EQ(r.out.toStdString(),
            "       2.900  -      -                info     mark: valve\\x0A\\x1B[2J\n"
            "       4.900  can0   80               fault    silent, since 1.900\n"
            "      61.900  can0   -                info     link down\n");
}

TEST(EventsOfTheTool, AreNeitherSilencesOfALogSavedThroughAFilterNorFramesThatWereAdded) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("part.log"));
  std::string log;
  FrameStore frames;
  const std::uint8_t channel = frames.channel("can0");
  SidecarMaker sidecar;
  sidecar.channel("can0");
  sidecar.note({.frame = 0, .time = {1'000'000'000}, .value = note::Filtered{"name~outputs"}});
  sidecar.note({.frame = 0, .time = {1'000'000'000}, .value = note::Added{1}});
  for (int i = 0; i < 20; ++i) {
    const Frame frame = i == 0 ? test::frame("18EFFF80", "FF83150206021A0B", channel, 1'000'000'000)
                               : test::frame("18EFFF80", "83C051", channel, (1 + 5 * i) * 1'000'000'000LL);
    ASSERT_TRUE(frames.append({&frame, 1}));
    writeCandump(frame, "can0", log);
    sidecar.frame(frame, frames.timeAt(frames.count() - 1));
  }
  std::ofstream(path.toStdString()) << log;
  std::ofstream(sidecarPath(path.toStdString())) << sidecar.text();
  const auto run = [&](const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral(DECKPIPECTL), arguments);
    EXPECT_TRUE(process.waitForFinished(60'000));
    return test::outcomeOf(process);
  };
  const Outcome events = run({QStringLiteral("events"), path});
  EXPECT_EQ(events.status, 0);
  EXPECT_EQ(events.out.toStdString(),
            "       0.000  -      -                warning  filtered: name~outputs\n");
  EXPECT_TRUE(events.err.contains("saved through the filter 'name~outputs'")) << events.err.constData();
  const Outcome info = run({QStringLiteral("info"), QStringLiteral("--devices"), path});
  EXPECT_EQ(info.status, 0);
  EXPECT_TRUE(info.out.contains("saved through the filter 'name~outputs': what did not pass it is missing"))
      << info.out.constData();
  EXPECT_TRUE(info.out.contains(", filtered\n")) << info.out.constData();
  const QJsonObject object =
      run({QStringLiteral("info"), QStringLiteral("--json"), QStringLiteral("--devices"), path}).objects()[0];
  EXPECT_EQ(object[QStringLiteral("filters")].toArray(), QJsonArray{QStringLiteral("name~outputs")});
  EXPECT_EQ(object[QStringLiteral("devices")].toArray()[0].toObject()[QStringLiteral("health")].toString(),
            QStringLiteral("filtered"));
}

TEST(InfoOfTheTool, SaysWhoWasAtAnAddressBeforeTheLinkWasDownAndWhenAndWhyItWas) {
  const QTemporaryDir folder;
  FrameStore frames;
  NoteStore notes;
  frames.channel("can0");
  const auto hear = [&](const char* data, std::int64_t ms, const char* id = "18EFFF80") {
    const Frame frame = test::frame(id, data, 0, ms * 1'000'000);
    ASSERT_TRUE(frames.append({&frame, 1}));
  };
  hear("FF83150206021A0B", 1000);
  hear("03010B02040206", 1000, "18EF0580");
  notes.append(
      {.frame = 2, .time = {1'100'000'000}, .value = note::LinkDown{{}, LinkFault::Gone, "Network is down"}});
  notes.append({.frame = 2, .time = {9'000'000'000}, .value = note::LinkUp{}});
  hear("83C051", 9100);
  {
    JournalWriter writer(
        frames, notes,
        [&] { return createJournalFile(folder.filePath(QStringLiteral("one")).toStdString()); },
        [] { return JournalHead{.begin = 1'796'000'000'000'000'000}; });
    writer.timeCame({});
    writer.end();
  }
  const auto told = [&](const QStringList& arguments) {
    QProcess process;
    process.start(QStringLiteral(DECKPIPECTL),
                  arguments + QStringList{folder.filePath(QStringLiteral("one.deckpipe"))});
    EXPECT_TRUE(process.waitForFinished(60'000));
    return test::outcomeOf(process).out;
  };
  EXPECT_TRUE(
      told({QStringLiteral("info"), QStringLiteral("--devices")})
          .contains(
              "no PIN           monitor  was 1032AE100801035 before the link went down  can0  address 80"));
  EXPECT_TRUE(told({QStringLiteral("info"), QStringLiteral("--devices"), QStringLiteral("--json")})
                  .contains("\"pin\":null,\"former_pin\":\"1032AE100801035\""));
  EXPECT_TRUE(told({QStringLiteral("info"), QStringLiteral("--devices"), QStringLiteral("--json")})
                  .contains("\"system_age\":8.1,\"system_old\":\"gap\""))
      << told({QStringLiteral("info"), QStringLiteral("--devices"), QStringLiteral("--json")}).toStdString();
  EXPECT_TRUE(told({QStringLiteral("info")})
                  .contains("  link of can0 down for 7.9 s from 100 ms on: the adapter is gone (Network is "
                            "down)\n"))
      << told({QStringLiteral("info")}).toStdString();
  EXPECT_TRUE(
      told({QStringLiteral("events")}).contains("link down: the adapter is gone (Network is down)\n"));
  const QByteArray json = told({QStringLiteral("info"), QStringLiteral("--json")});
  EXPECT_TRUE(json.contains("\"link_gaps\":[{\"channel\":\"can0\",\"from\":")) << json.toStdString();
  EXPECT_TRUE(json.contains("\"reason\":\"gone\",\"words\":\"Network is down\"}]")) << json.toStdString();
  EXPECT_TRUE(told({QStringLiteral("decode")}).contains("\"family\":\"presumed\""));
}

TEST(EventsOfTheTool, HaveTheNotesOfARecordingAmongThem) {
  const QTemporaryDir folder;
  FrameStore frames;
  NoteStore notes;
  frames.channel("can0");
  const auto hear = [&](const char* data, std::int64_t ms) {
    const Frame frame = test::frame("18EFFF80", data, 0, ms * 1'000'000);
    ASSERT_TRUE(frames.append({&frame, 1}));
  };
  notes.append({.frame = 0, .time = {1'000'000'000}, .value = note::LinkUp{}});
  hear("83C051", 1000);
  notes.append({.frame = 1, .time = {1'200'000'000}, .value = note::Mark{"valve opened"}});
  hear("834051", 1500);
  notes.append({.frame = 2, .time = {1'500'000'000}, .value = note::Dropped{{}, 7}});
  {
    JournalWriter writer(
        frames, notes,
        [&] { return createJournalFile(folder.filePath(QStringLiteral("one")).toStdString()); },
        [] { return JournalHead{.begin = 1'796'000'000'000'000'000}; });
    writer.timeCame({});
    writer.end();
  }
  QProcess process;
  process.start(QStringLiteral(DECKPIPECTL), {QStringLiteral("events"), QStringLiteral("--json"),
                                              folder.filePath(QStringLiteral("one.deckpipe"))});
  ASSERT_TRUE(process.waitForFinished(60'000));
  const Outcome r = test::outcomeOf(process);
  EXPECT_EQ(r.status, 0) << r.err.constData();
  QStringList keys;
  for (const QJsonObject& event : r.objects()) keys << event[QStringLiteral("event")].toString();
  EXPECT_EQ(keys.join(QLatin1Char(' ')).toStdString(), "link_up mark disabled dropped");
  EXPECT_EQ(r.objects()[1][QStringLiteral("text")].toString(), QStringLiteral("valve opened"));
  EXPECT_EQ(r.objects()[3][QStringLiteral("frames")].toInt(), 7);
}

}  // namespace
}  // namespace deckpipe
