// SPDX-License-Identifier: GPL-3.0-or-later
#include "link/link_life.h"

namespace deckpipe {
namespace {

using enum LinkStage;

struct Row {
  LinkState shown;
  bool hasDevice;
  bool isWaiting;
  EnumArray<LinkEvent, LinkStage> next;
};

// clang-format off
constexpr EnumTable<LinkStage, Row> kLife{{
    //                                  device waits     Open       Close   Fits       IsDown     Unfit      Missing    Connected  Failed
    {Closed,    {LinkState::Closed,     false, false, {{ Asking,    Closed, Closed,    Closed,    Closed,    Closed,    Closed,    Closed }}}},
    {Asking,    {LinkState::Connecting, false, true,  {{ Asking,    Closed, Opening,   Closed,    Closed,    Closed,    Asking,    Closed }}}},
    {Opening,   {LinkState::Connecting, true,  true,  {{ Opening,   Closed, Opening,   Closed,    Closed,    Closed,    Up,        Closed }}}},
    {Up,        {LinkState::Up,         true,  false, {{ Up,        Closed, Up,        Down,      Away,      Away,      Up,        Away   }}}},
    {Down,      {LinkState::Lost,       true,  false, {{ Down,      Closed, Up,        Down,      Away,      Away,      Down,      Away   }}}},
    {Away,      {LinkState::Lost,       false, false, {{ Away,      Closed, Returning, Away,      Away,      Away,      Away,      Away   }}}},
    {Returning, {LinkState::Lost,       true,  true,  {{ Returning, Closed, Returning, Away,      Away,      Away,      Up,        Away   }}}},
}};
// clang-format on

}  // namespace

LinkStage next(LinkStage stage, LinkEvent event) { return kLife[stage].next[event]; }

LinkState shown(LinkStage stage) { return kLife[stage].shown; }
bool hasDevice(LinkStage stage) { return kLife[stage].hasDevice; }
bool isWaiting(LinkStage stage) { return kLife[stage].isWaiting; }

}  // namespace deckpipe
