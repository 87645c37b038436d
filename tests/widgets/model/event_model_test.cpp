// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "support/enums.h"
#include "support/frames.h"
#include "support/logs.h"
#include "support/note_samples.h"

namespace deckpipe {
namespace {

using test::logOfText;
using test::viewOf;

constexpr auto kLog =
    "(10.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(10.000000) can0 18EFFF80#83C051\n"
    "(12.500000) can0 18EFFF80#834051\n"
    "(13.000000) can0 18EFFF80#83C051\n";

struct ModelOfEvents : testing::Test {
  std::string what(int row) const {
    return model.index(row, EventModel::What).data().toString().toStdString();
  }
  EventModel model;
  QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(ModelOfEvents, SaysWhatHappenedAndWhen) {
  model.setView(viewOf(logOfText(kLog)));
  ASSERT_EQ(model.rowCount(), 2);
  EXPECT_EQ(what(0), "Disabled: it cannot move");
  EXPECT_EQ(what(1), "Enabled");
  EXPECT_EQ(model.index(0, EventModel::When).data().toString().toStdString(), "0:00:02.500");
  EXPECT_EQ(model.index(0, EventModel::Bus).data().toString().toStdString(), "can0");
  EXPECT_EQ(model.weight(0), Severity::Warning);
  EXPECT_EQ(model.group(0), EventGroup::Mode);
}

TEST_F(ModelOfEvents, NamesTheDeviceByItsLabelOrItsPin) {
  model.setView(viewOf(logOfText(kLog)));
  EXPECT_EQ(model.index(0, EventModel::Who).data().toString().toStdString(), "1032AE100801035");
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  DeviceLabels labels;
  labels.set(*Pin::parse("1032AE100801035"), QStringLiteral("Roof"));
  model.setLabels(labels);
  EXPECT_EQ(model.index(0, EventModel::Who).data().toString().toStdString(), "Roof");
  EXPECT_EQ(changed.size(), 1);
}

TEST_F(ModelOfEvents, MakesOneRowOfAQuestionAndItsAnswers) {
  const auto log = logOfText(kLog);
  const Pin pin = *Pin::parse("1032AE100801035");
  const auto request = [&] {
    log->notes.append(
        {.frame = 4, .time = Instant{13'000'000'000}, .value = note::Asked{{}, {0x80}, pin, Request::Fault}});
    model.setView(viewOf(log));
  };
  const auto end = [&](RequestEnd how) {
    log->notes.append({.frame = 4,
                       .time = Instant{13'000'000'000},
                       .value = note::RequestEnded{{}, {0x80}, pin, Request::Fault, how}});
    model.setView(viewOf(log));
  };
  request();
  EXPECT_EQ(what(2), "Faults: asked");
  end(RequestEnd::Answered);
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(what(2), "Faults: answered");
  request();
  end(RequestEnd::Answered);
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(what(2), "Faults: answered, 2 times");
  request();
  end(RequestEnd::NoAnswer);
  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(what(3), "Faults: no answer");
}

TEST_F(ModelOfEvents, KeepsWhereADeviceStoodBeforeACommand) {
  const auto log = logOfText(kLog);
  const Pin pin = *Pin::parse("1032AE100801035");
  const Instant time{13'000'000'000};
  const Request zero = Request::ZeroAxes;
  log->notes.append(
      {.frame = 4, .time = time, .value = note::AnglesBefore{{}, {0x80}, pin, zero, {473}, {-55}}});
  log->notes.append({.frame = 4, .time = time, .value = note::Asked{{}, {0x80}, pin, zero}});
  log->notes.append(
      {.frame = 4, .time = time, .value = note::RequestEnded{{}, {0x80}, pin, zero, RequestEnd::Answered}});
  model.setView(viewOf(log));
  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(what(2), "Zero axes: before it the device stood at rotation 47.3°, elevation -5.5°");
  EXPECT_EQ(what(3), "Zero axes: answered");
}

TEST_F(ModelOfEvents, TakesEventsAsTheyAreFound) {
  const auto log = std::make_shared<LogDocument>();
  log->frames.channel("can0");
  ASSERT_TRUE(log->frames.append(std::vector{test::frame("18EFFF80", "83C051", 0, 1'000'000'000)}));
  model.setView(viewOf(log));
  EXPECT_EQ(model.rowCount(), 0);
  while (log->events.build({1, Instant{6'000'000'000}})) {
  }
  model.setView(viewOf(log));
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(what(0), "Silent since 0:00:00.000: its periodic messages are missing");
  EXPECT_EQ(model.index(0, EventModel::When).data().toString().toStdString(), "0:00:03.000");
}

TEST_F(ModelOfEvents, SaysSinceWhenThatHoldsWhichIsToldLater) {
  std::vector<Frame> frames;
  for (int i = 0; i < 130; ++i)
    frames.push_back(test::frame("18EFFF80", i < 8 && i % 2 == 0 ? "83C051" : "834051", 0,
                                 7'000'000'000 + i * std::int64_t{100'000'000}));
  model.setView(viewOf(test::logOf(frames)));
  ASSERT_EQ(model.rowCount(), 5);
  EXPECT_EQ(model.index(4, EventModel::When).data().toString().toStdString(), "0:00:10.100");
  EXPECT_EQ(what(4),
            "Disabled: it cannot move, since 0:00:00.700 (2 changes right before it are not listed)");
}

TEST_F(ModelOfEvents, PutsAMarkWhereItBelongs) {
  const auto log = logOfText(kLog);
  model.setView(viewOf(log));
  QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
  log->notes.append({.frame = 2, .time = Instant{12'700'000'000}, .value = note::Mark{"valve opened"}});
  model.setView(viewOf(log));
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(what(1), "valve opened");
  ASSERT_EQ(inserted.size(), 1);
  EXPECT_EQ(inserted[0][1].toInt(), 1);
  EXPECT_EQ(inserted[0][2].toInt(), 1);
}

// Of every kind, and of every way to an address of our own.
TEST(NoteText, SaysEachInASentenceOfItsOwn) {
  const auto log = logOfText("(1.0) can0 123#11\n(1.1) can1 123#11\n(1.2) can2 123#11\n");
  std::vector<NoteValue> values = test::noteSamples();
  for (const auto how : test::allOf<note::OwnAddress::How>())
    values.push_back(note::OwnAddress{test::kNotedChannel, {0xF9}, how});
  std::vector<std::string> sentences;
  for (const NoteValue& value : values) sentences.push_back(noteText(*log, {.value = value}).toStdString());
  EXPECT_EQ(sentences,
            (std::vector<std::string>{
                "water on",
                "can2 up: socketcan can0",
                "can2 down: the adapter is gone (Network is down)",
                "can2: 2147483647 frames lost",
                "Transmit locked",
                "Transmit unlocked",
                "can2: address 81 is no drive",
                "The console lost its address to a lower NAME",
                "Reset: asked",
                "Vista status: answered too late",
                "Zero axes: not on the bus yet; it may still go out",
                "can2: 5 frames are not on the bus yet and may still go out",
                "Data pipe, axis.txt: file sent",
                "can2: 7 frames came that are not classic CAN and are not held",
                "1032AE100801035 is called “front bumper”",
                "",
                "Saved through the filter “pgn=EF00 and sa=80”: what did not pass it is missing",
                "Reset: before it the device stood at rotation -47.3°",
                "",
                "The console's joystick at address 81 was armed and moves this monitor",
                "The console's joystick was disarmed: a monitor is not heard any more, or its address is "
                "contested",
                "An old motion frame of the console has just gone out",
                "The console holds address F9",
                "The console lost its address to a lower NAME",
                "The console cannot claim any address",
                "Another node has the console's NAME",
                "The console gave up its address",
                "The console gave up its address",
                "The console left its address: another node sends from it",
                "Another node sends from address F9, which the console holds and claims again",
            }));
}

TEST(NoteWeight, IsPlainOnlyForWhatWasMeant) {
  using How = note::OwnAddress::How;
  for (const How how : test::allOf<How>()) {
    const bool isMeant = how == How::Claimed || how == How::Locked;
    EXPECT_EQ(noteWeight(note::OwnAddress{{}, {}, how}), isMeant ? Severity::Plain : Severity::Warning);
  }
}

TEST_F(ModelOfEvents, HasNoRowOfFramesThatWereAdded) {
  const auto log = logOfText("(1.000000) can0 123#11\n(2.000000) can0 123#11\n");
  log->notes.append({.frame = 0, .time = log->frames.timeAt(0), .value = note::Filtered{"id=123"}});
  for (const std::uint64_t frame : {0, 1})
    log->notes.append({.frame = frame, .time = log->frames.timeAt(frame), .value = note::Added{1}});
  model.setView(viewOf(log));
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_TRUE(model.text(0).startsWith(QStringLiteral("Saved through the filter “id=123”")));
}

TEST_F(ModelOfEvents, ForgetsAnotherLog) {
  model.setView(viewOf(logOfText(kLog)));
  model.setView(viewOf(logOfText("(1.000000) can0 123#11\n")));
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace deckpipe
