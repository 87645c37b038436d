// SPDX-License-Identifier: GPL-3.0-or-later
// What a message's own line in the catalogue is enough for, message by message: it is told apart, decoded,
// listed, aged and shown without being named anywhere else in core.
#include <gtest/gtest.h>

#include <algorithm>

#include "protocol/address_book.h"
#include "protocol/decode.h"
#include "protocol/lists.h"
#include "protocol/samples.h"
#include "support/frames.h"

namespace deckpipe {

void PrintTo(const Message& message, std::ostream* out) { *out << message.key; }

namespace {

bool has(const auto& list, MessageId id) { return std::ranges::find(list, id) != list.end(); }

class EveryMessage : public testing::TestWithParam<Message> {};

TEST_P(EveryMessage, HasASampleFromWhichItIsTold) {
  EXPECT_TRUE(std::ranges::any_of(kSamples, [](const Sample& s) { return s.message == GetParam().id; }));
}

TEST_P(EveryMessage, IsAgedByItsPeriodAloneAndStandsOnAPage) {
  const Message& m = GetParam();
  const bool isPeriodic = m.period > 0ns && m.family != Family::J1939;
  EXPECT_EQ(has(kPeriodicReports, m.id), isPeriodic);
  if (!isPeriodic) return;
  EXPECT_TRUE(has(kReports, m.id)) << "its last one is kept";
  EXPECT_EQ(staleAfter(m.id), 3 * m.period);
  EXPECT_TRUE(m.isWatched);
  EXPECT_FALSE(m.page.isEmpty());
}

TEST_P(EveryMessage, SaysWhatItAsksOrAnswers) {
  const Message& m = GetParam();
  EXPECT_EQ(m.part == Part::None || m.part == Part::Pipe, m.request == Request::Count);
  if (m.part == Part::Asks) {
    EXPECT_EQ(requestOf(m.request), m.id);
    EXPECT_EQ(m.device, DeviceEnd::Receiver);
    EXPECT_FALSE(m.broadcast);
  }
  if (m.part == Part::Answers || m.part == Part::Acknowledges) {
    EXPECT_EQ(requestAnsweredBy(m.id), m.request);
    EXPECT_TRUE(has(answersOf(m.request), m.id));
    EXPECT_EQ(m.device, DeviceEnd::Sender);
    EXPECT_TRUE(m.isWatched) << "an answer is news";
  } else {
    EXPECT_EQ(requestAnsweredBy(m.id), std::nullopt);
  }
}

TEST_P(EveryMessage, IsTalkIfItGoesBetweenADeviceAndWhoAsksIt) {
  const Message& m = GetParam();
  if (!m.isSaid()) return;
  EXPECT_EQ(m.family, Family::Akron);
  EXPECT_EQ(m.selector, pgn::kProprietaryA);
  EXPECT_TRUE(kSaidTypes[typeOf(m.id)]);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryMessage, testing::ValuesIn(kCatalogue.begin(), kCatalogue.end()),
                         [](const auto& row) { return std::string(row.param.key); });

// What these were when each room kept a list of its own. A new message need not be named here.
TEST(CatalogueLists, SayOfTheManualsMessagesWhatTheyAlwaysSaid) {
  for (const unsigned type : {0x02u, 0x03u, 0x04u, 0x05u, 0x21u, 0x22u, 0x41u, 0x45u, 0x46u, 0xFEu})
    EXPECT_TRUE(kSaidTypes[type]) << type;
  for (const unsigned type : {0x01u, 0x81u, 0x82u, 0x83u, 0x84u, 0x85u, 0xA1u, 0xFDu, 0xFFu})
    EXPECT_FALSE(kSaidTypes[type]) << type;

  const auto isWatched = [](const char* key) { return messageByKey(key)->isWatched; };
  for (const char* key : {"position_limit_status",
                          "rotation_soft_limits",
                          "elevation_soft_limits",
                          "digital_outputs",
                          "mini_digital_outputs",
                          "digital_inputs",
                          "soe_permissive",
                          "diagnostic_data",
                          "fault_response",
                          "firmware_response",
                          "pcode_response",
                          "config_response",
                          "vista_status",
                          "vista_position",
                          "zero_axes_ack",
                          "reset_request",
                          "setup_mode_ack",
                          "nmt_command",
                          "heartbeat",
                          "sdo_read_response",
                          "sdo_write_response",
                          "sdo_abort"})
    EXPECT_TRUE(isWatched(key)) << key;
  for (const char* key :
       {"request", "name", "basic_joystick", "extended_joystick", "address_announcement", "fault_poll",
        "vista_poll", "zero_axes_request", "setup_mode_request", "pipe_data", "pipe_ack", "sdo_read_request",
        "sdo_write_request", "sdo_other", "gateway_joystick", "copley_velocity", "copley_velocity_response"})
    EXPECT_FALSE(isWatched(key)) << key;
  EXPECT_EQ(staleAfter(MessageId::PositionLimitStatus), 300ms);
  EXPECT_EQ(staleAfter(MessageId::Heartbeat), 3s);
  EXPECT_EQ(newsBits(messageOf(MessageId::Heartbeat)), ~std::uint64_t{0x80});
}

// Each specifier of CiA 301 in each direction, as protocol.md section 2 has them.
TEST(CatalogueLists, TellSdosByTheirSpecifier) {
  const auto told = [](std::string_view id, unsigned specifier) {
    Frame frame = test::frame(id, "0001500100000000");
    frame.data[0] = static_cast<std::uint8_t>(specifier);
    return classify(frame, {}, {}).message;
  };
  for (unsigned s = 0; s < 256; ++s) {
    const bool isRead = s == 0x43 || s == 0x47 || s == 0x4B || s == 0x4F;
    const bool isWrite = s == 0x23 || s == 0x27 || s == 0x2B || s == 0x2F;
    EXPECT_EQ(told("5A4", s), isRead      ? MessageId::SdoReadResponse
                              : s == 0x60 ? MessageId::SdoWriteResponse
                              : s == 0x80 ? MessageId::SdoAbort
                                          : MessageId::SdoOther)
        << s;
    EXPECT_EQ(told("624", s), isWrite     ? MessageId::SdoWriteRequest
                              : s == 0x40 ? MessageId::SdoReadRequest
                              : s == 0x80 ? MessageId::SdoAbort
                                          : MessageId::SdoOther)
        << s;
  }
}

}  // namespace
}  // namespace deckpipe
