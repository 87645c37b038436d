// SPDX-License-Identifier: GPL-3.0-or-later
// What the five axes of a position / limit status are on which device, and what their two sides are called.
// Source: CAN Messaging manual, Appendix C. Whoever shows stops by axis asks here.
#pragma once

#include <QString>
#include <optional>

namespace deckpipe {

inline constexpr int kAxes = 5;

struct AxisText {
  QString name;    // "Pattern"
  QString plus;    // "Stream"
  QString minus;   // "Fog"
  QString remark;  // what else is to be known of it; often empty
};

// `axis` 1..5; `deviceType` the first four digits of a PIN, nothing where they are not known. All devices of
// the manual use axes 1 and 2 alike, and the message itself calls them rotation and elevation, so these have
// their names without a type too. What the manual leaves open is 'Axis n' with plain signs.
AxisText axisText(std::optional<unsigned> deviceType, int axis);

}  // namespace deckpipe
