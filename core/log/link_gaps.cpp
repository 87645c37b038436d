// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/link_gaps.h"

#include <algorithm>

namespace deckpipe {

std::vector<LinkGap> linkGaps(const std::vector<Note>& notes) {
  std::vector<LinkGap> gaps;
  const auto openGap = [&gaps](Channel channel) {
    return std::find_if(gaps.begin(), gaps.end(),
                        [channel](const LinkGap& gap) { return gap.isOpen() && gap.channel == channel; });
  };
  for (const Note& note : notes) {
    if (const auto* down = std::get_if<note::LinkDown>(&note.value)) {
      if (openGap(down->channel) == gaps.end())
        gaps.push_back(
            {.channel = down->channel, .begin = note.time, .fault = down->fault, .words = down->words});
    } else if (const auto* up = std::get_if<note::LinkUp>(&note.value)) {
      if (const auto gap = openGap(up->channel); gap != gaps.end()) gap->end = note.time;
    }
  }
  return gaps;
}

}  // namespace deckpipe
