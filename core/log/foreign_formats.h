// SPDX-License-Identifier: GPL-3.0-or-later
// The names of log formats that other programs write and no reader of ours takes, so that a refusal says what
// the file seems to be. A format that gets a reader (log_format.h) leaves this list.
#pragma once

#include <cstddef>
#include <string_view>

namespace deckpipe {

// Only so many bytes are looked at: a pipe has them whenever a file has.
inline constexpr std::size_t kForeignBytes = 4096;

// A proper name, not translated: "Vector BLF". Empty if the bytes are of no format known here.
std::string_view foreignFormat(std::string_view head);

}  // namespace deckpipe
