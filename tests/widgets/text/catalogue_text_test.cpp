// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/catalogue_text.h"

#include <gtest/gtest.h>

#include "protocol/catalogue.h"

namespace deckpipe {
namespace {

TEST(CatalogueText, SaysNamesAndWords) {
  EXPECT_EQ(messageName(MessageId::PositionLimitStatus), QStringLiteral("Position / limit status"));
  EXPECT_EQ(fieldName(akron::kPositionLimitStatusFields[0]), QStringLiteral("Rotation"));
  EXPECT_EQ(wordText("pre_operational"), QStringLiteral("pre-operational"));
  EXPECT_EQ(wordText("no_such_key"), QStringLiteral("no_such_key"));
  EXPECT_EQ(numberName(akron::kPcodeErrors, 11), QStringLiteral("rotation sensor error"));
  EXPECT_TRUE(numberName(akron::kPcodeErrors, 12).isEmpty());
  EXPECT_EQ(abortText(0x06090011), QStringLiteral("Sub-index does not exist"));
  EXPECT_EQ(abortText(0x0504FFFF), QStringLiteral("code 0504FFFF hex"));
}

}  // namespace
}  // namespace deckpipe
