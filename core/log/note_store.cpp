// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_store.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace deckpipe {
namespace {

constexpr auto kKeys = std::to_array<std::pair<NoteKind, std::string_view>>({
    {NoteKind::LinkUp, "link_up"},
    {NoteKind::LinkDown, "link_down"},
    {NoteKind::Dropped, "dropped"},
    {NoteKind::Locked, "locked"},
    {NoteKind::Unlocked, "unlocked"},
    {NoteKind::Mark, "mark"},
    {NoteKind::DriveSaid, "drive_said"},
    {NoteKind::DriveUnsaid, "drive_unsaid"},
    {NoteKind::OwnAddress, "own_address"},
    {NoteKind::Asked, "asked"},
    {NoteKind::AskEnded, "ask_ended"},
    {NoteKind::AskWaits, "ask_waits"},
    {NoteKind::StillWaits, "still_waits"},
    {NoteKind::Pipe, "pipe"},
});

// Cut at a whole UTF-8 character.
void shorten(std::string& text, std::size_t length) {
  if (text.size() <= length) return;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
  text.resize(length);
}

}  // namespace

std::string_view noteKey(NoteKind kind) {
  const auto* found =
      std::find_if(kKeys.begin(), kKeys.end(), [kind](const auto& k) { return k.first == kind; });
  return found == kKeys.end() ? std::string_view() : found->second;
}

std::optional<NoteKind> noteKind(std::string_view key) {
  const auto* found =
      std::find_if(kKeys.begin(), kKeys.end(), [key](const auto& k) { return k.second == key; });
  if (found == kKeys.end()) return {};
  return found->first;
}

void NoteStore::append(Note note) {
  shorten(note.text, kMaxText);
  const std::lock_guard lock(m_lock);
  const auto place = std::upper_bound(m_notes.begin(), m_notes.end(), note.frame,
                                      [](std::uint64_t frame, const Note& n) { return frame < n.frame; });
  m_notes.insert(place, std::move(note));
}

std::size_t NoteStore::count() const {
  const std::lock_guard lock(m_lock);
  return m_notes.size();
}

std::vector<Note> NoteStore::between(std::uint64_t from, std::uint64_t to) const {
  const auto before = [](const Note& n, std::uint64_t frame) { return n.frame < frame; };
  const std::lock_guard lock(m_lock);
  const auto first = std::lower_bound(m_notes.begin(), m_notes.end(), from, before);
  const auto last = std::lower_bound(first, m_notes.end(), std::max(from, to), before);
  return {first, last};
}

std::vector<Note> NoteStore::all() const {
  const std::lock_guard lock(m_lock);
  return m_notes;
}

}  // namespace deckpipe
