// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_store.h"

#include <gtest/gtest.h>

#include <thread>

namespace deckpipe {
namespace {

Note mark(std::uint64_t frame, std::string text) {
  Note note;
  note.frame = frame;
  note.text = std::move(text);
  return note;
}

std::vector<std::string> texts(const std::vector<Note>& notes) {
  std::vector<std::string> all;
  for (const Note& note : notes) all.push_back(note.text);
  return all;
}

TEST(NoteStore, KeepsNotesInTheOrderOfTheirFramesAndOfArrivalAtOneFrame) {
  NoteStore notes;
  for (const auto& [frame, text] : {std::pair{5, "a"}, {9, "b"}, {5, "c"}, {0, "d"}, {9, "e"}}) {
    notes.append(mark(static_cast<std::uint64_t>(frame), text));
  }
  EXPECT_EQ(texts(notes.all()), (std::vector<std::string>{"d", "a", "c", "b", "e"}));
  EXPECT_EQ(texts(notes.between(5, 9)), (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(texts(notes.between(6, 9)), (std::vector<std::string>{}));
  EXPECT_EQ(texts(notes.between(9, 2)), (std::vector<std::string>{}));
  EXPECT_EQ(notes.count(), 5u);
}

TEST(NoteStore, KeepsEveryFieldOfANote) {
  const Note note{7, {123}, NoteKind::DriveSaid, {2}, {0x80}, 41, "front"};
  NoteStore notes;
  notes.append(note);
  EXPECT_EQ(notes.all(), std::vector{note});
}

TEST(NoteStore, CutsLongTextBetweenCharacters) {
  NoteStore notes;
  notes.append(mark(0, std::string(NoteStore::kMaxText, 'x')));
  notes.append(mark(0, std::string(NoteStore::kMaxText - 1, 'x') + "ü"));
  const auto all = notes.all();
  EXPECT_EQ(all[0].text.size(), NoteStore::kMaxText);
  EXPECT_EQ(all[1].text, std::string(NoteStore::kMaxText - 1, 'x'));
}

TEST(NoteStore, EveryKindHasAWordThatLeadsBack) {
  for (int i = 0; i <= static_cast<int>(NoteKind::Pipe); ++i) {
    const auto kind = static_cast<NoteKind>(i);
    EXPECT_FALSE(noteKey(kind).empty()) << i;
    EXPECT_EQ(noteKind(noteKey(kind)), kind);
  }
  EXPECT_FALSE(noteKind("no_such_kind"));
}

TEST(NoteStore, IsReadWhileItGrows) {
  NoteStore notes;
  std::thread writer([&] {
    for (std::uint64_t i = 0; i < 2000; ++i) notes.append(mark(i, std::to_string(i)));
  });
  std::size_t last = 0;
  while (last < 2000) {
    const auto all = notes.between(0, 2000);
    ASSERT_GE(all.size(), last);
    last = all.size();
    if (last > 0) {
      ASSERT_EQ(all.back().text, std::to_string(last - 1));
    }
  }
  writer.join();
}

}  // namespace
}  // namespace deckpipe
