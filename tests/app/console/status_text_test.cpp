// SPDX-License-Identifier: GPL-3.0-or-later
// Every state of a source in words: the strip's facts and the notice above the work.
#include "console/status_text.h"

#include <gtest/gtest.h>

#include <set>

#include "app/console/window_scenes.h"
#include "console/notice_of.h"
#include "support/logs.h"

namespace deckpipe {
namespace {

using From = SourceStatus::Kind;
using Progress = SourceStatus::Progress;
using test::logOfText;
using test::viewOf;

constexpr auto kTruck =
    "(10.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(10.100000) can0 18EFFF80#011D940371000041\n";

Snapshot snapshotOf(const char* text, From kind, Progress progress) {
  Snapshot snapshot;
  const auto log = logOfText(text);
  snapshot.view = viewOf(log);
  auto state = std::make_shared<State>();
  advance(*state, log->frames, log->notes, snapshot.view.cursor);
  snapshot.view.state = state;
  snapshot.source.kind = kind;
  snapshot.source.progress = progress;
  snapshot.source.name =
      kind == From::File ? QStringLiteral("/logs/truck.log") : QStringLiteral("socketcan can0");
  snapshot.source.plugin = QStringLiteral("socketcan");
  snapshot.source.interfaceName = QStringLiteral("can0");
  if (kind == From::Link) snapshot.source.bitRate = 250'000;
  return snapshot;
}

Snapshot link(Progress progress, const char* text = kTruck) { return snapshotOf(text, From::Link, progress); }
Snapshot file(const char* text, Progress progress = Progress::Done) {
  return snapshotOf(text, From::File, progress);
}

std::string notice(const Snapshot& snapshot) {
  return noticeOf(snapshot, ratesAt(snapshot.view)).text.toStdString();
}
bool says(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

TEST(RecordingFact, IsSaidOnlyWhileAFileGrows) {
  const JournalStatus growing{.path = "/data/2026-11-28_14-03-22.deckpipe", .frames = 2, .bytes = 100};
  JournalStatus full = growing, ended = growing, none;
  full.fault = {JournalFault::Kind::DiskFull, "No space left on device"};
  ended.isEnded = true;
  none.fault = {JournalFault::Kind::CannotCreate, "Permission denied"};
  struct Row {
    const char* name;
    Progress progress;
    std::optional<JournalStatus> recording;
    const char* text;
    Severity tone;
    const char* story;
  };
  for (const Row& row :
       {Row{"growing", Progress::Running, growing, "Recording 0:00:00 · 2 frames", Severity::Plain,
            "/data/2026-11-28_14-03-22.deckpipe"},
        Row{"no frame yet", Progress::Running, JournalStatus{}, "Recorded ", Severity::Plain, "in memory"},
        Row{"no folder", Progress::Running, {}, "Recorded ", Severity::Plain, "in memory"},
        Row{"link lost", Progress::Lost, growing, "Recorded ", Severity::Plain, "/data/"},
        Row{"ended", Progress::Running, ended, "Recorded ", Severity::Plain, "in memory"},
        Row{"disk full", Progress::Running, full, "Not recorded: disk full", Severity::Fault,
            "No space left on device"},
        Row{"no file", Progress::Running, none, "Not recorded", Severity::Fault, "Permission denied"}}) {
    SCOPED_TRACE(row.name);
    Snapshot snapshot = link(row.progress);
    snapshot.source.recording = row.recording;
    const StatusFact fact = recordingFact(snapshot);
    EXPECT_TRUE(says(fact.text.toStdString(), row.text)) << fact.text.toStdString();
    EXPECT_EQ(fact.tone, row.tone);
    EXPECT_TRUE(says(fact.story.toStdString(), row.story)) << fact.story.toStdString();
    EXPECT_EQ(says(notice(snapshot), "kept in memory only"), row.tone == Severity::Fault);
    EXPECT_EQ(completenessFact(snapshot).text == QStringLiteral("In memory only"),
              row.tone == Severity::Fault);
  }
}

TEST(RecordingFact, SaysWhatBecameOfAFileThatWasTakenAway) {
  Snapshot snapshot = link(Progress::Running);
  JournalStatus& recording = snapshot.source.recording.emplace();
  recording.fault = {JournalFault::Kind::Removed, "/data/1.deckpipe"};
  EXPECT_TRUE(says(notice(snapshot), "/data/1.deckpipe was removed while")) << notice(snapshot);
  EXPECT_EQ(recordingFact(snapshot).text.toStdString(), "Not recorded");
  recording = {.path = "/data/2.deckpipe", .frames = 2, .givenUp = recording.fault};
  snapshot.givenUpFile = recording.givenUp;
  EXPECT_TRUE(says(notice(snapshot), "/data/1.deckpipe was removed")) << notice(snapshot);
  EXPECT_TRUE(says(notice(snapshot), "goes on in /data/2.deckpipe")) << notice(snapshot);
  snapshot.givenUpFile.reset();
  EXPECT_EQ(notice(snapshot), "");
  const std::string story = recordingFact(snapshot).story.toStdString();
  EXPECT_TRUE(says(story, "/data/1.deckpipe was removed")) << story;
  EXPECT_TRUE(says(story, "/data/2.deckpipe")) << story;
}

TEST(RecordingNotice, SaysWhatIsMissingOfAFile) {
  Snapshot snapshot = file(kTruck);
  snapshot.source.read.isOpenEnded = true;
  EXPECT_TRUE(says(notice(snapshot), "last second may be missing"));
  snapshot.source.read.goesOn = true;
  EXPECT_TRUE(says(notice(snapshot), "still goes on"));
  EXPECT_EQ(completenessFact(snapshot).text.toStdString(), "Not whole");
  snapshot.source.read.cutBytes = 37;
  EXPECT_TRUE(says(notice(snapshot), "last 37 bytes")) << notice(snapshot);
  EXPECT_EQ(completenessFact(snapshot).text.toStdString(), "Not whole");
  snapshot.source.read.damage = {.places = 2, .bytes = 1'000, .firstAt = 4'711, .frames = 33};
  for (const char* words : {"damaged in 2 places", "byte 4711", "1000 bytes", "33 frames", "last 37 bytes"})
    EXPECT_TRUE(says(notice(snapshot), words)) << notice(snapshot);
  EXPECT_FALSE(says(notice(snapshot), "before them")) << notice(snapshot);
  EXPECT_EQ(completenessFact(snapshot).text.toStdString(), "Not whole");
  snapshot.source.read.damage = {.places = 1, .bytes = 100, .isOpen = true};
  EXPECT_TRUE(says(notice(snapshot), "How many frames are missing at its end is not known"))
      << notice(snapshot);
  snapshot.source.read = {.newerParts = 2};
  EXPECT_TRUE(says(notice(snapshot), "newer version")) << notice(snapshot);
}

TEST(FileNotice, SaysAllThatIsMissingOfAFileOneLineEachTheWorstFirst) {
  Snapshot snapshot = file("(91.5) can0 123#11\nrubbish\n(92.5) can0 123##011\n(1.1) can0 123#11\n");
  snapshot.source.unreadable = 1;
  snapshot.source.read = {
      .sidecarFault = SidecarFault{.kind = SidecarFault::Kind::Cut, .path = "truck.log.notes"},
      .lastLine = LastLine::Open,
      .newerParts = 2,
      .isOpenEnded = true,
      .damage = {.places = 1}};
  const_cast<LogDocument&>(*snapshot.view.document).notes.append({.value = note::Filtered{"sa=80"}});
  const QStringList lines = QString::fromStdString(notice(snapshot)).split(QLatin1Char('\n'));
  const std::vector<const char*> words{"damaged",
                                       "line 2: ",
                                       "1 CAN FD frame",
                                       "newer version",
                                       "marks, notes and labels",
                                       "no end",
                                       "saved through the filter",
                                       "goes back at frame 2",
                                       "no line end"};
  ASSERT_EQ(lines.size(), static_cast<qsizetype>(words.size())) << notice(snapshot);
  for (std::size_t i = 0; i < words.size(); ++i)
    EXPECT_TRUE(says(lines[static_cast<qsizetype>(i)].toStdString(), words[i]))
        << words[i] << notice(snapshot);
  const Notice all = noticeOf(snapshot, ratesAt(snapshot.view));
  EXPECT_EQ(all.action, Notice::Action::CopyDetails);
  EXPECT_TRUE(says(all.details.toStdString(), "line 2: "));
  EXPECT_EQ(all.tone, Severity::Warning);
}

TEST(SourceFact, NamesTheLinkItsRateAndItsState) {
  SourceStatus source = link(Progress::Running).source;
  EXPECT_EQ(sourceFact(source).text.toStdString(), "can0 · 250 kbit/s – connected");
  EXPECT_EQ(sourceFact(source).tone, Severity::Fine);
  source.isListenOnly = true;
  EXPECT_EQ(sourceFact(source).text.toStdString(), "can0 · 250 kbit/s – connected, listen-only");
  source.controller = ControllerState::BusOff;
  EXPECT_EQ(sourceFact(source).text.toStdString(), "can0 · 250 kbit/s – bus-off");
  EXPECT_EQ(sourceFact(source).tone, Severity::Fault);
}

TEST(NoticeText, SaysThatNothingWasSentAndWhy) {
  Snapshot snapshot = link(Progress::Running);
  snapshot.view.atEnd = false;
  snapshot.notSent = Refusal::NotLive;
  EXPECT_TRUE(says(notice(snapshot), "Nothing was sent. The view stands in the past"));
  EXPECT_EQ(noticeOf(snapshot, {}).action, Notice::Action::GoToEnd);
  snapshot.notSent = Refusal::LogFull;
  EXPECT_TRUE(says(notice(snapshot), "what is not recorded is not sent"));
  snapshot = {};
  snapshot.notSent = Refusal::NoLink;
  EXPECT_TRUE(says(noticeOf(snapshot, {}).text.toStdString(), "Nothing was sent. The link is not up"));
}

// Whatever else is to be said, the worst of it is said first, and its way out is offered.
TEST(NoticeOf, OfEachTwoTheWorseShows) {
  struct Row {
    const char* name;
    void (*apply)(Snapshot&);
  };
  const Row worstFirst[] = {
      {"link lost", [](Snapshot& s) { s.source.progress = Progress::Lost; }},
      {"recording fault",
       [](Snapshot& s) {
         s.source.recording = JournalStatus{.path = "/data/1.deckpipe",
                                            .fault = {JournalFault::Kind::DiskFull, "No space left"}};
       }},
      {"fault of the recording that was left",
       [](Snapshot& s) {
         s.leftRecording = JournalStatus{.fault = {JournalFault::Kind::CannotCreate, "Permission denied"}};
       }},
      {"log that cannot be read",
       [](Snapshot& s) {
         s.notOpened = NotOpened{QStringLiteral("/logs/binary.log"), ReadError{}};
       }},
      {"nothing was sent", [](Snapshot& s) { s.notSent = Refusal::NotLive; }},
      {"file of the recording given up",
       [](Snapshot& s) {
         s.givenUpFile = JournalFault{JournalFault::Kind::Removed, "/data/0.deckpipe"};
         if (!s.source.recording) s.source.recording.emplace().path = "/data/1.deckpipe";
       }},
      {"catching up", [](Snapshot& s) { s.isCatchingUp = true; }},
      {"paused",
       [](Snapshot& s) {
         s.view.atEnd = false;
         s.view.end = s.view.cursor.time + 65s;
       }},
      {"nothing heard",
       [](Snapshot& s) {
         s.view.cursor.time = s.view.cursor.time + 7s;
         s.view.end = s.view.end + 7s;
       }},
      {"recording that was left",
       [](Snapshot& s) {
         if (!s.leftRecording) s.leftRecording = JournalStatus{.path = "/data/0.deckpipe"};
       }},
  };
  constexpr std::size_t kRows = std::size(worstFirst);
  for (std::size_t worse = 0; worse < kRows; ++worse) {
    Snapshot alone = link(Progress::Running);
    worstFirst[worse].apply(alone);
    const Notice wanted = noticeOf(alone, ratesAt(alone.view));
    ASSERT_FALSE(wanted.text.isEmpty()) << worstFirst[worse].name;
    for (std::size_t lesser = worse + 1; lesser < kRows; ++lesser) {
      SCOPED_TRACE(std::string(worstFirst[worse].name) + ", " + worstFirst[lesser].name);
      Snapshot both = alone;
      worstFirst[lesser].apply(both);
      const Notice said = noticeOf(both, ratesAt(both.view));
      EXPECT_TRUE(said.text.startsWith(wanted.text)) << said.text.toStdString();
      EXPECT_EQ(said.tone, wanted.tone);
      EXPECT_EQ(said.action, wanted.action);
    }
  }
}

TEST(NoticeOf, SaysBesideAFaultWhatCameOfTheLastDeed) {
  Snapshot snapshot = link(Progress::Lost);
  snapshot.notOpened = NotOpened{QStringLiteral("/logs/binary.log"), ReadError{}};
  const Notice said = noticeOf(snapshot, {});
  EXPECT_TRUE(says(said.text.toStdString(), "is lost")) << said.text.toStdString();
  EXPECT_TRUE(says(said.text.toStdString(), "binary.log cannot be read")) << said.text.toStdString();
  EXPECT_EQ(said.action, Notice::Action::Reconnect);
  EXPECT_TRUE(said.canClose);
}

TEST(NoticeOf, SaysThatTheStateAtTheCursorIsStillBeingFound) {
  Snapshot snapshot;
  snapshot.source.kind = SourceStatus::Kind::File;
  snapshot.source.progress = SourceStatus::Progress::Done;
  snapshot.view = test::viewOf(test::logOfText("(10.000000) can0 18EFFF80#011D940371000041\n"));
  const Notice before = noticeOf(snapshot, {});
  snapshot.isCatchingUp = true;
  EXPECT_TRUE(says(noticeOf(snapshot, {}).text.toStdString(), "do not show the place of the cursor yet"));
  EXPECT_NE(noticeOf(snapshot, {}), before);
}

TEST(SourceFact, NamesALogByItsFile) {
  const StatusFact fact = sourceFact(file(kTruck).source);
  EXPECT_EQ(fact.text.toStdString(), "truck.log");
  EXPECT_TRUE(says(fact.story.toStdString(), "/logs/truck.log"));
}

TEST(LoadFact, ReckonsTheBusiestBusOfTheLastSecond) {
  // 100 frames of 131 + 14 bits in a second of 250,000.
  std::string text;
  for (int i = 0; i < 101; ++i) {
    char line[64];
    std::snprintf(line, sizeof line, "(%d.%02d0000) can0 18EFFF80#011D940371000041\n", 10 + i / 100, i % 100);
    text += line;
  }
  const Snapshot snapshot = link(Progress::Running, text.c_str());
  const BusRates rates = ratesAt(snapshot.view);
  EXPECT_DOUBLE_EQ(rates.framesASecond, 100);
  EXPECT_EQ(loadFact(snapshot, rates).text.toStdString(), "Load 6 %");
  EXPECT_EQ(rateFact(rates).text.toStdString(), "100 frames/s");
}

TEST(LoadFact, SaysThatALogDoesNotTellItsBitRate) {
  const Snapshot snapshot = file(kTruck);
  EXPECT_TRUE(says(loadFact(snapshot, {}).story.toStdString(), "does not say its bit rate"));
}

// The same 100 frames a second, or 4,000, of which 250 kbit/s carry no half.
std::string framesAt(int framesASecond) {
  std::string text;
  for (int i = 0; i <= framesASecond; ++i) {
    char line[64];
    const long us = 10'000'000L + 1'000'000L * i / framesASecond;
    std::snprintf(line, sizeof line, "(%ld.%06ld) can0 18EFFF80#011D940371000041\n", us / 1'000'000,
                  us % 1'000'000);
    text += line;
  }
  return text;
}

TEST(LoadFact, NamesTheRateThatItAssumesOfALog) {
  const Snapshot snapshot = file(framesAt(100).c_str());
  EXPECT_EQ(loadFact(snapshot, ratesAt(snapshot.view)).text.toStdString(), "Load 6 % if 250 kbit/s");
}

TEST(LoadFact, IsOfTheRateThatTheLogSays) {
  Snapshot snapshot = file(framesAt(1'000).c_str());
  State state = *snapshot.view.state;
  state.apply({.frame = 0, .time = {}, .value = note::LinkUp{{0}, "socketcan can0, 500 kbit/s", 500'000}});
  snapshot.view.state = std::make_shared<State>(state);
  const StatusFact fact = loadFact(snapshot, ratesAt(snapshot.view));
  EXPECT_EQ(fact.text.toStdString(), "Load 29 %");
  EXPECT_TRUE(says(fact.story.toStdString(), "of 500 kbit/s"));
  EXPECT_FALSE(says(fact.story.toStdString(), "does not say"));
}

TEST(LoadFact, IsUnknownWhereMoreWasSentThanTheAssumedRateAllows) {
  const Snapshot snapshot = file(framesAt(4'000).c_str());
  const StatusFact fact = loadFact(snapshot, ratesAt(snapshot.view));
  EXPECT_EQ(fact.text.toStdString(), "Load –");
  EXPECT_EQ(fact.tone, Severity::Plain);
  EXPECT_TRUE(says(fact.story.toStdString(), "more was sent than 250 kbit/s allow"));
}

TEST(LockFact, SaysThatNothingIsSent) {
  Snapshot snapshot = link(Progress::Running);
  const StatusFact fact = lockFact(snapshot);
  EXPECT_EQ(fact.text.toStdString(), "Transmit locked");
  EXPECT_EQ(fact.glyph, Glyph::Locked);
  EXPECT_TRUE(says(fact.story.toStdString(), "still acknowledges"));
  ServiceStatus unlocked;
  unlocked.locked = false;
  snapshot.services = std::make_shared<const ServiceStatus>(unlocked);
  EXPECT_EQ(lockFact(snapshot).text.toStdString(), "Unlocked, no address");
  EXPECT_EQ(lockFact(snapshot).tone, Severity::Warning);
}

TEST(LockFact, SaysThatALockIsNotCompleteYet) {
  Snapshot snapshot = link(Progress::Running);
  ServiceStatus services;
  services.locked = false;
  services.isEnding = true;
  snapshot.services = std::make_shared<const ServiceStatus>(services);
  EXPECT_EQ(lockFact(snapshot).text.toStdString(), "Locking …");
}

// A state of the services, what the strip says of it and how.
struct SentRow {
  const char* name;
  void (*set)(ServiceStatus& services);
  const char* text;
  Severity tone;
  const char* story;
};
void PrintTo(const SentRow& row, std::ostream* out) { *out << row.name; }

class SentFact : public ::testing::TestWithParam<SentRow> {};

TEST_P(SentFact, SaysWhatIsNotOnTheBus) {
  Snapshot snapshot = link(Progress::Running);
  ServiceStatus services;
  services.locked = false;
  GetParam().set(services);
  snapshot.services = std::make_shared<const ServiceStatus>(services);
  const StatusFact fact = sentFact(snapshot);
  EXPECT_EQ(fact.text.toStdString(), GetParam().text);
  EXPECT_EQ(fact.tone, GetParam().tone);
  EXPECT_TRUE(says(fact.story.toStdString(), GetParam().story));
}

INSTANTIATE_TEST_SUITE_P(
    Rows, SentFact,
    ::testing::Values(SentRow{"AllWell", [](ServiceStatus&) {}, "", Severity::Plain, ""},
                      SentRow{"CannotTell", [](ServiceStatus& s) { s.echoes = false; },
                              "On the bus: cannot tell", Severity::Unknown, "does not tell whether"},
                      SentRow{"LockedItIsNoQuestion",
                              [](ServiceStatus& s) {
                                s.echoes = false;
                                s.locked = true;
                              },
                              "", Severity::Plain, ""},
                      SentRow{"Refused", [](ServiceStatus& s) { s.notTaken = 2; }, "2 frames not sent",
                              Severity::Warning, "2 frames were not taken by the adapter"},
                      SentRow{"Waiting",
                              [](ServiceStatus& s) {
                                s.unconfirmed = 3;
                                s.notTaken = 1;
                              },
                              "3 frames not on the bus yet", Severity::Fault,
                              "may still go out, after a lock too"},
                      SentRow{"ACommandAfterALock",
                              [](ServiceStatus& s) {
                                s.locked = true;
                                s.unconfirmed = 1;
                                s.waitingCommands.push_back({DeviceKey::of(*Pin::parse("1032AE100801035")),
                                                             Request::Reset, Instant{}});
                              },
                              "Reset: not on the bus yet", Severity::Fault, "Reset of 1032AE100801035"},
                      SentRow{"Commands", [](ServiceStatus& s) { s.waitingCommands.resize(2); },
                              "2 commands not on the bus yet", Severity::Fault, ""}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(SentFact, GoesOnToSayWhatWaitedWhenTheLinkWasLeft) {
  const DeviceKey monitor = DeviceKey::of(*Pin::parse("1032AE100801035"));
  for (Snapshot snapshot : {Snapshot{}, link(Progress::Running)}) {
    snapshot.leftWaiting = LeftWaiting{QStringLiteral("can1"), 3, {{monitor, Request::Reset, Instant{}}}};
    const StatusFact fact = sentFact(snapshot);
    EXPECT_EQ(fact.text, QStringLiteral("3 frames may still go out"));
    EXPECT_EQ(fact.tone, Severity::Fault);
    EXPECT_TRUE(
        says(fact.story.toStdString(), "Reset of 1032AE100801035 was not on the bus when can1 was left"));
    EXPECT_TRUE(says(fact.story.toStdString(), "3 frames were not on the bus when can1 was left"));
  }
}

TEST(NoticeText, SaysWhyAListenOnlyAdapterIsNotUnlocked) {
  Snapshot snapshot = link(Progress::Running);
  snapshot.source.isListenOnly = true;
  EXPECT_EQ(notice(snapshot), "") << "nobody wanted to send";
  ServiceStatus services;
  services.refusal = Refusal::ListenOnly;
  snapshot.services = std::make_shared<const ServiceStatus>(services);
  EXPECT_TRUE(says(notice(snapshot), "listen-only mode and cannot send"));
  EXPECT_TRUE(noticeOf(snapshot, {}).command.endsWith(QLatin1String("listen-only off")));
}

TEST(CompletenessFact, CountsWhatIsMissing) {
  EXPECT_EQ(completenessFact(link(Progress::Running)).text.toStdString(), "Complete");
  Snapshot lossy = link(Progress::Running);
  const auto log = logOfText(kTruck);
  log->notes.append({.value = note::Dropped{{}, 12}});
  lossy.view.document = log;
  EXPECT_EQ(completenessFact(lossy).text.toStdString(), "12 frames missing");
  EXPECT_EQ(completenessFact(lossy).tone, Severity::Warning);
}

TEST(MissingFrames, AreSaidByTheKindThatIsKnown) {
  using Why = note::LeftOut::Why;
  const auto missing = [](std::vector<NoteValue> notes, std::vector<Skipped> places) {
    const auto log = logOfText(kTruck);
    for (NoteValue& value : notes) log->notes.append({.frame = 1, .value = std::move(value)});
    for (const Skipped place : places) log->skipped.add(1, place);
    for (const From kind : {From::File, From::Link}) {
      Snapshot snapshot = snapshotOf(kTruck, kind, kind == From::File ? Progress::Done : Progress::Running);
      snapshot.view.document = log;
      EXPECT_EQ(completenessFact(snapshot).tone == Severity::Fine, missingFrames(*log).text.isEmpty());
      if (kind == From::File) {
        EXPECT_EQ(notice(snapshot), missingFrames(*log).text.toStdString());
      }
    }
    return missingFrames(*log).text.toStdString();
  };
  const std::string begins = "Missing in this log: ";
  EXPECT_EQ(missing({}, {}), "");
  EXPECT_EQ(missing({note::Dropped{{}, 3}}, {}),
            begins + "3 frames that were lost before they could be recorded.");
  EXPECT_EQ(missing({}, {Skipped::CanFd, Skipped::CanFd}), begins + "2 CAN FD frames, which are not held.");
  EXPECT_EQ(missing({note::LeftOut{{}, Why::CanFd, 2}}, {Skipped::CanFd}),
            begins + "3 CAN FD frames, which are not held.")
      << "saved from a link, and skipped by the reader of its file";
  EXPECT_EQ(missing({note::LeftOut{{}, Why::CanXl, 2}}, {}), begins + "2 CAN XL frames, which are not held.");
  EXPECT_EQ(missing({}, {Skipped::CanXl, Skipped::CanXl}), begins + "2 CAN XL frames, which are not held.");
  EXPECT_EQ(
      missing({note::LeftOut{{}, Why::NotClassic, 4}}, {Skipped::RecorderDropped, Skipped::RecorderDropped}),
      begins +
          "what the recorder lost at 2 places, as it says; 4 frames that are not classic CAN, which are "
          "not held.");
  EXPECT_EQ(
      missing({note::LeftOut{{}, Why::RecorderLost, 1}, note::LeftOut{{}, Why::Unreadable, 2}},
              {Skipped::RecorderDropped}),
      begins +
          "what the recorder lost at 2 places, as it says; what stood in 2 lines of the file that it was "
          "saved from, which could not be read.");
}

TEST(MissingFrames, AreNotCountedWhereTheRecorderDoesNotSayHowManyItLost) {
  const auto log = logOfText(kTruck);
  log->skipped.add(1, Skipped::RecorderDropped);
  log->skipped.add(1, Skipped::CanFd);
  Snapshot snapshot = file(kTruck);
  snapshot.view.document = log;
  EXPECT_EQ(completenessFact(snapshot).text.toStdString(), "Frames missing");
}

TEST(RecordingFact, StandsStillAtTheLastFrameWhereNoLinkIsUp) {
  for (const Progress progress : {Progress::Running, Progress::Lost, Progress::Opening, Progress::Failed}) {
    Snapshot snapshot = link(progress, "(10.000000) can0 123#\n(17.000000) can0 123#\n");
    snapshot.view.end = snapshot.view.cursor.time = snapshot.view.end + 300s;
    const std::string text = recordingFact(snapshot).text.toStdString();
    EXPECT_TRUE(says(text, progress == Progress::Running ? "0:05:07 · 2 frames" : "0:00:07 · 2 frames"))
        << text;
  }
}

TEST(CompletenessFact, IsNotSaidWithoutAFrame) {
  for (const Progress progress : {Progress::Done, Progress::Opening}) {
    Snapshot empty = file(kTruck, progress);
    empty.view = viewOf(std::make_shared<LogDocument>());
    EXPECT_EQ(completenessFact(empty).text.toStdString(), "No frame");
    EXPECT_EQ(completenessFact(empty).tone, Severity::Unknown);
    EXPECT_FALSE(says(recordingFact(empty).story.toStdString(), "over"));
  }
  Snapshot quiet = link(Progress::Running);
  quiet.view = viewOf(std::make_shared<LogDocument>());
  EXPECT_EQ(completenessFact(quiet).text.toStdString(), "No frame");
}

TEST(CompletenessFact, IsSaidOnlyOfWhatWasReadToItsEnd) {
  EXPECT_EQ(completenessFact(file(kTruck)).text.toStdString(), "Complete");
  EXPECT_EQ(completenessFact(file(kTruck, Progress::Opening)).text.toStdString(), "Not complete yet");
  EXPECT_EQ(completenessFact(file(kTruck, Progress::Failed)).text.toStdString(), "Not whole");
  EXPECT_EQ(completenessFact(link(Progress::Lost)).text.toStdString(), "Link lost");
}

// Down between the two frames, each time for 17 s; up again after all but the last, or after all.
Snapshot snapshotWithOutages(From kind, Progress progress, int outages, bool isUpAgain) {
  Snapshot snapshot = snapshotOf(kTruck, kind, progress);
  const auto log = logOfText(kTruck);
  for (int i = 0; i < outages; ++i) {
    const Instant down{(20 + 40 * i) * 1'000'000'000LL};
    log->notes.append({.frame = 1, .time = down, .value = note::LinkDown{{}, LinkFault::Gone}});
    if (isUpAgain || i + 1 < outages)
      log->notes.append({.frame = 1, .time = down + 17s, .value = note::LinkUp{}});
  }
  snapshot.view.document = log;
  return snapshot;
}

TEST(CompletenessFact, OfALinkRemembersThatItWasDown) {
  struct Row {
    const char* name;
    From kind;
    Progress progress;
    int outages;
    bool isUpAgain;
    const char* text;
  };
  for (const Row& row : {Row{"up again", From::Link, Progress::Running, 1, true, "1 gap of 17 s"},
                         Row{"up again twice", From::Link, Progress::Running, 2, true, "2 gaps, 34 s in all"},
                         Row{"connecting again", From::Link, Progress::Opening, 1, false, "Link lost"},
                         Row{"lost again", From::Link, Progress::Lost, 2, false, "Link lost, 1 gap of 17 s"},
                         Row{"not up again", From::Link, Progress::Failed, 1, false, "Link lost"},
                         Row{"a file of it", From::File, Progress::Done, 1, true, "1 gap of 17 s"},
                         Row{"a file that ends so", From::File, Progress::Done, 1, false, "Complete"}}) {
    SCOPED_TRACE(row.name);
    const StatusFact fact =
        completenessFact(snapshotWithOutages(row.kind, row.progress, row.outages, row.isUpAgain));
    EXPECT_EQ(fact.text.toStdString(), row.text);
    EXPECT_EQ(fact.tone == Severity::Fine, fact.text == QLatin1String("Complete"));
    EXPECT_FALSE(says(fact.story.toStdString(), "Nothing is known to be missing"));
    EXPECT_FALSE(says(fact.story.toStdString(), "could be read;"));
  }
}

TEST(CompletenessFact, OfALinkWithoutRoomSaysThatTheEndIsMissing) {
  Snapshot full = link(Progress::Failed);
  full.source.error = StoreFull{};
  const StatusFact fact = completenessFact(full);
  EXPECT_EQ(fact.text.toStdString(), "Store full");
  EXPECT_EQ(fact.tone, Severity::Warning);
  EXPECT_TRUE(says(fact.story.toStdString(), "What came after the last frame is missing"));
}

TEST(LoadFact, IsUnknownWithoutTimes) {
  const Snapshot timeless = file("can0  18EFFF80   [8]  01 1D 94 03 71 00 00 41\n");
  const BusRates rates = ratesAt(timeless.view);
  EXPECT_EQ(loadFact(timeless, rates).text.toStdString(), "Load –");
  EXPECT_EQ(rateFact(rates).text.toStdString(), "– frames/s");
  EXPECT_TRUE(says(rateFact(rates).story.toStdString(), "Without times"));
  EXPECT_TRUE(says(recordingFact(timeless).story.toStdString(), "without times"));
}

TEST(LoadFact, IsUnknownWhereTimesAreGoodToTheSecondOnly) {
  std::string text;
  for (int i = 0; i < 200; ++i)
    text += "(" + std::to_string(10 + i / 100) + ".000000) can" + std::to_string(i % 2) +
            " 18EFFF80#011D940371000041\n";
  const Snapshot coarse = file(text.c_str());
  const BusRates rates = ratesAt(coarse.view);
  EXPECT_EQ(loadFact(coarse, rates).text.toStdString(), "Load –");
  EXPECT_EQ(rateFact(rates).text.toStdString(), "– frames/s");
  EXPECT_TRUE(says(rateFact(rates).story.toStdString(), "good to the second only"));
  EXPECT_FALSE(says(loadFact(coarse, rates).story.toStdString(), " % of ")) << "of no channel";
}

TEST(FilteredLog, IsSaidAndNothingOfItIsCalledCompleteOrALoad) {
  Snapshot snapshot = file(kTruck);
  auto& log = const_cast<LogDocument&>(*snapshot.view.document);
  log.notes.append({.frame = 0, .time = log.frames.timeAt(0), .value = note::Filtered{"pgn=EF00 and sa=80"}});
  auto state = std::make_shared<State>();
  advance(*state, log.frames, log.notes, snapshot.view.cursor);
  snapshot.view.state = state;
  EXPECT_TRUE(says(notice(snapshot), "saved through the filter “pgn=EF00 and sa=80”")) << notice(snapshot);
  const StatusFact complete = completenessFact(snapshot);
  EXPECT_EQ(complete.text.toStdString(), "Filtered");
  EXPECT_EQ(complete.tone, Severity::Warning);
  const BusRates rates = ratesAt(snapshot.view);
  EXPECT_EQ(loadFact(snapshot, rates).text.toStdString(), "Load –");
  EXPECT_TRUE(says(rateFact(rates).story.toStdString(), "saved through a filter"));
}

TEST(CompletenessFact, SaysThatInterfacesHaveNoNameOfTheirOwn) {
  std::string text;
  for (int i = 0; i < 300; ++i) text += "(1.5) can" + std::to_string(i) + " 123#\n";
  EXPECT_EQ(completenessFact(file(text.c_str())).text.toStdString(), "Interfaces unnamed");
}

TEST(LoadFact, IsUnknownOfALogTooShortToTell) {
  const Snapshot brief = file("(1.000) can0 18EFFF80#011D940371000041\n(1.050) can0 18EFFF80#83C051\n");
  const BusRates rates = ratesAt(brief.view);
  EXPECT_EQ(loadFact(brief, rates).text.toStdString(), "Load –");
  EXPECT_TRUE(says(loadFact(brief, rates).story.toStdString(), "Too little of the log"));
  EXPECT_FALSE(says(loadFact(brief, rates).story.toStdString(), "Without times"));
  EXPECT_FALSE(says(rateFact(rates).story.toStdString(), "Without times"));
}

TEST(SourceError, NamesTheFormatThatAFileSeemsToBe) {
  EXPECT_TRUE(says(sourceErrorText(ReadError{ReadError::Kind::UnknownFormat, {}, "PEAK TRC"}).toStdString(),
                   "seems to be PEAK TRC"));
}

TEST(SourceError, OfALinkIsSaidInTheWindowsOwnWords) {
  for (const LinkFault fault : kAllOf<LinkFault>) {
    EXPECT_EQ(sourceErrorText(LinkError{.fault = fault}).isEmpty(), fault == LinkFault::None);
    EXPECT_TRUE(
        sourceErrorText(LinkError{.fault = fault, .detail = "EBUSY"}).contains(QStringLiteral("EBUSY")));
  }
  EXPECT_TRUE(
      says(sourceErrorText(LinkError{.fault = LinkFault::WrongBitRate, .bitRate = 500'000}).toStdString(),
           "runs at 500 kbit/s"));
}

TEST(NoticeText, IsQuietWhileAllIsWell) {
  EXPECT_EQ(notice(link(Progress::Running)), "");
  EXPECT_EQ(notice(file(kTruck)), "");
  EXPECT_EQ(notice({}), "");
}

TEST(NoticeText, SaysWhatToCheckWhenNothingIsHeard) {
  Snapshot snapshot = link(Progress::Running);
  snapshot.view.cursor.time = snapshot.view.cursor.time + 7s;
  const std::string text = notice(snapshot);
  EXPECT_TRUE(says(text, "nothing heard for 7 seconds")) << text;
  EXPECT_TRUE(says(text, "60 ohms")) << text;
  EXPECT_EQ(noticeOf(snapshot, {}).action, Notice::Action::ChangeBitRate);
  snapshot.source.simulated = true;
  EXPECT_EQ(noticeOf(snapshot, {}).action, Notice::Action::None);
}

TEST(NoticeText, TellsWrongTraffic) {
  EXPECT_TRUE(says(notice(link(Progress::Running, "(1.0) can0 123#11\n(1.2) can0 123#11\n")), "Only 11-bit"));
  EXPECT_TRUE(says(notice(link(Progress::Running, "(1.0) can0 18FEF100#11\n(1.2) can0 18FEF100#11\n")),
                   "no Akron device"));
}

TEST(NoticeText, SaysThatTheLinkIsLostAndOffersItAgain) {
  Snapshot snapshot = link(Progress::Lost);
  snapshot.source.error = LinkError{.fault = LinkFault::Gone, .detail = "Network is down"};
  EXPECT_TRUE(says(notice(snapshot), "lost: the adapter is gone (Network is down)"));
  EXPECT_EQ(noticeOf(snapshot, {}).action, Notice::Action::Reconnect);
}

TEST(NoticeText, SaysThatTheCursorStandsInThePastOfALiveLog) {
  Snapshot snapshot = link(Progress::Running);
  snapshot.view.atEnd = false;
  snapshot.view.end = snapshot.view.cursor.time + 65s;
  EXPECT_TRUE(says(notice(snapshot), "0:01:05 ago"));
  EXPECT_EQ(noticeOf(snapshot, {}).action, Notice::Action::GoToEnd);
}

TEST(NoticeText, GivesTheCommandForAnInterfaceThatIsDown) {
  Snapshot snapshot = link(Progress::Failed, "");
  snapshot.source.error = LinkError{.fault = LinkFault::InterfaceDown};
  EXPECT_EQ(noticeOf(snapshot, {}).command.toStdString(),
            "sudo ip link set can0 up type can bitrate 250000 listen-only on");
}

TEST(NoticeText, SaysThatTheLogIsFullAndNotThatTheInterfaceCannotBeOpened) {
  Snapshot snapshot = link(Progress::Failed);
  snapshot.source.error = StoreFull{};
  EXPECT_TRUE(says(notice(snapshot), "Nothing more of can0 is recorded: there is no room"));
}

TEST(NoticeText, NamesTheLinesOfALogThatAreUnreadable) {
  Snapshot snapshot = file("(1.0) can0 123#11\nrubbish\n(2.0) can0 123#1\n");
  snapshot.source.unreadable = 2;
  const std::string text = notice(snapshot);
  EXPECT_TRUE(says(text, "2 lines")) << text;
  EXPECT_TRUE(says(text, "line 2: ")) << text;
  EXPECT_TRUE(says(text, "line 3: ")) << text;
}

TEST(NoticeText, SaysOfDifferencesOfCutLinesAndOfLostFractions) {
  const Snapshot deltas =
      file("(0.0) can0 123#\n(0.1) can0 123#\n(0.1) can0 123#\n(0.1) can0 123#\n(0.1) can0 123#\n");
  EXPECT_TRUE(says(notice(deltas), "look like differences")) << notice(deltas);
  EXPECT_EQ(noticeOf(deltas, ratesAt(deltas.view)).action, Notice::Action::AddUpTimes);
  Snapshot cut = file(kTruck);
  std::set<std::string> told;
  for (const LastLine line : kAllOf<LastLine>) {
    cut.source.read.lastLine = line;
    EXPECT_TRUE(told.insert(notice(cut)).second) << kLastLineKeys[line];
    EXPECT_EQ(notice(cut).empty(), line == LastLine::Whole) << kLastLineKeys[line];
  }
  const Snapshot fractions = file("(1.4011223344) can0 123#\n(2.0) can0 123#\n");
  EXPECT_TRUE(says(notice(fractions), "more than nine decimals")) << notice(fractions);
}

TEST(NoticeText, SaysThatALogIsEmptyOrCannotBeRead) {
  EXPECT_EQ(notice(file("")), "This log holds no frames.");
  Snapshot snapshot = file("", Progress::Failed);
  snapshot.source.error = ReadError{ReadError::Kind::CannotOpen, "No such file or directory"};
  EXPECT_EQ(notice(snapshot), "truck.log cannot be read: cannot be opened: No such file or directory");
  snapshot.source.error = ReadError{.kind = ReadError::Kind::UnknownFormat};
  EXPECT_EQ(
      notice(snapshot),
      "truck.log cannot be read: not a log of a known format. Deckpipe reads: Deckpipe recording, candump.");
}

TEST(ClockNotice, IsForAClockThatGoesBackAndNotForTheUsualSmallSteps) {
  const auto noticeOfLog = [](const std::string& text) {
    const Snapshot snapshot = test::snapshotOf(text, SourceStatus::Kind::File, SourceStatus::Progress::Done);
    return noticeOf(snapshot, ratesAt(snapshot.view)).text;
  };
  EXPECT_EQ(noticeOfLog("(10.000) can0 123#11\n(9.999) can1 123#11\n(900.0) can0 123#11\n"), QString());
  EXPECT_TRUE(
      noticeOfLog("(10.0) can0 123#11\n(5.0) can0 123#11\n").contains(QStringLiteral("back at frame 2")));
}

}  // namespace
}  // namespace deckpipe
