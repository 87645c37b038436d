// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/note_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <thread>

#include "support/note_samples.h"

namespace deckpipe {
namespace {

Note mark(std::uint64_t frame, std::string text) {
  return {.frame = frame, .value = note::Mark{std::move(text)}};
}

std::string textOf(const Note& note) { return std::get<note::Mark>(note.value).text.str(); }

std::vector<std::string> texts(const std::vector<Note>& notes) {
  std::vector<std::string> all;
  for (const Note& note : notes) all.push_back(textOf(note));
  return all;
}

TEST(NoteStore, KeepsNotesInTheOrderOfTheirFramesAndOfTimeAtOneFrame) {
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

TEST(NoteStore, PutsANoteWhereItsTimeIs) {
  NoteStore notes;
  for (const std::int64_t at : {100, 160, 130}) {
    notes.append({.frame = 5, .time = {at}, .value = note::Mark{std::to_string(at)}});
  }
  EXPECT_EQ(texts(notes.all()), (std::vector<std::string>{"100", "130", "160"}));
  EXPECT_EQ(notes.lastTime(), Instant{160});
}

// To move all that are there for each new one would take minutes.
TEST(NoteStore, TakesManyNotesInFallingOrder) {
  constexpr std::int64_t kNotes = 250'000;
  NoteStore notes;
  for (std::int64_t i = kNotes; i > 0; --i) notes.append({.frame = 3, .time = {i}, .value = note::Locked{}});
  const std::vector<Note> all = notes.all();
  ASSERT_EQ(all.size(), static_cast<std::size_t>(kNotes));
  EXPECT_TRUE(std::ranges::is_sorted(all, {}, &Note::time));
}

TEST(NoteStore, TellsNotesAsTheyWereAppended) {
  NoteStore notes;
  for (const std::uint64_t frame : {5u, 9u, 5u, 0u}) notes.append(mark(frame, std::to_string(notes.count())));
  EXPECT_EQ(texts(notes.appendedAfter(0)), (std::vector<std::string>{"0", "1", "2", "3"}));
  EXPECT_EQ(texts(notes.appendedAfter(2)), (std::vector<std::string>{"2", "3"}));
  EXPECT_TRUE(notes.appendedAfter(4).empty());
  EXPECT_TRUE(notes.appendedAfter(9).empty());
}

TEST(NoteStore, TellsTheFiltersAsTheyWereAppended) {
  NoteStore notes;
  EXPECT_TRUE(notes.filters().empty());
  notes.append(mark(0, "no filter"));
  for (const char* text : {"sa=80", "not t=3"}) notes.append({.frame = 2, .value = note::Filtered{text}});
  EXPECT_EQ(notes.filters(), (std::vector<std::string>{"sa=80", "not t=3"}));
}

TEST(NoteStore, KeepsUntilWhenTheLogRanAndNoNoteOfIt) {
  NoteStore notes;
  EXPECT_EQ(notes.ranUntil(), kNotYet);
  notes.append(mark(3, "a"));
  for (const std::int64_t at : {500, 900, 700})
    notes.append({.frame = 3, .time = {at}, .value = note::RanUntil{}});
  EXPECT_EQ(notes.ranUntil(), Instant{900}) << "it never goes back";
  EXPECT_EQ(texts(notes.all()), std::vector<std::string>{"a"});
  EXPECT_EQ(notes.count(), 1u);
  EXPECT_TRUE(notes.appendedAfter(1).empty()) << "nothing new for who writes the notes down";
}

TEST(NoteStore, TellsThoseOfSomeKindsInOrder) {
  NoteStore notes;
  notes.append(mark(7, "late"));
  notes.append({.frame = 5, .value = note::LinkUp{}});
  notes.append({.frame = 4, .value = note::Dropped{{}, 3}});
  notes.append(mark(2, "early"));
  EXPECT_EQ(texts(notes.of<note::Mark>()), (std::vector<std::string>{"early", "late"}));
  const auto both = notes.of<note::LinkUp, note::Dropped>();
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(noteKey(both[0].value), "dropped");
  EXPECT_EQ(noteKey(both[1].value), "link_up");
}

TEST(NoteStore, KeepsEveryFieldOfEveryKind) {
  NoteStore notes;
  std::vector<Note> expected;
  for (const NoteValue& value : test::noteSamples()) {
    if (std::holds_alternative<note::RanUntil>(value)) continue;
    expected.push_back({7, {123}, value});
    notes.append(expected.back());
  }
  EXPECT_EQ(notes.all(), expected);
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
      ASSERT_EQ(textOf(all.back()), std::to_string(last - 1));
    }
  }
  writer.join();
}

TEST(NoteText, CutsLongTextBetweenCharacters) {
  constexpr std::size_t kMax = NoteText::kMaxBytes;
  EXPECT_EQ(NoteText(std::string(kMax, 'x')).str().size(), kMax);
  std::string text(kMax - 1, 'x');
  const NoteText cut(text.append("ü"));
  EXPECT_EQ(cut.str(), std::string(kMax - 1, 'x'));
}

TEST(NoteKey, IsAWordOfItsOwnForEveryKind) {
  std::set<std::string_view> words;
  for (const NoteValue& value : test::noteSamples()) words.insert(noteKey(value));
  EXPECT_EQ(words.size(), std::variant_size_v<NoteValue>);
  EXPECT_FALSE(words.contains(""));
}

}  // namespace
}  // namespace deckpipe
