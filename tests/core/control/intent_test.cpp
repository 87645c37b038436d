// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/intent.h"

#include <gtest/gtest.h>

#include <vector>

namespace deckpipe {
namespace {

using What = intent::PipeAction::What;

TEST(Intent, OnlyStopsWhereItHoldsOrEndsWhatIsUnderWay) {
  const DeviceKey device = DeviceKey::at(Channel{0}, Address{0x80});
  const std::vector<Intent> stopping{intent::Lock{},
                                     intent::Cancel{device},
                                     intent::Repeat{device, kPolls, 0s},
                                     intent::PipeAction{device, What::Pause},
                                     intent::PipeAction{device, What::Cancel},
                                     intent::PipeAction{device, What::Abort},
                                     intent::HoldJoystick{},
                                     intent::DisarmJoystick{}};
  for (const Intent& intent : stopping) EXPECT_TRUE(onlyStops(intent)) << intent.index();
  const std::vector<Intent> beginning{intent::Unlock{},
                                      intent::RequestNames{},
                                      intent::SendRequests{device, kPolls},
                                      intent::Repeat{device, kPolls, 1s},
                                      intent::PipeWrite{device, "A?"},
                                      intent::PipeFile{device, "f", {}},
                                      intent::PipeAction{device, What::Resume},
                                      intent::PipeAction{device, What::Resend},
                                      intent::PipeAction{device, What::Skip},
                                      intent::ArmJoystick{},
                                      intent::HoldJoystick{.isHeld = true}};
  for (const Intent& intent : beginning) EXPECT_FALSE(onlyStops(intent)) << intent.index();
}

}  // namespace
}  // namespace deckpipe
