// SPDX-License-Identifier: GPL-3.0-or-later
#include "ctl/changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "support/frames.h"

namespace deckpipe::ctl {
namespace {

constexpr char kAnnouncesA[] = "FF83150206021A0B";

struct WatchedBus : testing::Test {
  WatchedBus& hear(std::string_view id, std::string_view data) {
    const Frame frame = test::frame(id, data, 0, m_now.ns);
    EXPECT_TRUE(m_log->frames.append({&frame, 1}));
    return *this;
  }
  WatchedBus& note(NoteValue value) {
    m_log->notes.append({.frame = m_log->frames.count(), .time = m_now, .value = std::move(value)});
    return *this;
  }
  WatchedBus& pass(Duration d) {
    m_now = m_now + d;
    return *this;
  }
  // What was written since the last call, of each line its event and what stands behind the channel.
  std::vector<std::string> told() {
    LogView view;
    view.document = m_log;
    view.cursor = {m_log->frames.count(), m_now};
    m_follower.follow(view);
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < m_out.size();) {
      const std::size_t end = m_out.find('\n', at);
      const std::string line = m_out.substr(at, end - at);
      constexpr std::string_view kEvent = R"({"event":")", kChannel = R"("channel":"can0")";
      const std::size_t word = kEvent.size(), behind = line.find(kChannel) + kChannel.size();
      lines.push_back(line.substr(word, line.find('"', word) - word) + " " +
                      line.substr(behind, line.size() - behind - 1));
      at = end + 1;
    }
    m_out.clear();
    return lines;
  }

  std::shared_ptr<LogDocument> m_log = std::make_shared<LogDocument>();
  BusFollower m_follower;
  std::string m_out;
  Changes m_changes{m_follower, {0}, "can0", m_out};
  Instant m_now{1'000'000'000};
};

TEST_F(WatchedBus, TellsWhoseDeviceLeftThatHadNoAddressBeforeAGap) {
  hear("18EEFF80", "0B1AC22800420090").hear("18EFFF80", kAnnouncesA);
  hear("18EEFF80", "0100200000000000");  // a lower NAME takes the address
  told();
  note(note::LinkDown{}).pass(1s).note(note::LinkUp{}).pass(1ms);
  std::vector<std::string> left = told();
  std::erase_if(left, [](const std::string& line) { return !line.starts_with("device_left"); });
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0], R"(device_left ,"pin":"1032AE100801035","address":null)");
}

TEST_F(WatchedBus, TellsWhatIsStaleOnceThoughThePinIsFormerBehindAGap) {
  hear("18EFFF80", kAnnouncesA).hear("18EFFF80", "011D940371000041").pass(1s);
  const auto stale = [this] {
    std::vector<std::string> lines = told();
    std::erase_if(lines, [](const std::string& line) {
      return !line.starts_with("stale") && !line.starts_with("fresh") && !line.starts_with("pin_former");
    });
    return lines;
  };
  EXPECT_EQ(stale().size(), 1u);
  note(note::LinkDown{}).pass(1s).note(note::LinkUp{}).pass(5s);
  const std::vector<std::string> lines = stale();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].starts_with("pin_former")) << lines[0];
}

TEST_F(WatchedBus, TellsWhenAJoystickBeginsTimesOutIsOutrankedAndEnds) {
  const auto sticks = [this] {
    std::vector<std::string> lines = told();
    std::erase_if(lines, [](const std::string& line) { return !line.starts_with("joystick_"); });
    for (std::string& line : lines) line.resize(std::min(line.find(",\"since\""), line.size()));
    return lines;
  };
  using Lines = std::vector<std::string>;
  constexpr char kDeflected[] = "107D046400100000";
  hear("0CFDD634", kDeflected);
  EXPECT_EQ(sticks(), Lines{R"(joystick_began ,"address":52)"});
  pass(20ms).hear("0CFDD633", kDeflected).pass(20ms).hear("0CFDD634", kDeflected);
  EXPECT_EQ(sticks(),
            (Lines{R"(joystick_began ,"address":51)", R"(joystick_outranked ,"address":52,"axis":1,"by":51)",
                   R"(joystick_outranked ,"address":52,"axis":2,"by":51)"}));
  pass(50ms).hear("0CFDD634", kDeflected).pass(50ms).hear("0CFDD634", kDeflected).pass(90ms);
  hear("0CFDD634", kDeflected);
  EXPECT_EQ(sticks(),
            (Lines{R"(joystick_timed_out ,"address":51)", R"(joystick_outranked_over ,"address":52,"axis":1)",
                   R"(joystick_outranked_over ,"address":52,"axis":2)"}));
  pass(3s);
  EXPECT_EQ(sticks(), (Lines{R"(joystick_timed_out ,"address":52)", R"(joystick_ended ,"address":51)",
                             R"(joystick_ended ,"address":52)"}))
      << "each at its own time";
}

TEST_F(WatchedBus, TellsOnceThatAJoystickEndsBehindAGapAndBeginsAnew) {
  constexpr char kCentred[] = "0100010000000000";
  hear("0CFDD633", kCentred);
  told();
  note(note::LinkDown{}).pass(5s);
  EXPECT_EQ(told().size(), 1u);
  note(note::LinkUp{}).pass(5s).hear("0CFDD633", kCentred);
  std::vector<std::string> lines = told();
  std::erase_if(lines, [](const std::string& line) { return !line.starts_with("joystick_"); });
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0].starts_with(R"(joystick_ended ,"address":51)")) << lines[0];
  EXPECT_EQ(lines[1], R"(joystick_began ,"address":51)");
}

TEST_F(WatchedBus, TellsNothingOfAJoystickThatGoesOnBehindAGap) {
  constexpr char kCentred[] = "0100010000000000";
  hear("0CFDD633", kCentred).note(note::LinkDown{}).pass(5s).note(note::LinkUp{}).pass(1s);
  told();
  hear("0CFDD633", kCentred).hear("0CFDD634", kCentred);  // and of one that may have sent before
  const std::vector<std::string> lines = told();
  EXPECT_EQ(std::ranges::count_if(lines, [](const auto& line) { return line.starts_with("joystick_"); }), 0);
}

}  // namespace
}  // namespace deckpipe::ctl
