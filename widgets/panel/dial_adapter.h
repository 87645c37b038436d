// SPDX-License-Identifier: GPL-3.0-or-later
// From a page's values to what the dial draws. The two rooms share no type: the model knows no widget and the
// dial knows no message.
#pragma once

#include "model/monitor_page_values.h"
#include "paint/dial_values.h"

namespace deckpipe {

DialValues dialValuesOf(const PageDial& page);

}  // namespace deckpipe
