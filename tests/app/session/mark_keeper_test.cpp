// SPDX-License-Identifier: GPL-3.0-or-later
// Marks are written beside a log on a disk that takes as long as it likes.
#include "session/mark_keeper.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QTest>
#include <condition_variable>
#include <mutex>

#include "session/clocks.h"
#include "support/frames.h"
#include "support/patience.h"

namespace deckpipe {
namespace {

// Writes nothing until it is let go.
struct SlowDisk {
  std::mutex lock;
  std::condition_variable changed;
  bool isHeld = true;
  QString answer{};
  std::vector<std::string> written{};

  MarkKeeper::Write write() {
    return [this](const QString&, const std::string& text) {
      std::unique_lock guard(lock);
      written.push_back(text);
      changed.notify_all();
      changed.wait(guard, [this] { return !isHeld; });
      return answer;
    };
  }
  void letGo() {
    const std::lock_guard guard(lock);
    isHeld = false;
    changed.notify_all();
  }
  bool waitUntilItWrites() {
    std::unique_lock guard(lock);
    return changed.wait_for(guard, std::chrono::milliseconds(kPatience), [this] { return !written.empty(); });
  }
};

class MarkKeeperTest : public testing::Test {
 protected:
  void SetUp() override {
    Frame frame = test::frame("123", "00");
    frame.channel = m_log->frames.channel("can0");
    ASSERT_TRUE(m_log->frames.append({&frame, 1}, Arrival{.now = Instant{1}}));
    m_keeper.opened(m_dir.filePath(QStringLiteral("a.log")), {.mayHaveSidecar = true}, {});
  }
  void TearDown() override { m_disk.letGo(); }
  void mark(const char* text) {
    m_log->notes.append({.frame = 1, .time = {1}, .value = note::Mark{text}});
    m_keeper.keep(m_log);
  }
  MarkKeeper::Status status() const { return m_keeper.status(bootTime()); }

  QTemporaryDir m_dir;
  SlowDisk m_disk;
  std::shared_ptr<LogDocument> m_log = std::make_shared<LogDocument>();
  MarkKeeper m_keeper{m_disk.write()};
};

TEST_F(MarkKeeperTest, WaitsForNoDiskAndWritesMarksThatCameMeanwhileTogether) {
  mark("first");
  ASSERT_TRUE(m_disk.waitUntilItWrites());
  mark("second");
  mark("third");
  mark("fourth");
  EXPECT_EQ(m_keeper.status({0}), (MarkKeeper::Status{.isBusy = true}));
  m_disk.letGo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return status() == MarkKeeper::Status{}; }, kPatience));
  ASSERT_EQ(m_disk.written.size(), 2u);
  EXPECT_EQ(m_disk.written[0].find("second"), std::string::npos);
  for (const char* text : {"first", "second", "third", "fourth"})
    EXPECT_NE(m_disk.written[1].find(text), std::string::npos) << text;
}

TEST_F(MarkKeeperTest, SaysOfADiskThatHangsThatItDoesNotAnswer) {
  mark("first");
  ASSERT_TRUE(m_disk.waitUntilItWrites());
  const MarkKeeper::Status hung = m_keeper.status(bootTime() + MarkKeeper::kHangs + 1s);
  EXPECT_FALSE(hung.isBusy);
  EXPECT_EQ(hung.unkept, UnkeptMarks{UnkeptMarks::Why::NoAnswer});
}

TEST_F(MarkKeeperTest, SaysWhyMarksAreInMemoryAloneUntilTheyAreSavedElsewhere) {
  m_disk.answer = QStringLiteral("disk full");
  m_disk.letGo();
  mark("first");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !status().isBusy; }, kPatience));
  EXPECT_EQ(status().unkept, (UnkeptMarks{UnkeptMarks::Why::CannotWrite, QStringLiteral("disk full")}));
  m_keeper.forget();
  EXPECT_EQ(status(), MarkKeeper::Status{});
}

TEST_F(MarkKeeperTest, StillWritesThoseOfALogThatWasLeft) {
  mark("first");
  ASSERT_TRUE(m_disk.waitUntilItWrites());
  mark("second");
  m_keeper.opened(m_dir.filePath(QStringLiteral("b.log")), {.mayHaveSidecar = true}, {});
  EXPECT_EQ(status(), MarkKeeper::Status{}) << "of the log that is open";
  m_disk.letGo();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const std::lock_guard guard(m_disk.lock);
        return m_disk.written.size() == 2;
      },
      kPatience));
}

}  // namespace
}  // namespace deckpipe
