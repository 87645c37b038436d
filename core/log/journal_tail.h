// SPDX-License-Identifier: GPL-3.0-or-later
// What the end of a journal tells of all of it, so that a list of recordings need not read each as a whole.
#pragma once

#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/frame.h"
#include "log/log_bytes.h"

namespace deckpipe {

struct JournalTail {
  std::uint64_t frames = 0;              // of the whole journal
  std::optional<Frame> last{};           // the last frame of the tail that has a stamp
  std::optional<std::int64_t> offset{};  // to the stamps of its channel, if one was set within the tail
  Instant ranUntil = kNotYet;            // of the latest note::RanUntil
  Instant noted = kNotYet;               // of the latest other note
  bool isEnded = false;                  // the recording was ended on purpose
  std::uint64_t cutBytes = 0;            // at its end, that are not whole
  bool isDamaged = false;                // some of its bytes, with whole blocks before them
};

// Looks at the last so many bytes, which must be more than a block can have (journal_bytes.h). Nothing if no
// block of frames is found in them.
inline constexpr std::uint64_t kJournalTailBytes = std::uint64_t{3} << 20;
std::optional<JournalTail> readJournalTail(const LogBytes& bytes, std::uint64_t atMost = kJournalTailBytes);

}  // namespace deckpipe
