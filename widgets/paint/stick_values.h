// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a joystick's stick or grip. Right and forward are positive.
#pragma once

#include <optional>

namespace deckpipe {

struct StickValues {
  std::optional<double> x, y;  // −1 .. +1; nothing: the message gives none
  bool isStale = false;
  friend bool operator==(const StickValues&, const StickValues&) = default;
};

}  // namespace deckpipe
