// SPDX-License-Identifier: GPL-3.0-or-later
// What a group of a device's page means, what to check, and which messages it is made from, as the manuals cite them: its
// tool tip and what F1 explains.
#pragma once

#include <QString>

#include "protocol/page_group.h"

namespace deckpipe {

// PageLampGroup::key and PageFactGroup::key of a group.
QString pageGroupKey(PageGroup group);
// By the group's key (device_page_values.h; "stops" for the hard stops), a line a sentence or message; empty for others.
QString pageSourceText(const QString& groupKey);

}  // namespace deckpipe
