// SPDX-License-Identifier: GPL-3.0-or-later
// Exit statuses of deckpipectl. Scripts trust them: a number keeps its meaning. --help lists them from here.
#pragma once

#include "base/enum_table.h"

namespace deckpipe {
namespace ctl {

enum ExitStatus : int { kDone, kNotWhole, kBadUsage, kCannotRead, kNothingRead };

}  // namespace ctl

template <>
inline constexpr ctl::ExitStatus kLastOf<ctl::ExitStatus> = ctl::kNothingRead;

namespace ctl {

inline constexpr EnumTable<ExitStatus, const char*> kExitMeanings{{
    {kDone, "done: all of it was read, written, answered or acknowledged"},
    {kNotWhole,
     "not all of it: a line or a frame was not read, an answer is missing, the interface was lost"},
    {kBadUsage, "unusable arguments, or a word such as --unlock or --yes is missing"},
    {kCannotRead, "the file cannot be read: it is not there, or it is no log of a known format"},
    {kNothingRead, "the file holds no bytes, or no frame"},
}};

}  // namespace ctl
}  // namespace deckpipe
