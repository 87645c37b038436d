// SPDX-License-Identifier: GPL-3.0-or-later
// A device's page as a pure function of the view: the same cursor gives the same page, live or from a file.
// Ages are of the state's own cursor, so that a page never mixes two instants.
#pragma once

#include "model/device_page_values.h"
#include "state/log_view.h"

namespace deckpipe {

DevicePageValues devicePageOf(const LogView& view, const DeviceKey& key, const DeviceLabels& labels = {});

}  // namespace deckpipe
