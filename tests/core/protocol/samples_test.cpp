// SPDX-License-Identifier: GPL-3.0-or-later
// Every sample beside the catalogue, decoded and encoded again.
#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/address_book.h"
#include "protocol/decode.h"
#include "protocol/encode.h"
#include "protocol/samples.h"
#include "support/frames.h"

namespace deckpipe {

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.name; }

namespace {

constexpr Address kDevice{0x80};
constexpr Address kMini{0x81};
constexpr Address kInputs{0xF0};
constexpr Address kDrive{0x21};

// Roles under which the samples' addresses are what the manuals say they are.
AddressBook manualRoles() {
  AddressBook book;
  AddressBook::Lost lost;
  for (const Address a : {kDevice, kMini, kInputs}) {
    const Frame announcement = j1939Frame(messageOf(MessageId::AddressAnnouncement),
                                          {test::frame("18EFFF80", "FF83150206021A0B").data, 8}, a);
    book.observe(announcement, {}, classify(announcement, {}, book), lost);
  }
  book.sayDrive(kDrive, true);
  const Frame partNumber = test::frame("5A4", "4300500116699803");
  book.observe(partNumber, {}, classify(partNumber, {}, book), lost);
  return book;
}

std::string describe(const Frame& frame, MessageId message) {
  std::string text;
  for (const Field& field : messageOf(message).fields) {
    if (!isPresent(field, frame)) continue;
    if (!text.empty()) text += "; ";
    text += field.key;
    text += '=';
    const Value value = valueOf(field, frame);
    text += value.isNull() ? "~" : toText(value);
  }
  return text;
}

class EverySample : public testing::TestWithParam<Sample> {};

TEST_P(EverySample, DecodesToItsLiteralValues) {
  const Frame frame = test::frame(GetParam().id, GetParam().data);
  const Classified what = classify(frame, {}, manualRoles());
  ASSERT_EQ(what.message, GetParam().message);
  EXPECT_FALSE(what.malformed);
  EXPECT_EQ(describe(frame, what.message), GetParam().fields);
}

TEST_P(EverySample, EncodesBackToItsBytes) {
  const Frame frame = test::frame(GetParam().id, GetParam().data);
  std::vector<FieldValue> values;
  const Message& message = messageOf(GetParam().message);
  for (const Field& field : message.fields) {
    if (isPresent(field, frame)) values.push_back({field.key, valueOf(field, frame)});
  }
  const bool isSdo = message.selector == static_cast<std::uint32_t>(CobFunction::SdoRequest) ||
                     message.selector == static_cast<std::uint32_t>(CobFunction::SdoResponse);
  const auto encoded = encode(message, values, frame.length, isSdo ? frame.data[0] : std::uint8_t{0});
  ASSERT_TRUE(encoded) << static_cast<int>(encoded.error());
  EXPECT_EQ(encoded.value().length, frame.length);
  EXPECT_EQ(encoded.value().data, frame.data);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EverySample, testing::ValuesIn(kSamples),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Catalogue, HasASampleForEveryMessage) {
  for (const Message& message : kCatalogue) {
    const bool found =
        std::ranges::any_of(kSamples, [&](const Sample& s) { return s.message == message.id; });
    EXPECT_TRUE(found) << message.key;
  }
}

TEST(Catalogue, SendsTheManualsHeaders) {
  const auto request = encode(messageOf(MessageId::FaultPoll));
  ASSERT_TRUE(request);
  EXPECT_EQ(j1939Frame(messageOf(MessageId::FaultPoll), request.value(), {0x05}, kDevice), [] {
    Frame f = test::frame("18EF8005", "02");
    f.stamp = kNoStamp;
    return f;
  }());
}

TEST(Encode, RefusesWhatAFieldCannotHold) {
  const Message& pcode = messageOf(MessageId::PcodeResponse);
  EXPECT_EQ(encode(pcode, {{"style", Value::integer(65536)}}).error(), EncodeError::OutOfRange);
  EXPECT_EQ(encode(pcode, {{"style", Value::word("on")}}).error(), EncodeError::WrongType);
  EXPECT_EQ(encode(pcode, {{"colour", Value::integer(1)}}).error(), EncodeError::UnknownKey);
  EXPECT_EQ(encode(pcode, {}, 6).error(), EncodeError::WrongLength);
  EXPECT_EQ(encode(messageOf(MessageId::AddressAnnouncement), {{"pin", Value()}}).error(),
            EncodeError::NotInvertible);
  EXPECT_EQ(
      encode(messageOf(MessageId::RotationSoftLimits), {{"left_deg", Value::decimal(-32769, 1)}}).error(),
      EncodeError::OutOfRange);
}

}  // namespace
}  // namespace deckpipe
