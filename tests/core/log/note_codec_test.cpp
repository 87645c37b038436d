// SPDX-License-Identifier: GPL-3.0-or-later
// What is written today must be read by every later version: the bytes stand here as literals.
#include "log/note_codec.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "support/enums.h"
#include "support/note_samples.h"

namespace deckpipe {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytesOf(const NoteValue& value, std::uint64_t frame = 3, Instant time = {-2}) {
  Bytes out;
  appendNote(out, {frame, time, value});
  return out;
}

std::string hexOf(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string hex;
  for (const std::uint8_t byte : bytes) (hex += kDigits[byte >> 4u]) += kDigits[byte & 0xFu];
  return hex;
}

// The kind and the fields, without what all kinds have.
std::string kindAndFields(const NoteValue& value) {
  const Bytes bytes = bytesOf(value);
  return hexOf(std::span(bytes).subspan(2, 1)) + " " + hexOf(std::span(bytes).subspan(19));
}

constexpr std::string_view kPinHex = "0f313033324145313030383031303335";

TEST(NoteCodec, BeginsWithLengthKindFrameAndTime) {
  EXPECT_EQ(hexOf(bytesOf(note::LinkUp{Channel{4}}, 0x0102030405060708, {-2})),
            "1700"
            "01"
            "0807060504030201"
            "feffffffffffffff"
            "04"
            "00"
            "00000000");
}

TEST(NoteCodec, WritesEveryKindAsEveryVersionDoes) {
  const std::map<std::string_view, std::string> expected{
      {"link_up", "01 020e736f636b657463616e2063616e3090d00300"},
      {"link_down", "02 02070f4e6574776f726b20697320646f776e"},
      {"dropped", "03 020200000001000000"},
      {"locked", "04 02"},
      {"unlocked", "05 02"},
      {"mark", "06 087761746572206f6e"},
      {"drive_unsaid", "07 028100"},
      {"own_address", "08 028102"},
      {"asked", "09 0281" + std::string(kPinHex) + "06"},
      {"ask_ended", "0a 0281" + std::string(kPinHex) + "0407"},
      {"ask_waits", "0c 0281" + std::string(kPinHex) + "05"},
      {"still_waits", "0d 020500000000000000"},
      {"pipe", "0b 0281" + std::string(kPinHex) + "0108617869732e747874"},
      {"left_out", "0e 02020700000000000000"},
      {"label", "0f " + std::string(kPinHex) + "0c66726f6e742062756d706572"},
      {"added", "10 0900000000000000"},
      {"filtered", "11 1270676e3d4546303020616e642073613d3830"},
      {"angles_before", "12 0281" + std::string(kPinHex) + "0627fe0080"},
      {"ran_until", "13 "},
      {"motion_armed", "14 0281" + std::string(kPinHex) + "2c0101" + "03786362"},
      {"motion_ended", "15 02810b0132000000214e0000e8800000"},
      {"motion_late", "16 0281"},
  };
  for (const NoteValue& value : test::noteSamples()) {
    const auto found = expected.find(noteKey(value));
    ASSERT_NE(found, expected.end()) << noteKey(value) << ": " << kindAndFields(value);
    EXPECT_EQ(kindAndFields(value), found->second) << noteKey(value);
  }
}

TEST(NoteCodec, KeepsTheNumbersOfItsEnums) {
  const auto last = [](const NoteValue& value) { return bytesOf(value).back(); };
  const Request requests[] = {Request::Fault, Request::Firmware, Request::Pcode, Request::Config,
                              Request::Vista, Request::ZeroAxes, Request::Reset, Request::SetupMode};
  for (std::uint8_t n = 0; n < std::size(requests); ++n)
    EXPECT_EQ(last(note::Asked{{}, {}, {}, requests[n]}), n);
  EXPECT_EQ(test::allOf<Request>().size(), std::size(requests));
  using How = note::OwnAddress::How;
  const How hows[] = {How::Claimed, How::Lost,     How::CannotClaim, How::SameName,
                      How::Locked,  How::LinkLost, How::InUse,       How::Disputed};
  for (std::uint8_t n = 0; n < std::size(hows); ++n)
    EXPECT_EQ(last(note::OwnAddress{{}, {}, hows[n]}), n + 1);
  EXPECT_EQ(test::allOf<How>().size(), std::size(hows));
  const RequestEnd ends[] = {RequestEnd::None,      RequestEnd::Answered,     RequestEnd::WrongAnswer,
                             RequestEnd::NoAnswer,  RequestEnd::Cancelled,    RequestEnd::LinkLost,
                             RequestEnd::Gone,      RequestEnd::AnsweredLate, RequestEnd::AddressLost,
                             RequestEnd::NotOnBus,  RequestEnd::WentOutLate,  RequestEnd::GoneWithInterface,
                             RequestEnd::CannotTell};
  for (std::uint8_t n = 0; n < std::size(ends); ++n)
    EXPECT_EQ(last(note::RequestEnded{{}, {}, {}, Request::Fault, ends[n]}), n);
  EXPECT_EQ(test::allOf<RequestEnd>().size(), std::size(ends));
  const PipeEvent events[] = {PipeEvent::FileBegan,      PipeEvent::FileDone, PipeEvent::FileCancelled,
                              PipeEvent::FileAborted,    PipeEvent::Stalled,  PipeEvent::AckLate,
                              PipeEvent::Resent,         PipeEvent::Skipped,  PipeEvent::Dropped,
                              PipeEvent::DeviceRestarted};
  for (std::uint8_t n = 0; n < std::size(events); ++n) {
    const Bytes bytes = bytesOf(note::Pipe{{}, {}, {}, events[n], {}});
    EXPECT_EQ(bytes[bytes.size() - 2], n);
  }
  EXPECT_EQ(test::allOf<PipeEvent>().size(), std::size(events));
  using enum MotionCause;
  const MotionCause causes[] = {
      None,      Released, Disarmed,    HandNotSeen,        Gap,         HeldTooLong,  NotHeldTooLong,
      Locked,    LinkLost, SourceTaken, ControllerAppeared, MonitorGone, EnableOff,    MonitorChanged,
      StowAsked, NotOnBus, WriteFailed, BusTrouble,         ClockJumped, WouldOutrank, WrongWay,
      NoMotion,  AtStop,   AtSoftLimit, Outranked,          NoPermissive};
  for (std::uint8_t n = 0; n < std::size(causes); ++n) {
    const Bytes bytes = bytesOf(note::MotionEnded{{}, {}, causes[n]});
    EXPECT_EQ(bytes[bytes.size() - 14], n);
  }
  EXPECT_EQ(test::allOf<MotionCause>().size(), std::size(causes));
  const LinkFault faults[] = {LinkFault::None,          LinkFault::NoPlugin,     LinkFault::NoInterface,
                              LinkFault::InterfaceDown, LinkFault::WrongBitRate, LinkFault::BitRateRefused,
                              LinkFault::NoAnswer,      LinkFault::Gone,         LinkFault::Other};
  for (std::uint8_t n = 0; n < std::size(faults); ++n) {
    const Bytes bytes = bytesOf(note::LinkDown{{}, faults[n], {}});
    EXPECT_EQ(bytes[bytes.size() - 2], n);
  }
  EXPECT_EQ(test::allOf<LinkFault>().size(), std::size(faults));
}

TEST(NoteCodec, KeepsTheNumbersOfWhyFramesAreLeftOut) {
  using Why = note::LeftOut::Why;
  const Why whys[] = {Why::CanFd,        Why::NotClassic, Why::CanXl,  Why::Unreadable,
                      Why::RecorderLost, Why::NotWhole,   Why::Damaged};
  for (std::uint8_t n = 0; n < std::size(whys); ++n) {
    const Bytes bytes = bytesOf(note::LeftOut{{}, whys[n], 0});
    EXPECT_EQ(bytes[bytes.size() - 9], n + 1);
  }
  EXPECT_EQ(test::allOf<Why>().size(), std::size(whys));
}

template <typename E>
void expectKnown() {
  for (const E value : test::allOf<E>()) EXPECT_TRUE(isKnown(value)) << static_cast<int>(value);
  EXPECT_FALSE(isKnown(static_cast<E>(200)));
}

TEST(NoteCodec, KnowsEveryValueOfItsEnums) {
  expectKnown<Request>();
  expectKnown<RequestEnd>();
  expectKnown<PipeEvent>();
  expectKnown<LinkFault>();
  expectKnown<note::OwnAddress::How>();
  expectKnown<note::LeftOut::Why>();
}

TEST(NoteCodec, ReadsBackWhatItWrote) {
  Bytes bytes;
  std::vector<Note> written;
  for (const NoteValue& value : test::noteSamples()) {
    written.push_back({.frame = written.size() << 40u, .time = {-1'000'000'007}, .value = value});
    appendNote(bytes, written.back());
  }
  written.push_back({.value = note::Mark{std::string(500, 'x')}});
  appendNote(bytes, written.back());
  written.push_back({.value = note::Asked{}});  // without a PIN
  appendNote(bytes, written.back());
  std::span<const std::uint8_t> rest(bytes);
  for (const Note& note : written) {
    const auto read = takeNote(rest);
    ASSERT_TRUE(read) << noteKey(note.value);
    EXPECT_EQ(std::get<Note>(read.value()), note) << noteKey(note.value);
  }
  EXPECT_TRUE(rest.empty());
  EXPECT_EQ(takeNote(rest).error(), NoteFault::Cut);
}

// What takeNote() makes of one note alone, or "none" for a fault.
std::string told(const Bytes& bytes) {
  std::span<const std::uint8_t> rest(bytes);
  const auto read = takeNote(rest);
  if (!read) return read.error() == NoteFault::Cut ? "cut" : "damaged";
  EXPECT_TRUE(rest.empty());
  if (const auto* unknown = std::get_if<UnknownNote>(&read.value()))
    return "unknown " + std::to_string(unknown->kind) + " at " + std::to_string(unknown->frame);
  return std::string(noteKey(std::get<Note>(read.value()).value));
}

TEST(NoteCodec, TellsAKindOfANewerVersionAndReadsOn) {
  Bytes bytes = bytesOf(note::Mark{"of a newer version"}, 12);
  bytes[2] = 250;
  EXPECT_EQ(told(bytes), "unknown 250 at 12");
  appendNote(bytes, {.value = note::Mark{"known"}});
  std::span<const std::uint8_t> rest(bytes);
  ASSERT_TRUE(takeNote(rest));
  const auto second = takeNote(rest);
  ASSERT_TRUE(second);
  EXPECT_EQ(std::get<Note>(second.value()).value, NoteValue(note::Mark{"known"}));
}

TEST(NoteCodec, TellsAValueOfANewerVersionAsUnknown) {
  for (const NoteValue& value :
       {NoteValue(note::OwnAddress{}), NoteValue(note::Asked{}), NoteValue(note::RequestEnded{})}) {
    Bytes bytes = bytesOf(value);
    bytes.back() = 200;
    EXPECT_EQ(told(bytes), "unknown " + std::to_string(bytes[2]) + " at 3");
  }
}

TEST(NoteCodec, SkipsFieldsThatANewerVersionAdded) {
  for (const NoteValue& value : test::noteSamples()) {
    Bytes bytes = bytesOf(value);
    bytes.insert(bytes.end(), {1, 2, 3});
    bytes[0] = static_cast<std::uint8_t>(bytes[0] + 3);
    std::span<const std::uint8_t> rest(bytes);
    const auto read = takeNote(rest);
    ASSERT_TRUE(read) << noteKey(value);
    EXPECT_EQ(std::get<Note>(read.value()).value, value);
    EXPECT_TRUE(rest.empty());
  }
}

// In bytes, before and after its adapter was added, with an empty one.
constexpr std::size_t kSizesOfLinkUp[] = {20, 21};

TEST(NoteCodec, ReadsANoteOfBeforeAFieldWasAdded) {
  const Bytes whole = bytesOf(note::LinkUp{test::kNotedChannel});
  for (const std::size_t size : kSizesOfLinkUp) {
    Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    bytes[0] = static_cast<std::uint8_t>(bytes.size() - 2);
    std::span<const std::uint8_t> rest(bytes);
    const auto read = takeNote(rest);
    ASSERT_TRUE(read);
    EXPECT_EQ(std::get<Note>(read.value()).value, NoteValue(note::LinkUp{test::kNotedChannel}));
  }
}

TEST(NoteCodec, TellsANoteThatEndsTooSoon) {
  for (const NoteValue& value : test::noteSamples()) {
    const Bytes whole = bytesOf(value);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_EQ(told(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))), "cut");
      if (size < 2) continue;
      // The same with a length that says that this is all.
      Bytes shorter(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      shorter[0] = static_cast<std::uint8_t>(size - 2);
      const bool isAsItWas = size == 20 || size + sizeof(note::LinkUp::bitRate) == whole.size();
      if (std::holds_alternative<note::LinkUp>(value) && isAsItWas) continue;
      EXPECT_EQ(told(shorter), "damaged") << noteKey(value) << " of " << size;
    }
  }
}

TEST(NoteCodec, TellsWhatNoVersionWrites) {
  const Bytes none(40, 0);
  std::span<const std::uint8_t> rest(none);
  EXPECT_EQ(takeNote(rest).error(), NoteFault::Damaged);
  EXPECT_EQ(rest.size(), none.size()) << "after a fault nothing is taken";
  Bytes flag = bytesOf(note::DriveSaid{});
  flag.back() = 2;
  EXPECT_EQ(told(flag), "damaged");
  Bytes pin = bytesOf(note::Asked{{}, {}, test::kNotedPin, Request::Fault});
  pin[pin.size() - 2] = 'x';
  EXPECT_EQ(told(pin), "damaged");
}

// Whatever the bytes are, each call takes a note or tells a fault; the sanitizers look on.
TEST(NoteCodec, ComesThroughAnyBytes) {
  Bytes whole;
  for (const NoteValue& value : test::noteSamples()) appendNote(whole, {.value = value});
  std::mt19937 random(1);
  std::size_t faults = 0;
  for (int round = 0; round < 20'000; ++round) {
    Bytes bytes = whole;
    for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    std::span<const std::uint8_t> rest(bytes);
    while (!rest.empty()) {
      const std::size_t before = rest.size();
      const auto read = takeNote(rest);
      if (!read) {
        ++faults;
        break;
      }
      ASSERT_LT(rest.size(), before);
    }
  }
  EXPECT_GT(faults, 0u);
}

}  // namespace
}  // namespace deckpipe
