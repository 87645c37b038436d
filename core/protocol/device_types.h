// SPDX-License-Identifier: GPL-3.0-or-later
// What the first four digits of a PIN say a device is (CAN Messaging manual, Appendix A).
#pragma once

#include <string_view>

#include "protocol/field.h"

namespace deckpipe {

inline constexpr ValueName kDeviceTypes[] = {
    {1032, "6032 Universal II"}, {1033, "6033 Mini Universal"},      {1034, "6034 Operator Station"},
    {1035, "6035 Joystick"},     {1036, "6036 Direction Indicator"}, {1037, "6037 Wireless Interface"},
    {1040, "6040 Forestry"},     {1041, "6041 Switchbox"},           {1042, "6042 Global Platform"},
    {1051, "6051 CAN Gateway"},  {1052, "6052 StreamMaster II"},
};

// Empty where the manual names no such type. Some 6041 carry 1035 and some 6035 carry 1041.
constexpr std::string_view deviceTypeName(unsigned type) {
  for (const ValueName& name : kDeviceTypes) {
    if (name.value == type) return name.word;
  }
  return {};
}

}  // namespace deckpipe
