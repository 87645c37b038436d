// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/candump_line.h"

#include <gtest/gtest.h>

#include <ostream>
#include <random>

#include "log/candump_parser.h"

namespace deckpipe {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStamp = 1'700'000'000'123'456'000;

Frame frameOf(std::uint32_t id, std::initializer_list<std::uint8_t> data, std::int64_t stamp = kStamp) {
  Frame frame;
  frame.stamp = stamp;
  frame.id = id;
  std::copy(data.begin(), data.end(), frame.data.begin());
  frame.length = static_cast<std::uint8_t>(data.size());
  return frame;
}
Frame with(Frame frame, std::uint8_t flags) {
  frame.flags = flags;
  return frame;
}
Frame remote(std::uint32_t id, std::uint8_t length, std::int64_t stamp = kStamp) {
  Frame frame = frameOf(id | kRemoteBit, {}, stamp);
  frame.length = length;
  return frame;
}

constexpr std::uint32_t kWide = kExtendedBit | 0x18EF'FF80;
const Frame kEight = frameOf(kWide, {0x01, 0x1D, 0x94, 0x03, 0x71, 0x00, 0x00, 0x41});
const Frame kEightNoStamp = frameOf(kWide, {0x01, 0x1D, 0x94, 0x03, 0x71, 0x00, 0x00, 0x41}, kNoStamp);

struct Readable {
  const char* name;
  std::string line;
  Frame frame;
  const char* interface = "can0";
};
void PrintTo(const Readable& row, std::ostream* out) { *out << row.line; }

class CandumpLineReads : public testing::TestWithParam<Readable> {};

TEST_P(CandumpLineReads, AsOneFrame) {
  std::string scratch;
  const TextLine line = readCandumpLine(GetParam().line, scratch);
  ASSERT_EQ(line.kind, TextLine::Kind::Frame) << skippedText(line.reason);
  const Frame& expected = GetParam().frame;
  EXPECT_EQ(line.frame.stamp, expected.stamp);
  EXPECT_EQ(line.frame.id, expected.id);
  EXPECT_EQ(line.frame.length, expected.length);
  EXPECT_EQ(line.frame, expected);
  EXPECT_EQ(line.interface, GetParam().interface);
}

INSTANTIATE_TEST_SUITE_P(
    LogForm, CandumpLineReads,
    testing::Values(
        Readable{"Usual", "(1700000000.123456) can0 18EFFF80#011D940371000041", kEight},
        Readable{"LowerCase", "(1700000000.123456) can0 18efff80#011d940371000041", kEight},
        Readable{"CarriageReturn", "(1700000000.123456) can0 18EFFF80#011D940371000041\r", kEight},
        Readable{"Received", "(1700000000.123456) can0 18EFFF80#011D940371000041 R", kEight},
        Readable{"Sent", "(1700000000.123456) can0 18EFFF80#011D940371000041 T", with(kEight, Frame::kSent)},
        Readable{"DataWithDots", "(1700000000.123456) can0 18EFFF80#01.1D.94.03.71.00.00.41", kEight},
        Readable{"RawDlc", "(1700000000.123456) can0 18EFFF80#011D940371000041_E", kEight},
        Readable{"InterfaceAlignedRight", "(1700000000.123456)   can0 18EFFF80#011D940371000041", kEight},
        Readable{"NarrowIdentifier", "(1700000000.123456) can0 7FF#01", frameOf(0x7FF, {1})},
        Readable{"NoData", "(1700000000.123456) can0 000#", frameOf(0, {})},
        Readable{"WideIdentifierOfFewBits", "(1700000000.123456) can0 00000001#",
                 frameOf(kExtendedBit | 1, {})},
        Readable{"Error", "(1700000000.123456) can0 20000004#0008000000000000",
                 frameOf(kErrorBit | 4, {0, 8, 0, 0, 0, 0, 0, 0})},
        Readable{"Remote", "(1700000000.123456) can0 123#R", remote(0x123, 0)},
        Readable{"RemoteWithLength", "(1700000000.123456) can0 18EFFF80#R8", remote(kWide, 8)},
        Readable{"RemoteLowerCase", "(1700000000.123456) can0 123#r3", remote(0x123, 3)},
        Readable{"RemoteRawDlc", "(1700000000.123456) can0 123#R8_9 T", with(remote(0x123, 8), Frame::kSent)},
        Readable{"Nanoseconds", "(1700000000.123456789) can0 123#", frameOf(0x123, {}, kStamp + 789)},
        Readable{"Milliseconds", "(1700000000.123) can0 123#", frameOf(0x123, {}, 1'700'000'000'123'000'000)},
        Readable{"OneDecimal", "(0.5) can0 123#", frameOf(0x123, {}, kSecond / 2)},
        Readable{"WholeSeconds", "(12) can0 123#", frameOf(0x123, {}, 12 * kSecond)},
        Readable{"Negative", "(-1.500000) can0 123#", frameOf(0x123, {}, -3 * kSecond / 2)},
        Readable{"LargestTime", "(9223372036.854775807) can0 123#",
                 frameOf(0x123, {}, std::numeric_limits<std::int64_t>::max())},
        Readable{"NoStamp", "can0 123#01", frameOf(0x123, {1}, kNoStamp)},
        Readable{"LongInterface", "(1700000000.123456) slcan_of_the_truck 123#01", frameOf(0x123, {1}),
                 "slcan_of_the_truck"},
        Readable{"NumberedInterface", "(1700000000.123456) 1 123#01", frameOf(0x123, {1}), "1"}),
    [](const auto& row) { return row.param.name; });

INSTANTIATE_TEST_SUITE_P(
    ScreenForm, CandumpLineReads,
    testing::Values(
        Readable{"Usual", "  can0  18EFFF80   [8]  01 1D 94 03 71 00 00 41", kEightNoStamp},
        Readable{"AbsoluteTime", " (1700000000.123456)  can0  18EFFF80   [8]  01 1D 94 03 71 00 00 41",
                 kEight},
        Readable{"Date", " (2023-11-14 22:13:20.123456)  can0  18EFFF80   [8]  01 1D 94 03 71 00 00 41",
                 kEight},
        Readable{"DateOfALeapDay", "(2024-02-29 00:00:00.000000) can0 123 [0]",
                 frameOf(0x123, {}, 1'709'164'800 * kSecond)},
        Readable{"NarrowIndented", "  can0       123   [2]  11 22", frameOf(0x123, {0x11, 0x22}, kNoStamp)},
        Readable{"OneDigitIdentifier", "vcan0 E [1] 8B", frameOf(0xE, {0x8B}, kNoStamp), "vcan0"},
        Readable{"WithText", "  can0  123   [2]  27 20                     '' '",
                 frameOf(0x123, {0x27, 0x20}, kNoStamp)},
        Readable{"ReceivedInfo", "  can0  RX - -  123   [1]  11", frameOf(0x123, {0x11}, kNoStamp)},
        Readable{"SentInfo", "  can0  TX - -  123   [1]  11",
                 with(frameOf(0x123, {0x11}, kNoStamp), Frame::kSent)},
        Readable{"InfoWithFlags", "  can0  RX B E  123   [1]  11", frameOf(0x123, {0x11}, kNoStamp)},
        Readable{"Remote", "  can0  123   [0]  remote request", remote(0x123, 0, kNoStamp)},
        Readable{"RemoteWithLength", "  can0  123   [8]  remote request", remote(0x123, 8, kNoStamp)},
        Readable{"Error", "  can0  20000088   [8]  00 00 00 00 00 00 00 00   ERRORFRAME",
                 frameOf(kErrorBit | 0x88, {0, 0, 0, 0, 0, 0, 0, 0}, kNoStamp)},
        Readable{"RawDlc", "  can0  321   {B}  11 22 33 44 55 66 77 88",
                 frameOf(0x321, {0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0x88}, kNoStamp)},
        Readable{"BytesSwapped", "  can0  123   [3]  33`22`11   `3\".`",
                 frameOf(0x123, {0x11, 0x22, 0x33}, kNoStamp)},
        Readable{"Binary", "  can0  123   [2]  00010001 11111110", frameOf(0x123, {0x11, 0xFE}, kNoStamp)},
        Readable{"Coloured", " \x1B[1m\x1B[34m can0  123   [1]  11\x1B[0m", frameOf(0x123, {0x11}, kNoStamp)},
        Readable{"OldForm", "<0x18efff80> [8] 01 1d 94 03 71 00 00 41 ", kEightNoStamp, ""},
        Readable{"OldFormNarrow", "<0x123> [1] 0f ", frameOf(0x123, {0x0F}, kNoStamp), ""},
        Readable{"OldFormRemote", "<0x123> [2] aa bb remote request", remote(0x123, 2, kNoStamp), ""},
        Readable{"OldFormWithInterface", "  can0  <0x18efff80> [8] 01 1d 94 03 71 00 00 41", kEightNoStamp}),
    [](const auto& row) { return row.param.name; });

struct Rejected {
  const char* name;
  std::string line;
  Skipped reason;
};
void PrintTo(const Rejected& row, std::ostream* out) { *out << row.line; }

class CandumpLineRejects : public testing::TestWithParam<Rejected> {};

TEST_P(CandumpLineRejects, WithTheReason) {
  std::string scratch;
  const TextLine line = readCandumpLine(GetParam().line, scratch);
  ASSERT_EQ(line.kind, TextLine::Kind::Skipped);
  EXPECT_EQ(skippedText(line.reason), skippedText(GetParam().reason));
}

const std::string kTime = "(1700000000.123456) ";

INSTANTIATE_TEST_SUITE_P(
    , CandumpLineRejects,
    testing::Values(
        Rejected{"CanFd", kTime + "can0 123##1112233", Skipped::CanFd},
        Rejected{"CanFdWithoutData", kTime + "can0 123##0", Skipped::CanFd},
        Rejected{"CanFdWithDots", kTime + "can0 12345678##1.11.22", Skipped::CanFd},
        Rejected{"CanFdOnScreen", "  can0  123  [08]  11 22 33 44 55 66 77 88", Skipped::CanFd},
        Rejected{"CanFdOfManyBytesOnScreen", "  can0  123  [12]  11 22 33 44 55 66 77 88 99 AA BB CC",
                 Skipped::CanFd},
        Rejected{"CanFdWithoutFlags", kTime + "can0 123##", Skipped::Data},
        Rejected{"CanXl", kTime + "can0 45123#81:00:12345678#11223344.556677", Skipped::CanXl},
        Rejected{"CanXlOnScreen", "  can0  123 [0003] (45|81:00:12345678) 11 22 33", Skipped::CanXl},
        Rejected{"RecorderDropped", "DROPCOUNT: dropped 2 CAN frames on 'can0' socket (total drops 2)",
                 Skipped::RecorderDropped},
        Rejected{"Prose", "hello world", Skipped::Layout}, Rejected{"OneWord", "hello", Skipped::Layout},
        Rejected{"Number", "0", Skipped::Layout},
        Rejected{"PeakTrace", "     1)      1059.9  Rx         0300  7  00 00 00 00 04 00 00 ",
                 Skipped::Layout},
        Rejected{"StampAlone", "(1700000000.123456)", Skipped::Layout},
        Rejected{"EndsAfterInterface", kTime + "can0", Skipped::Layout},
        Rejected{"EndsInStamp", "(1700000000.1", Skipped::Layout},
        Rejected{"EndsInIdentifier", kTime + "can0 18EF", Skipped::Layout},
        Rejected{"EndsInByte", kTime + "can0 123#112", Skipped::Data},
        Rejected{"TextInStamp", "(yesterday) can0 123#11", Skipped::Time},
        Rejected{"EmptyStamp", "() can0 123#11", Skipped::Time},
        Rejected{"TwoPoints", "(1.2.3) can0 123#11", Skipped::Time},
        Rejected{"PointWithoutDecimals", "(12.) can0 123#11", Skipped::Time},
        Rejected{"NoSuchDay", "(2023-02-29 00:00:00.0) can0 123#11", Skipped::Time},
        Rejected{"NoSuchHour", "(2023-02-20 24:00:00.0) can0 123#11", Skipped::Time},
        Rejected{"TimeJustTooLate", "(9223372036.854775808) can0 123#11", Skipped::TimeRange},
        Rejected{"TimeFarTooLate", "(99999999999999999999999.5) can0 123#11", Skipped::TimeRange},
        Rejected{"YearTooLate", "(9999-12-31 00:00:00.0) can0 123#11", Skipped::TimeRange},
        Rejected{"InterfaceNotAscii", kTime + "c\xC3\xA4n0 123#11", Skipped::Interface},
        Rejected{"InterfaceTooLong", kTime + std::string(64, 'c') + " 123#11", Skipped::Interface},
        Rejected{"NarrowIdentifierTooLarge", kTime + "can0 800#11", Skipped::Identifier},
        Rejected{"WideIdentifierTooLarge", kTime + "can0 40000000#11", Skipped::Identifier},
        Rejected{"FourDigitIdentifier", kTime + "can0 1234#11", Skipped::Identifier},
        Rejected{"NineDigitIdentifier", kTime + "can0 123456789#11", Skipped::Identifier},
        Rejected{"NoIdentifier", kTime + "can0 #11", Skipped::Identifier},
        Rejected{"IdentifierNotHexadecimal", kTime + "can0 12G#11", Skipped::Identifier},
        Rejected{"OddDigits", kTime + "can0 123#11223", Skipped::Data},
        Rejected{"DataNotHexadecimal", kTime + "can0 123#11xx", Skipped::Data},
        Rejected{"DotFirst", kTime + "can0 123#.11", Skipped::Data},
        Rejected{"DotLast", kTime + "can0 123#11.", Skipped::Data},
        Rejected{"RawDlcOfAShortFrame", kTime + "can0 123#1122_E", Skipped::Data},
        Rejected{"RemoteLengthTooLarge", kTime + "can0 123#R9", Skipped::Data},
        Rejected{"NineBytes", kTime + "can0 123#112233445566778899", Skipped::DataTooLong},
        Rejected{"TextBehind", kTime + "can0 123#11 X", Skipped::Layout},
        Rejected{"TwoDirections", kTime + "can0 123#11 R T", Skipped::Layout},
        Rejected{"ScreenFewerBytes", "  can0  123   [8]  11 22", Skipped::LengthMismatch},
        Rejected{"ScreenMoreBytes", "  can0  123   [1]  11 22", Skipped::LengthMismatch},
        Rejected{"ScreenNineBytes", "  can0  123   [8]  11 22 33 44 55 66 77 88 99", Skipped::DataTooLong},
        Rejected{"ScreenLengthNine", "  can0  123   [9]  11 22 33 44 55 66 77 88 99",
                 Skipped::LengthMismatch},
        Rejected{"ScreenEndsInByte", "  can0  123   [2]  11 2", Skipped::Data},
        Rejected{"ScreenLengthOpen", "  can0  123   [2", Skipped::Layout},
        Rejected{"NulInData", kTime + std::string("can0 123#11\0", 12), Skipped::Binary},
        Rejected{"NulAlone", std::string(5, '\0'), Skipped::Binary},
        Rejected{"BinaryFile",
                 "\x7F"
                 "ELF\x02\x01\x01",
                 Skipped::Binary}),
    [](const auto& row) { return row.param.name; });

TEST(CandumpLine, SkipsWhatIsNoFrameAndNoError) {
  for (const char* text : {"", "   ", "\r", "# a comment", "  # 123#11",
                           "\tcontroller-problem{tx-error-passive}", "\terror-counter-tx-rx{{128}{0}}"}) {
    std::string scratch;
    EXPECT_EQ(readCandumpLine(text, scratch).kind, TextLine::Kind::Nothing) << text;
  }
}

TEST(CandumpLine, TakesTheInterfaceFromAHeader) {
  std::string scratch;
  const TextLine line = readCandumpLine("interface = can3, family = 29, type = 3, proto = 1", scratch);
  EXPECT_EQ(line.kind, TextLine::Kind::Header);
  EXPECT_EQ(line.interface, "can3");
}

// --- The fast path

struct Outcome {
  std::vector<Frame> frames;
  std::vector<SkippedPlace> skipped;
  std::uint64_t lines = 0;
  std::vector<std::pair<LocalChannel, std::string>> channels;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome parse(CandumpParser& parser, const std::string& text) {
  TextBlock block;
  parser.parse(text.data(), text.data() + text.size(), text.data() + text.size(), block);
  return {{block.frames.begin(), block.frames.begin() + static_cast<std::ptrdiff_t>(block.count)},
          block.skipped.places(),
          block.lines,
          block.channels};
}

// Lines near the usual layout: one built from parts, then often damaged in one place.
std::string nearlyUsualLine(std::mt19937_64& random) {
  const auto pick = [&random](std::initializer_list<const char*> choices) {
    return std::string(choices.begin()[random() % choices.size()]);
  };
  const auto digits = [&random](std::size_t n, const char* alphabet, std::size_t letters) {
    std::string all;
    for (std::size_t i = 0; i < n; ++i) all += alphabet[random() % letters];
    return all;
  };
  std::string line = pick(
      {"(1700000000.", "(1700000000.", "(1700000001.", "(166.", "(9223372036.", "(-5.", "(007.", "(5) "});
  line += digits(random() % 20 ? 6 : random() % 11, "0123456789", 10) + ") ";
  line += pick({"can0", "can0", "can1", "vcan0", "x", "sevenxx", "eightxxx", "can", " can0"}) + " ";
  const std::size_t idDigits = random() % 10 == 0 ? random() % 10 : random() % 2 ? 8 : 3;
  line += (idDigits == 8 ? pick({"0", "1", "1", "1", "2", "8"}) : pick({"0", "3", "7", "8"})) +
          digits(idDigits == 0 ? 0 : idDigits - 1, "0123456789ABCDEFabcdef", 22);
  line += pick({"#", "#", "#", "#", "#", "#", "##", "#R"});
  line += digits(random() % 4   ? 16
                 : random() % 2 ? 2 * (random() % 9)
                                : random() % 20,
                 "0123456789ABCDEFabcdef", 22);
  line += pick({"", "", "", "", "", "", " R", " T", " R", " T", " X", "_E", " ", "  T", "T"}) +
          pick({"", "", "\r", " \r", "\r\r"});
  if (random() % 3 == 0) line[random() % line.size()] = static_cast<char>(random() % 256);
  return line + "\n";
}

TEST(CandumpParser, FastAndSlowPathAgreeOnEveryLine) {
  std::mt19937_64 random(20260729);
  CandumpParser fast(true), slow(false);
  std::uint64_t frames = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string text;
    for (int i = 0; i < 50; ++i) text += nearlyUsualLine(random);
    const Outcome quick = parse(fast, text), careful = parse(slow, text);
    ASSERT_EQ(quick, careful) << text;
    frames += quick.frames.size();
  }
  EXPECT_GT(frames, 40'000u) << "too few lines are readable for the test to mean anything";
  EXPECT_LT(frames, 160'000u) << "too few lines are damaged for the test to mean anything";
}

TEST(CandumpParser, EveryDigitOfTheUsualLayoutCounts) {
  const std::string usual = "(1700000000.123456) can0 18EFFF80#011D940371000041\n";
  const std::string padding(100, '#');
  for (std::size_t at = 0; at + 1 < usual.size(); ++at) {
    for (int c = 0; c < 256; ++c) {
      std::string line = usual;
      line[at] = static_cast<char>(c);
      CandumpParser fast(true), slow(false);
      ASSERT_EQ(parse(fast, usual + line + padding), parse(slow, usual + line + padding)) << line;
    }
  }
}

TEST(CandumpParser, ForgetsManyNamesWithoutMixingThemUp) {
  CandumpParser parser;
  for (int round = 0; round < 3; ++round) {
    std::string text;
    for (int i = 0; i < 1000; ++i)
      text += "(1.000000) n" + std::to_string(i) + " 123#0" + std::to_string(i % 10) + "\n";
    const Outcome outcome = parse(parser, text);
    ASSERT_EQ(outcome.frames.size(), 1000u);
    ASSERT_EQ(outcome.channels.size(), 1000u) << "new in every block, as they were forgotten";
    for (std::size_t i = 0; i < 1000; ++i) {
      const Frame& frame = outcome.frames[i];
      ASSERT_EQ(outcome.channels[static_cast<std::size_t>(frame.channel | frame.spare << 8)].second,
                "n" + std::to_string(i));
    }
  }
}

}  // namespace
}  // namespace deckpipe
