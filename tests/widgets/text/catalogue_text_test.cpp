// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/catalogue_text.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "protocol/catalogue.h"
#include "protocol/decode.h"
#include "protocol/device_types.h"
#include "support/enums.h"
#include "text/device_text.h"

namespace deckpipe {
namespace {

std::set<std::string> setOf(std::span<const char* const> texts) { return {texts.begin(), texts.end()}; }

bool hasWord(std::string_view key) {
  return std::ranges::find(wordTexts(), key, &WordText::key) != wordTexts().end();
}

// Both ways: nothing of the catalogue lacks its text, and no text is left of what the catalogue dropped.
TEST(CatalogueText, HasEveryMessageNameAndNoOther) {
  std::set<std::string> names;
  for (const Message& message : kCatalogue) names.insert(std::string(message.name));
  EXPECT_EQ(setOf(messageNameTexts()), names);
}

TEST(CatalogueText, HasEveryFieldNameAndNoOther) {
  std::set<std::string> names;
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (field.kind != Kind::Reserved) names.insert(std::string(field.name));
    }
  }
  EXPECT_EQ(setOf(fieldNameTexts()), names);
}

TEST(CatalogueText, HasEveryWordThatAFieldCanTake) {
  for (const Message& message : kCatalogue) {
    for (const Field& field : message.fields) {
      if (field.kind != Kind::Word && field.kind != Kind::FaultNames) continue;
      for (const ValueName& word : field.words) {
        EXPECT_TRUE(hasWord(word.word)) << message.key << ' ' << word.word;
      }
      if (!field.otherwise.empty()) {
        EXPECT_TRUE(hasWord(field.otherwise)) << message.key;
      }
    }
  }
  for (const char* key : {"off", "on", "error", "na"}) EXPECT_TRUE(hasWord(key)) << key;
  for (const PositionState state : test::allOf<PositionState>()) {
    EXPECT_TRUE(hasWord(keyOf(state))) << keyOf(state);
  }
}

TEST(CatalogueText, HasEveryFaultBit) {
  for (const ValueName& fault : akron::kFaultBits) EXPECT_TRUE(hasWord(fault.word)) << fault.word;
}

TEST(CatalogueText, HasEveryAbortReason) {
  std::set<std::string> reasons;
  for (const ValueName& reason : sdo::kAbortCodes) reasons.insert(std::string(reason.word));
  EXPECT_EQ(setOf(abortTexts()), reasons);
}

TEST(CatalogueText, HasEveryDeviceType) {
  for (const ValueName& type : kDeviceTypes) {
    EXPECT_EQ(deviceTypeText(type.value).toStdString(), type.word);
  }
}

TEST(CatalogueText, SaysNamesAndWords) {
  EXPECT_EQ(messageName(MessageId::PositionLimitStatus), QStringLiteral("Position / limit status"));
  EXPECT_EQ(fieldName(akron::kPositionLimitStatusFields[0]), QStringLiteral("Rotation"));
  EXPECT_EQ(wordText("pre_operational"), QStringLiteral("pre-operational"));
  EXPECT_EQ(wordText("no_such_key"), QStringLiteral("no_such_key"));
  EXPECT_EQ(abortText(0x06090011), QStringLiteral("Sub-index does not exist"));
  EXPECT_EQ(abortText(0x0504FFFF), QStringLiteral("code 0504FFFF hex"));
}

}  // namespace
}  // namespace deckpipe
