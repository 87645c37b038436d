// SPDX-License-Identifier: GPL-3.0-or-later
// Who is on a bus, as `deckpipectl nodes` says it: a line for every address heard or claimed, for every
// device that has lost its address, and for every CANopen node.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "node_counts.h"
#include "state/health.h"
#include "state/state.h"

namespace deckpipe::ctl {

enum class NodeFormat : std::uint8_t { JsonLines, Text };

std::string nodeLines(const State& state, const NodeCounts& counts, Channel channel,
                      std::string_view channelName, NodeFormat format);

// The type of a device in English, by its PIN, its part number or what it sends. Empty if nothing tells.
std::string_view typeName(const Device& device);

// The keys of the causes, the worst first.
std::vector<std::string_view> causesOf(const Health& health);

// What was counted and not followed, each kind a line without its end; none where all is followed.
std::vector<std::string> untrackedLines(const State& state);

}  // namespace deckpipe::ctl
