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
               [](const note::RequestEnded&) -> Key { return "ask_ended"; },
               [](const note::RequestWaits&) -> Key { return "ask_waits"; },
               [](const note::StillWaits&) -> Key { return "still_waits"; },
               [](const note::Pipe&) -> Key { return "pipe"; },
               [](const note::LeftOut&) -> Key { return "left_out"; },
               [](const note::Label&) -> Key { return "label"; },
               [](const note::Added&) -> Key { return "added"; }},
      value);
}

Severity noteWeight(const NoteValue& value) {
  using How = note::OwnAddress::How;
  return std::visit(Overload{[](const note::Mark&) { return Severity::Plain; },
                             [](const note::LinkUp&) { return Severity::Plain; },
                             [](const note::LinkDown& n) {
                               return n.fault == LinkFault::None ? Severity::Plain : Severity::Fault;
                             },
                             [](const note::Dropped&) { return Severity::Warning; },
                             [](const note::Locked&) { return Severity::Plain; },
                             [](const note::Unlocked&) { return Severity::Plain; },
                             [](const note::DriveSaid&) { return Severity::Plain; },
                             [](const note::OwnAddress& n) {
                               const bool isMeant = n.how == How::Claimed || n.how == How::Locked;
                               return isMeant ? Severity::Plain : Severity::Warning;
                             },
                             [](const note::Asked&) { return Severity::Plain; },
                             [](const note::RequestEnded& n) {
                               return n.end == RequestEnd::Answered ? Severity::Plain : Severity::Warning;
                             },
                             [](const note::RequestWaits&) { return Severity::Fault; },
                             [](const note::StillWaits&) { return Severity::Fault; },
                             [](const note::Pipe&) { return Severity::Plain; },
                             [](const note::LeftOut&) { return Severity::Warning; },
                             [](const note::Label&) { return Severity::Plain; },
                             [](const note::Added&) { return Severity::Plain; }},
                    value);
}

}  // namespace deckpipe
