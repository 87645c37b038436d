// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note.h"

#include <utility>

#include "base/overload.h"
#include "log/note_layout.h"

namespace deckpipe {

NoteText::NoteText(std::string text) : m_text(std::move(text)) {
  if (m_text.size() <= kMaxBytes) return;
  std::size_t length = kMaxBytes;
  while (length > 0 && (static_cast<unsigned char>(m_text[length]) & 0xC0) == 0x80) --length;
  m_text.resize(length);
}

std::string_view noteKey(const NoteValue& value) {
  const auto* drive = std::get_if<note::DriveSaid>(&value);
  if (drive != nullptr && !drive->isDrive) return "drive_unsaid";
  return std::visit([]<typename T>(const T&) { return layouts::kLayout<T>.key; }, value);
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
                             [](const note::AnglesBefore&) { return Severity::Plain; },
                             [](const note::RequestEnded& n) {
                               return n.end == RequestEnd::Answered ? Severity::Plain : Severity::Warning;
                             },
                             [](const note::RequestWaits&) { return Severity::Fault; },
                             [](const note::StillWaits&) { return Severity::Fault; },
                             [](const note::Pipe&) { return Severity::Plain; },
                             [](const note::LeftOut&) { return Severity::Warning; },
                             [](const note::Label&) { return Severity::Plain; },
                             [](const note::Added&) { return Severity::Plain; },
                             [](const note::Filtered&) { return Severity::Warning; },
                             [](const note::RanUntil&) { return Severity::Plain; },
                             [](const note::MotionArmed&) { return Severity::Plain; },
                             [](const note::MotionEnded& n) {
                               const bool isMeant = n.cause == MotionCause::Released ||
                                                    n.cause == MotionCause::Disarmed ||
                                                    n.cause == MotionCause::Locked;
                               return isMeant ? Severity::Plain : Severity::Warning;
                             },
                             [](const note::MotionLate&) { return Severity::Fault; }},
                    value);
}

}  // namespace deckpipe
