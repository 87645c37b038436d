// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/time_grain.h"

#include <gtest/gtest.h>

#include "log/log_stream.h"

namespace deckpipe {
namespace {

struct Log {
  FrameStore frames;
  SkippedList skipped;
};

// A frame a line, with each of these times in turn.
std::string logAt(const std::vector<std::string>& times, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += "(" + times[static_cast<std::size_t>(i) % times.size()] + ") can0 123#11\n";
  return text;
}

TEST(TimeGrain, IsThatOfTheStamps) {
  struct Row {
    const char* name;
    std::vector<std::string> times;
    int count;
    TimeGrain grain;
  };
  for (const Row& row : std::vector<Row>{
           {"microseconds", {"1700000000.100000"}, 50, TimeGrain::Fine},
           {"whole seconds", {"1700000000", "1700000000.000000"}, 16, TimeGrain::Seconds},
           {"too few", {"1700000000.000000"}, 15, TimeGrain::Fine},
           {"whole seconds but for one",
            {"1700000000.0", "1700000000.0", "1700000000.000001"},
            50,
            TimeGrain::Fine},
           {"fractions of ten digits", {"1700000000.4011223344"}, 1, TimeGrain::Seconds},
           {"some fractions of ten digits",
            {"1700000000.401122334", "1700000000.4011223344"},
            4,
            TimeGrain::Seconds},
           {"no times", {"0.0"}, 50, TimeGrain::None},
           {"differences", {"0.0", "0.1", "0.1", "0.1"}, 4, TimeGrain::None},
       }) {
    const std::string text = logAt(row.times, row.count);
    Log file, pipe;
    ASSERT_TRUE(readLog(BytesInMemory(text), {file.frames, file.skipped}));
    EXPECT_EQ(timeGrainOf(file.frames), row.grain) << row.name;
    LogStream stream({pipe.frames, pipe.skipped});
    for (const char c : text) stream.feed({&c, 1});
    ASSERT_TRUE(stream.finish());
    EXPECT_EQ(timeGrainOf(pipe.frames), row.grain) << row.name;
  }
}

}  // namespace
}  // namespace deckpipe
