// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/latest_request_worker.h"

#include <gtest/gtest.h>

#include <semaphore>
#include <string>
#include <vector>

namespace deckpipe {
namespace {

using Worker = LatestRequestWorker<int, std::string>;

// Work that says when it has begun, and goes on when it is let go or given up.
struct HeldWork {
  std::vector<int> begun, givenUp;
  std::counting_semaphore<> begins{0}, ends{0};
  std::atomic<bool> isHeld = true;

  void operator()(int request, const Worker::Turn& turn) {
    begun.push_back(request);
    begins.release();
    while (isHeld && !turn.isGivenUp()) std::this_thread::yield();
    if (turn.isGivenUp()) givenUp.push_back(request);
    turn.handOver(std::make_shared<std::string>(std::to_string(request)));
    ends.release();
  }
};

struct LatestRequestWorkerTest : testing::Test {
  HeldWork work;
  Worker worker{std::ref(work), std::make_shared<std::string>("first")};

  void waitUntilEnded(int times) {
    for (int i = 0; i < times; ++i) work.ends.acquire();
  }
};

TEST_F(LatestRequestWorkerTest, HandsOverTheResultOfARequest) {
  EXPECT_EQ(*worker.latest(), "first");
  EXPECT_EQ(worker.outcome(), nullptr);
  work.isHeld = false;
  worker.request(7);
  waitUntilEnded(1);
  EXPECT_EQ(*worker.latest(), "7");
  EXPECT_EQ(worker.outcome(), worker.latest());
  worker.request(7);
  waitUntilEnded(1);
  EXPECT_EQ(work.begun, (std::vector{7, 7})) << "the same again is another request";
}

TEST_F(LatestRequestWorkerTest, GivesUpTheOlderRequestForTheNewerOne) {
  worker.request(1);
  work.begins.acquire();
  worker.request(2);
  work.begins.acquire();
  EXPECT_EQ(work.givenUp, std::vector{1});
  EXPECT_EQ(*worker.latest(), "1") << "found on the way";
  EXPECT_EQ(worker.outcome(), nullptr) << "but not what is asked for now";
  work.isHeld = false;
  waitUntilEnded(2);
  EXPECT_EQ(*worker.outcome(), "2");
}

TEST(LatestRequestWorker, NeverBeginsARequestThatWasReplacedMeanwhile) {
  std::vector<int> begun;
  std::binary_semaphore begins{0}, goesOn{0};
  LatestRequestWorker<int> worker([&](int request, const auto&) {
    begun.push_back(request);
    begins.release();
    goesOn.acquire();
  });
  worker.request(1);
  begins.acquire();
  for (const int request : {2, 3, 4}) worker.request(request);
  goesOn.release();
  begins.acquire();
  EXPECT_EQ(begun, (std::vector{1, 4}));
  goesOn.release();
}

TEST_F(LatestRequestWorkerTest, CancelGivesUpWhatIsWorkedOnAndHidesItsResult) {
  worker.request(1);
  work.begins.acquire();
  worker.cancel();
  waitUntilEnded(1);
  EXPECT_EQ(work.givenUp, std::vector{1});
  EXPECT_EQ(worker.outcome(), nullptr);
  work.isHeld = false;
  worker.request(2);
  waitUntilEnded(1);
  EXPECT_EQ(*worker.outcome(), "2");
  worker.cancel();
  EXPECT_EQ(worker.outcome(), nullptr);
}

TEST(LatestRequestWorker, CancelDropsARequestThatWaits) {
  std::vector<int> begun;
  std::binary_semaphore begins{0}, goesOn{0};
  LatestRequestWorker<int> worker([&](int request, const auto&) {
    begun.push_back(request);
    begins.release();
    goesOn.acquire();
  });
  worker.request(1);
  begins.acquire();
  worker.request(2);
  worker.cancel();
  worker.request(3);
  goesOn.release();
  begins.acquire();
  EXPECT_EQ(begun, (std::vector{1, 3}));
  goesOn.release();
}

TEST(LatestRequestWorker, EndsInTheMidstOfWorkAndBeginsNoOther) {
  HeldWork work;
  {
    Worker worker{std::ref(work)};
    worker.request(1);
    work.begins.acquire();
  }
  EXPECT_EQ(work.begun, std::vector{1});
  EXPECT_EQ(work.givenUp, std::vector{1});
}

TEST(LatestRequestWorker, EndsWithoutAnyWork) {
  int begun = 0;
  for (int i = 0; i < 100; ++i) LatestRequestWorker<int> worker([&](int, const auto&) { ++begun; });
  EXPECT_EQ(begun, 0);
}

}  // namespace
}  // namespace deckpipe
