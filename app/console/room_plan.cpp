// SPDX-License-Identifier: GPL-3.0-or-later
#include "room_plan.h"

namespace deckpipe {
namespace {

// A window's title and borders, which nobody knows before the window is seen.
constexpr QSize kFrame{16, 48};

}  // namespace

QSize firstSize(const QRect& available) { return kUsualWindow.boundedTo(available.size() - kFrame); }

}  // namespace deckpipe
