// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note.h"

#include <utility>

#include "base/overload.h"

namespace deckpipe {

NoteText::NoteText(std::string text) : m_text(std::move(text)) {
  if (m_text.size() <= kMaxBytes) return;
  std::size_t length = kMaxBytes;
  while (length > 0 && (static_cast<unsigned char>(m_text[length]) & 0xC0) == 0x80) --length;
  m_text.resize(length);
}

std::string_view noteKey(const NoteValue& value) {
  using Key = std::string_view;
  return std::visit(
      Overload{[](const note::Mark&) -> Key { return "mark"; },
               [](const note::LinkUp&) -> Key { return "link_up"; },
               [](const note::LinkDown&) -> Key { return "link_down"; },
               [](const note::Dropped&) -> Key { return "dropped"; },
               [](const note::Locked&) -> Key { return "locked"; },
               [](const note::Unlocked&) -> Key { return "unlocked"; },
               [](const note::DriveSaid& n) -> Key { return n.isDrive ? "drive_said" : "drive_unsaid"; },
               [](const note::OwnAddress&) -> Key { return "own_address"; },
               [](const note::Asked&) -> Key { return "asked"; },
               [](const note::AskEnded&) -> Key { return "ask_ended"; },
               [](const note::AskWaits&) -> Key { return "ask_waits"; },
               [](const note::StillWaits&) -> Key { return "still_waits"; },
               [](const note::Pipe&) -> Key { return "pipe"; },
               [](const note::LeftOut&) -> Key { return "left_out"; },
               [](const note::Label&) -> Key { return "label"; },
               [](const note::Added&) -> Key { return "added"; }},
      value);
}

}  // namespace deckpipe
