// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/interface_watch.h"

#include <gtest/gtest.h>

#include <QTest>
#include <future>
#include <thread>

#include "support/patience.h"

namespace deckpipe {
namespace {

// A kernel whose network lock somebody holds: a read of "held" returns after release().
struct HeldKernel {
  InterfaceReader::Answer read(const std::string& name) {
    readers.push_back(std::this_thread::get_id());
    if (name == "held") {
      hasBegun.set_value();
      lock.get_future().wait();
    }
    CanInterface facts;
    facts.name = name;
    return facts;
  }
  void release() { lock.set_value(); }

  std::promise<void> hasBegun, lock;
  std::vector<std::thread::id> readers;
};

struct Reading : ::testing::Test {
  void SetUp() override {
    reader =
        std::make_unique<InterfaceReader>([kernel = kernel](const auto& name) { return kernel->read(name); });
    QObject::connect(reader.get(), &InterfaceReader::answered, reader.get(), [this](const auto& answer) {
      happened.push_back(answer ? "read " + answer.value().name : answer.error());
    });
  }
  bool waitFor(std::size_t count) {
    return QTest::qWaitFor([&] { return happened.size() >= count; }, kPatience);
  }
  // The worker's reference is gone, and with it the worker.
  bool waitForWorkersEnd() {
    return QTest::qWaitFor([&] { return kernel.use_count() == 1; }, kPatience);
  }

  std::shared_ptr<HeldKernel> kernel = std::make_shared<HeldKernel>();
  std::unique_ptr<InterfaceReader> reader;
  std::vector<std::string> happened;
};

TEST_F(Reading, IsDoneOnAnotherThreadAndAnsweredFromTheEventLoop) {
  reader->request("can0");
  EXPECT_TRUE(happened.empty());
  ASSERT_TRUE(waitFor(1));
  reader->request("can1");
  ASSERT_TRUE(waitFor(2));
  EXPECT_EQ(happened, (std::vector<std::string>{"read can0", "read can1"}));
  reader.reset();
  ASSERT_TRUE(waitForWorkersEnd());
  ASSERT_EQ(kernel->readers.size(), 2u);
  EXPECT_NE(kernel->readers[0], std::this_thread::get_id());
  EXPECT_EQ(kernel->readers[1], kernel->readers[0]) << "one worker, however often it is asked";
}

TEST_F(Reading, WhileTheKernelKeepsItWaitingTheAskersEventsGoOn) {
  reader->request("held");
  kernel->hasBegun.get_future().wait();
  for (int i = 0; i < 3; ++i) {
    QMetaObject::invokeMethod(
        reader.get(), [this] { happened.push_back("event"); }, Qt::QueuedConnection);
  }
  ASSERT_TRUE(waitFor(3));
  kernel->release();
  ASSERT_TRUE(waitFor(4));
  EXPECT_EQ(happened, (std::vector<std::string>{"event", "event", "event", "read held"}));
}

TEST_F(Reading, OnlyTheNewestQuestionIsAnswered) {
  reader->request("held");
  kernel->hasBegun.get_future().wait();
  reader->request("can1");
  reader->request("can2");
  kernel->release();
  ASSERT_TRUE(waitFor(1));
  EXPECT_EQ(happened, (std::vector<std::string>{"read can2"}));
}

TEST_F(Reading, WhatIsForgottenIsNotAnswered) {
  reader->request("held");
  kernel->hasBegun.get_future().wait();
  reader->forget();
  kernel->release();
  reader->request("can1");
  ASSERT_TRUE(waitFor(1));
  EXPECT_EQ(happened, (std::vector<std::string>{"read can1"}));
}

TEST_F(Reading, AReaderDestroyedWhileAReadHangsNeitherWaitsNorAnswers) {
  reader->request("held");
  kernel->hasBegun.get_future().wait();
  reader.reset();
  EXPECT_EQ(kernel.use_count(), 2) << "the worker is still in the kernel";
  kernel->release();
  EXPECT_TRUE(waitForWorkersEnd());
  EXPECT_TRUE(happened.empty());
}

TEST_F(Reading, AReaderNeverAskedHasNoWorker) {
  reader.reset();
  EXPECT_EQ(kernel.use_count(), 1);
}

}  // namespace
}  // namespace deckpipe
