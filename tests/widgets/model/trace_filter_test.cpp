// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trace_filter.h"

#include <gtest/gtest.h>

#include <string>

#include "model/log_walk.h"
#include "support/logs.h"

namespace deckpipe {
namespace {

constexpr const char* kFilterLog =
    "(1700000000.000000) can0 18EFFF80#FF83150206021A0B\n"    // 1 announcement: 80 is Akron
    "(1700000000.100000) can0 18EFFF80#011D940371000041\n"    // 2 rotation 47.3, elevation -5.5
    "(1700000000.200000) can0 18EFFF80#81FED401C280\n"        // 3 rotation soft limits
    "(1700000000.300000) can1 5A4#4300500116699803\n"         // 4 SDO read response
    "(1700000000.400000) can1 724#R\n"                        // 5 remote
    "(1700000000.500000) can0 20000088#0000000000000000\n"    // 6 error frame
    "(1700000000.600000) can0 18EFFF80#011D94\n"              // 7 malformed
    "(1700000000.700000) can0 0CFDD633#107D046400100000 T\n"  // 8 joystick, sent
    "(1700000000.800000) can0 18EF81A0#FE0102030405\n"        // 9 ambiguous
    "(1700000000.900000) can0 18EF8005#02 T\n"                // 10 fault poll
    "(1700000001.000000) can0 18EF0580#0200200000000B\n"      // 11 fault response: internal fuse
    "(1700000001.100000) can0 18EFFF80#01FFFFFFF4800004\n";   // 12 rotation not fitted

// Numbers, from 1, of the frames that pass: "2 12".
std::string passing(TraceFilter filter, const char* text = kFilterLog) {
  const auto log = test::logOfText(text);
  filter.bind(log->frames);
  LogWalk walk(*log, 0);
  std::string numbers;
  for (std::uint64_t i = 0; i < log->frames.count(); ++i) {
    const Instant time = log->frames.timeAt(i);
    const Classified what = walk.take(log->frames[i], time);
    if (!filter.matches({log->frames[i], i, time, what})) continue;
    if (!numbers.empty()) numbers += ' ';
    numbers += std::to_string(i + 1);
  }
  return numbers;
}

std::string passing(const char* expression, const char* text = kFilterLog) {
  const auto filter = TraceFilter::parse(QString::fromUtf8(expression));
  if (!filter) return "error: " + filter.error().text.toStdString();
  return passing(filter.value(), text);
}

struct Case {
  const char* expression;
  const char* passes;
};

class TraceFilterPasses : public testing::TestWithParam<Case> {};

TEST_P(TraceFilterPasses, TheFramesItNames) { EXPECT_EQ(passing(GetParam().expression), GetParam().passes); }

INSTANTIATE_TEST_SUITE_P(
    Expressions, TraceFilterPasses,
    testing::Values(
        Case{"", "1 2 3 4 5 6 7 8 9 10 11 12"}, Case{"  ", "1 2 3 4 5 6 7 8 9 10 11 12"}, Case{"id=5A4", "4"},
        Case{"id=000005A4", ""}, Case{"id=18efff80", "1 2 3 7 12"}, Case{"id=18EFxx80", "1 2 3 7 11 12"},
        Case{"id=xA4", "4"}, Case{"id=500-7FF", "4 5"}, Case{"id=18EF0000-18EFFFFF", "1 2 3 7 9 10 11 12"},
        Case{"id>700", "5"}, Case{"id<=5A4", "4"}, Case{"pgn=EF00", "1 2 3 7 9 10 11 12"},
        Case{"pgn=FDD6,EE00", "8"}, Case{"pgn!=ef00", "4 5 6 8"}, Case{"sa=80", "1 2 3 7 11 12"},
        Case{"da=80", "10"}, Case{"da=FF", "1 2 3 7 12"}, Case{"sa=0x33", "8"}, Case{"node=24", "4 5"},
        Case{"prio=3", "8"}, Case{"prio<6", "8"}, Case{"type=01", "2 7 12"}, Case{"type=81-FF", "1 3 9"},
        Case{"b1=43", "4"}, Case{"b8=41", "2"}, Case{"len=3", "7"}, Case{"len<3", "5 10"},
        Case{"frame=2-4", "2 3 4"}, Case{"frame>=11", "11 12"}, Case{"t>=0.9", "10 11 12"},
        Case{"t<0.15", "1 2"}, Case{"t=0.3", "4"}, Case{"ch=can1", "4 5"},
        Case{"ch~can", "1 2 3 4 5 6 7 8 9 10 11 12"}, Case{"dir=tx", "8 10"}, Case{"dir=TX err", ""},
        Case{"data=02", "10"}, Case{"data~\"01 1D\"", "2 7"}, Case{"data=\"01 1D 94\"", "7"},
        Case{"data~\"01 xx 94\"", "2 7"}, Case{"data=\"01 FF xx xx xx xx xx xx\"", "12"},
        Case{"name~\"soft limits\"", "3"}, Case{"name~SOFT", "3"},
        Case{"name=position_limit_status", "2 7 12"}, Case{"name=\"Position / limit status\"", "2 12"},
        Case{"name~malformed", "7"}, Case{"name~\"error frame\"", "6"},
        Case{"family=akron", "2 3 7 10 11 12"}, Case{"family=canopen,j1939", "4 8"}, Case{"err", "6"},
        Case{"remote", "5"}, Case{"malformed", "7"}, Case{"ambiguous", "9"},
        Case{"decoded", "1 2 3 4 8 10 11 12"}, Case{"presumed", "1"}, Case{"jump", ""},
        Case{"rotation_deg>30", "2"}, Case{"rotation_deg=47.3", "2"}, Case{"elevation_deg<0", "2"},
        Case{"rotation_deg=none", "12"}, Case{"rotation_state=not_fitted", "12"},
        Case{"faults=internal_fuse", "11"}, Case{"faults~fuse", "11"}, Case{"pcode_error=11", "11"},
        Case{"oscillating=on", "3"}, Case{"oscillating=off", ""}, Case{"index=0x5000", "4"},
        Case{"pin~0315", ""}, Case{"device_type=1051,1032", "1"},
        Case{"pgn=EF00 and sa=80 and not malformed", "1 2 3 11 12"},
        Case{"pgn=EF00 sa=80 !malformed", "1 2 3 11 12"}, Case{"err or remote", "5 6"},
        Case{"err || remote && ch=can1", "5 6"}, Case{"(err or remote) and ch=can1", "5"},
        Case{"not (err or pgn=EF00)", "4 5 8"}, Case{"not not err", "6"}, Case{"NOT err AND dir=tx", "8 10"},
        Case{"soft limits", "3"}, Case{"\"soft limits\"", "3"}, Case{"limits soft", "3"},
        Case{"\"limits soft\"", ""}, Case{"not can1 and remote", ""}, Case{"47.3 and sa=80", "2"},
        Case{"18EFFF80", "1 2 3 7 12"}, Case{"can1 or \"1d 94\"", "2 4 5 7"}, Case{"sa=80 \"soft\"", "3"}));

TEST(TraceFilter, FindsTextInTheCells) {
  EXPECT_EQ(passing(TraceFilter::containing(QStringLiteral("1d 94"))), "2 7");
  EXPECT_EQ(passing(TraceFilter::containing(QStringLiteral("47.3"))), "2");
  EXPECT_EQ(passing(TraceFilter::containing(QStringLiteral("can1"))), "4 5");
  EXPECT_EQ(passing(TraceFilter::containing(QStringLiteral("0000000.7"))), "8");
  EXPECT_EQ(passing(TraceFilter::containing(QStringLiteral("soft LIMITS"))), "3");
  EXPECT_EQ(passing(TraceFilter::containing(QStringLiteral("nowhere"))), "");
}

TEST(TraceFilter, SaysWhetherMeaningDecides) {
  const auto needs = [](const char* text) {
    return TraceFilter::parse(QString::fromUtf8(text)).value().needsRoles();
  };
  EXPECT_FALSE(needs("pgn=EF00 and data~01"));
  EXPECT_TRUE(needs("pgn=EF00 and malformed"));
  EXPECT_TRUE(needs("enable=on"));
}

struct Wrong {
  const char* expression;
  int at, length;
  const char* says;
};

class TraceFilterSays : public testing::TestWithParam<Wrong> {};

TEST_P(TraceFilterSays, WhereAndWhatWasExpected) {
  const auto filter = TraceFilter::parse(QString::fromUtf8(GetParam().expression));
  ASSERT_FALSE(filter);
  EXPECT_EQ(filter.error().at, GetParam().at);
  EXPECT_EQ(filter.error().length, GetParam().length);
  EXPECT_TRUE(filter.error().text.contains(QString::fromUtf8(GetParam().says)))
      << filter.error().text.toStdString();
}

INSTANTIATE_TEST_SUITE_P(
    Mistakes, TraceFilterSays,
    testing::Values(Wrong{"foo=1", 0, 3, "no key"}, Wrong{"\"\"", 0, 2, "key"},
                    Wrong{"id", 2, 0, "= != < <= > >="}, Wrong{"id=", 3, 0, "value"},
                    Wrong{"id=zz", 3, 2, "identifier"}, Wrong{"id=FFFFFFFF", 3, 8, "identifier"},
                    Wrong{"id=FFF", 3, 3, "identifier"}, Wrong{"sa=180", 3, 3, "FF"},
                    Wrong{"sa=80 and", 9, 0, "key"}, Wrong{"sa=80 or or", 9, 2, "key"},
                    Wrong{"(sa=80", 0, 1, "never closed"}, Wrong{"sa=80)", 5, 1, "never opened"},
                    Wrong{"name~\"soft", 5, 5, "quotes"}, Wrong{"data=123", 5, 3, "bytes"},
                    Wrong{"data=\"00 11 22 33 44 55 66 77 88\"", 5, 28, "bytes"},
                    Wrong{"sa~80", 2, 1, "compared"}, Wrong{"name>5", 4, 1, "compared"},
                    Wrong{"rotation_deg>left", 13, 4, "number"}, Wrong{"enable=yes", 7, 3, "off, on"},
                    Wrong{"dir=up", 4, 2, "rx"}, Wrong{"family=dog", 7, 3, "akron"},
                    Wrong{"t=soon", 2, 4, "number"}, Wrong{"len<1,2", 5, 1, "several"},
                    Wrong{"sa=80 , sa=81", 8, 2, "hex"}));

TEST(TraceFilter, EndsOnHostileDepth) {
  EXPECT_FALSE(TraceFilter::parse(QString(100'000, u'(')));
  EXPECT_FALSE(TraceFilter::parse(QString(100'000, u'!')));
  QString longOne = QStringLiteral("sa=80");
  for (int i = 0; i < 200; ++i) longOne += QStringLiteral(" or sa=81");
  EXPECT_TRUE(TraceFilter::parse(longOne));
}

TEST(TraceFilterOfStandardGroups, FindsThemByTheNameShownAndByTheirAcronym) {
  constexpr const char* kTruckLog =
      "(1.000000) can0 0CF00400#FFFFFF6813FFFFFF\n"   // 1 EEC1
      "(1.100000) can0 18FEF500#FFFFFFFFFFFFFFFF\n"   // 2 AMB
      "(1.200000) can0 18FF1234#00\n"                 // 3 proprietary B
      "(1.300000) can0 18FEAA00#00\n"                 // 4 without a name here
      "(1.400000) can0 004#00\n"                      // 5 an 11-bit identifier
      "(1.500000) can0 18EFFF80#FF83150206021A0B\n";  // 6 decoded, of proprietary A
  EXPECT_EQ(passing("name=eec1", kTruckLog), "1");
  EXPECT_EQ(passing("name~\"ambient cond\"", kTruckLog), "2");
  EXPECT_EQ(passing("ambient", kTruckLog), "2");
  EXPECT_EQ(passing("name~proprietary", kTruckLog), "3");
  EXPECT_EQ(passing("name!~proprietary", kTruckLog), "1 2 4 5 6");
}

std::vector<std::string> completed(const char* text, int cursor = -1) {
  const QString line = QString::fromUtf8(text);
  std::vector<std::string> words;
  for (const auto& entry : filterCompletions(line, cursor < 0 ? static_cast<int>(line.size()) : cursor,
                                             {QStringLiteral("can0"), QStringLiteral("vcan1")})
                               .entries)
    words.push_back(entry.word.toStdString());
  return words;
}

TEST(FilterCompletions, OfferKeysAndThenTheirValues) {
  EXPECT_EQ(completed("pg"), std::vector<std::string>{"pgn"});
  EXPECT_EQ(completed("sa=80 and rotation_d"), std::vector<std::string>{"rotation_deg"});
  EXPECT_EQ(completed("ch="), (std::vector<std::string>{"can0", "vcan1"}));
  EXPECT_EQ(completed("ch = v"), std::vector<std::string>{"vcan1"});
  EXPECT_EQ(completed("enable="), (std::vector<std::string>{"off", "on"}));
  EXPECT_EQ(completed("name~\"rotation_"), std::vector<std::string>{"rotation_soft_limits"});
  EXPECT_EQ(completed("name=EEC"), (std::vector<std::string>{"EEC2", "EEC1", "EEC3"}));
  EXPECT_EQ(completed("pgn=F004"), std::vector<std::string>{});
  EXPECT_EQ(completed("pgn=FEF5"), std::vector<std::string>{});
  EXPECT_EQ(completed("pgn=FEF"), (std::vector<std::string>{"FEF0", "FEF1", "FEF2", "FEF3", "FEF5", "FEF6",
                                                            "FEF7", "FEF8", "FEFC"}));
  EXPECT_EQ(completed("sa=2"), (std::vector<std::string>{"21", "24", "25", "27", "28", "2F"}));
  EXPECT_EQ(completed("dir=tx"), std::vector<std::string>{});
  EXPECT_EQ(completed("pg sa=80", 2), std::vector<std::string>{"pgn"});
  EXPECT_EQ(filterCompletions(QStringLiteral("sa=80 mal"), 9, {}).from, 6);
}

}  // namespace
}  // namespace deckpipe
