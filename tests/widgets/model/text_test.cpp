// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QString>
#include <string>

#include "model/field_text.h"
#include "model/message_text.h"
#include "protocol/catalogue.h"
#include "protocol/decode.h"
#include "protocol/samples.h"
#include "support/frames.h"

namespace deckpipe {
namespace {

std::string summary(std::string_view sampleName) {
  for (const Sample& sample : kSamples) {
    if (sample.name != sampleName) continue;
    const Message& message = messageOf(sample.message);
    return summaryText(test::frame(sample.id, sample.data),
                       {message.family, message.id, false, message.lengths})
        .toStdString();
  }
  return "no such sample";
}

TEST(MessageText, SummariesSayWhatMattersAndLeaveOutWhatIsOff) {
  const std::pair<const char*, const char*> expected[] = {
      {"manual_position", "Rotation 47.3°, Elevation −5.5°, Axis 5 (+) hard stop"},
      {"gateway_manual_tpdo1", "Rotation 47.3°, Elevation −5.5°"},
      {"operational_error_bits",
       "Elevation sensor error, Axis 1 (+) hard stop error, Operational error, "
       "Rotation sensor no sensor fitted, "
       "Not "
       "calibrated"},
      {"manual_basic_joystick", "X 50.0 %, Y −40.0 %, Fog"},
      {"manual_extended_joystick", "Grip X 50.0 %, Grip Y −40.0 %, Switch 15"},
      {"manual_announcement_by_its_text", "PIN 1032AE100801035, 6032 Universal II"},
      {"manual_rotation_limits", "Left −30.0°, Right 45.0°, Oscillating"},
      {"manual_outputs", "Panel LED, Wireless hand-held LED, Discharge valve, Active (not stowed)"},
      {"every_output_bit",
       "Electric riser command 3, Point-aim LED, Aux agent dispense, Permissive required, Point-aim mode, "
       "Stowed, "
       "Active (not stowed), Motion not allowed"},
      {"mini_faulted", "Device faulted, Riser retracted"},
      {"manual_request", "PGN EE00 hex (NAME)"},
      {"manual_fault_poll", ""},
      {"manual_fault_response_seven_bytes", "No faults, pCode error code 11 (rotation sensor error)"},
      {"five_byte_faults_of_older_firmware",
       "Faults: Internal EEPROM, Motor of axis 1, Internal fuse, S12 processor code, "
       "Fault bits without a name "
       "12"},
      {"manual_pipe_data", "“A?\\r\\n”"},
      {"gateway_manual_nmt", "Start, all nodes"},
      {"gateway_manual_heartbeat", "Operational"},
      {"gateway_manual_part_number", "5000.01 Akron device type = 60320022"},
      {"gateway_manual_error_code_six_bytes", "5001.02 operational error code = 11 (rotation sensor error)"},
      {"gateway_manual_fuse_in_opposite_order", "Faults: Internal fuse, 5001.01 fault status"},
      {"abort_of_a_missing_object",
       "5001.02 operational error code, Object does not exist in the object dictionary"},
      {"abort_without_a_known_text", "Abort code 12345678, 5001.02 operational error code"},
      {"drive_get_network_options", "Parameter 121 hex (network options), RAM"},
      {"drive_unknown_action", "Action 7, Axis mask 3"},
      {"drive_velocity", "Velocity −999.9 counts/s"},
      {"drive_answers_options", "Success, Value 2"},
      {"drive_answers_error", "Error code 9 (unknown parameter)"},
  };
  for (const auto& [sample, text] : expected) EXPECT_EQ(summary(sample), text) << sample;
}

TEST(MessageText, NoSummaryHasAKeyInIt) {
  for (const Sample& sample : kSamples)
    EXPECT_EQ(summary(sample.name).find('_'), std::string::npos) << summary(sample.name);
}

TEST(MessageText, SaysTheLengthsThatAreWanted) {
  Classified what{Family::Akron, MessageId::FaultPoll, true, lengths(1, 5, 7)};
  EXPECT_EQ(malformedText(what, 3).toStdString(), "1 or 5 or 7 bytes wanted, 3 came");
  what.wanted = lengths(1);
  EXPECT_EQ(malformedText(what, 0).toStdString(), "1 byte wanted, 0 came");
}

}  // namespace
}  // namespace deckpipe
