// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/address_book.h"

#include <gtest/gtest.h>

namespace deckpipe {
namespace {

TEST(AddressUse, RefusesJoysticksAndMonitorsAndWarnsOfFixedAddresses) {
  using Use = AddressUse;
  const struct {
    unsigned first, last;
    Use use;
  } rows[] = {{0x00, 0x32, Use::Warn},    {0x33, 0x38, Use::Refused}, {0x39, 0x7F, Use::Warn},
              {0x80, 0xF7, Use::Refused}, {0xF8, 0xFD, Use::Ok},      {0xFE, 0xFF, Use::Refused}};
  unsigned next = 0;
  for (const auto& row : rows) {
    ASSERT_EQ(row.first, next) << "every address stands in one row";
    for (; next <= row.last; ++next)
      EXPECT_EQ(addressUse({static_cast<std::uint8_t>(next)}), row.use) << std::hex << next;
  }
  EXPECT_EQ(next, 256u);
}

}  // namespace
}  // namespace deckpipe
