// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/event_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "support/enums.h"
#include "support/logs.h"
#include "support/note_samples.h"

namespace deckpipe {
namespace {

using test::logOfText;
using test::viewOf;

constexpr auto kLog =
    "(10.000000) can0 18EFFF80#FF83150206021A0B\n"
    "(12.500000) can0 724#00\n";

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
  EXPECT_EQ(what(0), "1032AE100801035 appeared at address 80");
  EXPECT_EQ(what(1), "Node 24 started");
  EXPECT_EQ(model.index(1, EventModel::When).data().toString().toStdString(), "0:00:02.500");
  EXPECT_EQ(model.index(1, EventModel::Bus).data().toString().toStdString(), "can0");
}

TEST_F(ModelOfEvents, PutsAMarkWhereItBelongs) {
  const auto log = logOfText(kLog);
  model.setView(viewOf(log));
  QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
  log->notes.append({.frame = 1, .time = Instant{11'000'000'000}, .value = note::Mark{"valve opened"}});
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
  EXPECT_EQ(sentences, (std::vector<std::string>{
                           "water on",
                           "can2 up: socketcan can0",
                           "can2 down: Network is down",
                           "can2: 2147483647 frames lost",
                           "Transmit locked",
                           "Transmit unlocked",
                           "can2: address 81 is no drive",
                           "The console lost its address to a lower NAME",
                           "Reset asked of 1032AE100801035",
                           "Vista status of 1032AE100801035: answered too late",
                           "Zero axes of 1032AE100801035: not on the bus yet; it may still go out",
                           "can2: 5 frames are not on the bus yet and may still go out",
                           "Data pipe 1032AE100801035 axis.txt: file sent",
                           "can2: 7 frames came that are not classic CAN and are not held",
                           "1032AE100801035 is called “front bumper”",
                           "9 frames were added here when this part was saved: who held which address",
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
    EXPECT_EQ(weightOf(Note{.value = note::OwnAddress{{}, {}, how}}),
              isMeant ? EventWeight::Plain : EventWeight::Attend);
  }
}

TEST_F(ModelOfEvents, KnowsWhatHasHappenedAtTheCursor) {
  const auto log = logOfText(kLog);
  model.setView(viewOf(log, 0));
  EXPECT_EQ(model.rowAtCursor(), -1);
  model.setView(viewOf(log, 1));
  EXPECT_EQ(model.rowAtCursor(), 0);
  model.setView(viewOf(log));
  EXPECT_EQ(model.rowAtCursor(), 1);
}

TEST_F(ModelOfEvents, ForgetsAnotherLog) {
  model.setView(viewOf(logOfText(kLog)));
  model.setView(viewOf(logOfText("(1.000000) can0 123#11\n")));
  EXPECT_EQ(model.rowCount(), 0);
}

}  // namespace
}  // namespace deckpipe
