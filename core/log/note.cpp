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

EventWeight noteWeight(const NoteValue& value) {
  using How = note::OwnAddress::How;
  using Weight = EventWeight;
  return std::visit(
      Overload{
          [](const note::Mark&) { return Weight::Info; }, [](const note::LinkUp&) { return Weight::Info; },
          [](const note::LinkDown& n) { return n.fault == LinkFault::None ? Weight::Info : Weight::Fault; },
          [](const note::Dropped&) { return Weight::Warning; },
          [](const note::Locked&) { return Weight::Info; },
          [](const note::Unlocked&) { return Weight::Info; },
          [](const note::DriveSaid&) { return Weight::Info; },
          [](const note::OwnAddress& n) {
            const bool isMeant = n.how == How::Claimed || n.how == How::Locked;
            return isMeant ? Weight::Info : Weight::Warning;
          },
          [](const note::Asked&) { return Weight::Info; },
          [](const note::AskEnded& n) {
            return n.end == RequestEnd::Answered ? Weight::Info : Weight::Warning;
          },
          [](const note::AskWaits&) { return Weight::Fault; },
          [](const note::StillWaits&) { return Weight::Fault; },
          [](const note::Pipe&) { return Weight::Info; },
          [](const note::LeftOut&) { return Weight::Warning; },
          [](const note::Label&) { return Weight::Info; }, [](const note::Added&) { return Weight::Info; }},
      value);
}

}  // namespace deckpipe
