// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/link_life.h"

#include <array>

namespace deckpipe {
namespace {

using enum LinkStage;

struct Row {
  LinkStage stage;
  LinkState shown;
  bool hasDevice;
  bool isWaiting;
  std::array<LinkStage, kLinkEvents> next;
};

// clang-format off
constexpr std::array<Row, kLinkStages> kLife{{
    //                                 device waits     Open       Close   Fits       IsDown     Unfit      Missing    Connected  Failed
    {Closed,    LinkState::Closed,     false, false, {{ Asking,    Closed, Closed,    Closed,    Closed,    Closed,    Closed,    Closed }}},
    {Asking,    LinkState::Connecting, false, true,  {{ Asking,    Closed, Opening,   Closed,    Closed,    Closed,    Asking,    Closed }}},
    {Opening,   LinkState::Connecting, true,  true,  {{ Opening,   Closed, Opening,   Closed,    Closed,    Closed,    Up,        Closed }}},
    {Up,        LinkState::Up,         true,  false, {{ Up,        Closed, Up,        Down,      Away,      Away,      Up,        Away   }}},
    {Down,      LinkState::Lost,       true,  false, {{ Down,      Closed, Up,        Down,      Away,      Away,      Down,      Away   }}},
    {Away,      LinkState::Lost,       false, false, {{ Away,      Closed, Returning, Away,      Away,      Away,      Away,      Away   }}},
    {Returning, LinkState::Lost,       true,  true,  {{ Returning, Closed, Returning, Away,      Away,      Away,      Up,        Away   }}},
}};
// clang-format on

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kLife.size(); ++i) {
    if (kLife[i].stage != static_cast<LinkStage>(i)) return false;
  }
  return true;
}
static_assert(isInOrder());

const Row& row(LinkStage stage) { return kLife[static_cast<std::size_t>(stage)]; }

}  // namespace

LinkStage next(LinkStage stage, LinkEvent event) { return row(stage).next[static_cast<std::size_t>(event)]; }

LinkState shown(LinkStage stage) { return row(stage).shown; }
bool hasDevice(LinkStage stage) { return row(stage).hasDevice; }
bool isWaiting(LinkStage stage) { return row(stage).isWaiting; }

}  // namespace deckpipe
