// SPDX-License-Identifier: GPL-3.0-or-later
// What a journal gives back: everything as it was, and of a file that was cut or damaged everything before
// the damage, and nothing else.
#include <gtest/gtest.h>

#include <random>

#include "log/log_stream.h"
#include "support/journals.h"

namespace deckpipe {
namespace {

using test::journalOf;
using test::Recording;
using test::told;

void expectSame(const Recording& read, const Recording& written) {
  EXPECT_EQ(told(read.frames), told(written.frames));
  EXPECT_EQ(read.notes.all(), written.notes.all());
  ASSERT_EQ(read.frames.channelCount(), written.frames.channelCount());
  EXPECT_EQ(read.frames.jumps().size(), written.frames.jumps().size());
  for (std::uint64_t i = 0; i < read.frames.jumps().size(); ++i)
    EXPECT_EQ(read.frames.jumps()[i], written.frames.jumps()[i]);
}

// Part of what was written, from the first frame on; notes not beyond its last frame.
void expectBeginning(const Recording& read, const Recording& written, const std::string& what) {
  const std::vector<std::string> all = told(written.frames), part = told(read.frames);
  ASSERT_LE(part.size(), all.size()) << what;
  EXPECT_TRUE(std::equal(part.begin(), part.end(), all.begin())) << what;
  const std::vector<Note> notes = read.notes.all(), allNotes = written.notes.all();
  ASSERT_LE(notes.size(), allNotes.size()) << what;
  EXPECT_TRUE(std::equal(notes.begin(), notes.end(), allNotes.begin())) << what;
  EXPECT_TRUE(notes.empty() || notes.back().frame <= read.frames.count()) << what;
}

TEST(Journal, BringsBackFramesNotesAndLogTimesOfTwoLiveChannels) {
  Recording written;
  written.fill();
  ASSERT_GE(written.frames.jumps().size(), 1u);
  ASSERT_TRUE(written.frames.offsets(0) && written.frames.offsets(1));
  Recording read;
  read.read(journalOf(written));
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.result.value(), (ReadSummary{.frames = written.frames.count(), .isOwn = true}));
  expectSame(read, written);
}

TEST(Journal, BringsBackTheLogTimesOfAFile) {
  Recording written;
  ASSERT_TRUE(readLog(BytesInMemory("(100.0) can0 123#11\n(5000.0) can0 123#12\n(100.1) can0 123#13\n"
                                    "(3.0) can0 123#14\n(3.5) can0 123#15\n(3.6) can1 123#16\n"),
                      written.target()));
  Recording read;
  read.read(journalOf(written));
  expectSame(read, written);
}

TEST(Journal, IsWrittenInAnyPieces) {
  Recording written;
  test::FakeDisk disk;
  JournalWriter writer(written.frames, written.notes, disk.maker(), test::someHead);
  for (int i = 0; i < 20; ++i) {
    writer.timeCame(Instant{} + i * 250ms);
    written.fill();
    if (i == 10) written.notes.append({.frame = 3, .value = note::Mark{"later, at an earlier place"}});
  }
  writer.end();
  Recording read;
  read.read(disk.bytes);
  ASSERT_TRUE(read.result);
  EXPECT_FALSE(read.result.value().isOpenEnded);
  expectSame(read, written);
}

TEST(Journal, OfManyFramesHasManyBlocksAndReportsProgress) {
  Recording written;
  std::vector<Frame> frames(3 * kMaxJournalFrames + 5, test::frame("123", "00"));
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].stamp = static_cast<std::int64_t>(i) * 1'000'000;
  written.frames.channel("can0");
  ASSERT_TRUE(written.frames.append(frames));
  const JournalBytes bytes = journalOf(written);
  Recording read;
  std::uint64_t last = 0;
  read.read(bytes, {.onProgress = [&](const ReadProgress& progress) {
              EXPECT_GE(progress.frames, last);
              last = progress.frames;
              EXPECT_EQ(progress.bytesTotal, bytes.size());
              return true;
            }});
  EXPECT_EQ(last, frames.size());
  expectSame(read, written);

  Recording part;
  part.read(bytes, {.onProgress = [](const ReadProgress& progress) { return progress.frames == 0; }});
  ASSERT_TRUE(part.result);
  EXPECT_TRUE(part.result.value().cancelled);
  EXPECT_EQ(part.frames.count(), kMaxJournalFrames);
}

TEST(Journal, PutsEachNoteBeforeItsFrameAsTheLogGrows) {
  struct Watch {
    std::uint64_t frame;
    std::size_t notes;
  };
  Recording written;
  written.fill();
  Recording read;
  std::vector<Watch> seen;
  // Each block of frames is cut where a note stands; the last progress sees all of it.
  read.read(journalOf(written), {.onProgress = [&](const ReadProgress&) {
              seen.push_back({read.frames.count(), read.notes.count()});
              return true;
            }});
  for (const Watch& watch : seen) {
    const auto due = written.notes.between(0, watch.frame);
    EXPECT_GE(watch.notes, due.size());
  }
}

// The blocks of a journal, by where they begin.
std::vector<std::size_t> blocksOf(const JournalBytes& bytes) {
  std::vector<std::size_t> begins;
  for (std::size_t at = JournalHead::kBytes; at < bytes.size();) {
    begins.push_back(at);
    at += kJournalBlockHead + journalBlockHead(std::span(bytes).subspan(at)).length;
  }
  return begins;
}

TEST(Journal, CutAtAnyByteKeepsEverythingBeforeThatBlock) {
  Recording written;
  test::FakeDisk disk;
  JournalWriter writer(written.frames, written.notes, disk.maker(), test::someHead);
  for (int i = 0; i < 3; ++i) {
    written.fill();
    writer.timeCame(Instant{} + i * 250ms);
  }
  writer.end();
  const std::vector<std::size_t> blocks = blocksOf(disk.bytes);
  ASSERT_GT(blocks.size(), 8u);
  std::uint64_t frames = 0;
  for (std::size_t size = kJournalMagic.size(); size <= disk.bytes.size(); ++size) {
    const std::string what = "cut at " + std::to_string(size);
    Recording read;
    read.read(std::span(disk.bytes).first(size));
    ASSERT_TRUE(read.result) << what;
    expectBeginning(read, written, what);
    EXPECT_GE(read.frames.count(), frames) << what << ": more bytes, no less frames";
    frames = read.frames.count();
    // Where the last whole block ends.
    std::size_t whole = size < JournalHead::kBytes ? 0 : JournalHead::kBytes;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const std::size_t end = i + 1 < blocks.size() ? blocks[i + 1] : disk.bytes.size();
      if (end <= size) whole = end;
    }
    const ReadSummary& summary = read.result.value();
    EXPECT_EQ(summary.cutBytes, size - whole) << what;
    EXPECT_EQ(summary.isOpenEnded, size < disk.bytes.size()) << what;
  }
  EXPECT_EQ(frames, written.frames.count());
}

// Several blocks of each type.
JournalBytes inPieces(Recording& written, int rounds = 3) {
  test::FakeDisk disk;
  JournalWriter writer(written.frames, written.notes, disk.maker(), test::someHead);
  for (int i = 0; i < rounds; ++i) {
    written.fill();
    writer.timeCame(Instant{} + i * 250ms);
  }
  writer.end();
  return disk.bytes;
}

// What stands in a frame, without its place and its log time.
std::vector<std::string> contentOf(const FrameStore& frames) {
  std::vector<std::string> all = told(frames);
  for (std::string& one : all) one.erase(0, one.find(' '));
  return all;
}

std::size_t sizeOfBlock(const JournalBytes& bytes, std::size_t at) {
  return kJournalBlockHead + journalBlockHead(std::span(bytes).subspan(at)).length;
}

TEST(Journal, LosesNothingButTheBlockOfAByteThatIsWrong) {
  Recording written;
  const JournalBytes good = inPieces(written);
  const std::vector<std::size_t> blocks = blocksOf(good);
  const std::vector<std::string> all = contentOf(written.frames);
  std::mt19937 random(1);
  for (std::size_t at = JournalHead::kBytes; at < blocks.back(); ++at) {
    JournalBytes bytes = good;
    bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1u << random() % 8));
    const std::string what = "byte " + std::to_string(at);
    Recording read;
    read.read(bytes);
    ASSERT_TRUE(read.result) << what;
    const std::size_t block = *std::prev(std::upper_bound(blocks.begin(), blocks.end(), at));
    const JournalBlockHead head = journalBlockHead(std::span(good).subspan(block));
    const auto type = static_cast<JournalBlock>(head.type);
    std::uint64_t first = 0, lost = 0;
    if (type == JournalBlock::Frames) {
      std::memcpy(&first, good.data() + block + kJournalBlockHead, sizeof first);
      lost = (head.length - sizeof first) / sizeof(Frame);
    }
    const ReadSummary& summary = read.result.value();
    // Of the last frames a note behind them tells how many they were.
    const bool isFollowed = std::ranges::any_of(blocks, [&](std::size_t other) {
      const JournalBlockHead behind = journalBlockHead(std::span(good).subspan(other));
      return other > block && static_cast<JournalBlock>(behind.type) == JournalBlock::Frames;
    });
    const bool isNoted = std::ranges::any_of(blocks, [&](std::size_t other) {
      const JournalBlockHead behind = journalBlockHead(std::span(good).subspan(other));
      return other > block && static_cast<JournalBlock>(behind.type) == JournalBlock::Notes;
    });
    const bool isTold = !isFollowed && isNoted;
    const std::uint64_t missed = isFollowed ? lost
                                 : isTold   ? written.notes.all().back().frame - (all.size() - lost)
                                            : 0;
    EXPECT_EQ(summary.damage,
              (Damage{1, kJournalBlockHead + head.length, block, missed, !isFollowed && !isTold}))
        << what;
    EXPECT_EQ(summary.cutBytes, 0u) << what;
    EXPECT_FALSE(summary.isOpenEnded) << what;
    EXPECT_FALSE(summary.isWhole()) << what;
    ASSERT_EQ(read.frames.count(), all.size() - lost) << what;
    EXPECT_TRUE(type == JournalBlock::Notes ||
                read.notes.count() == written.notes.count() + (missed > 0 ? 1 : 0))
        << what;
    if (type != JournalBlock::Notes) {
      EXPECT_EQ(read.notes.missedFrames(), written.notes.missedFrames() + missed) << what;
    }
    if (type == JournalBlock::Channel) continue;
    std::vector<std::string> expected = all;
    expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(first),
                   expected.begin() + static_cast<std::ptrdiff_t>(first + lost));
    EXPECT_EQ(contentOf(read.frames), expected) << what;
  }
}

TEST(Journal, KeepsTheLogTimesBehindFramesThatAreLost) {
  Recording written;
  const JournalBytes good = inPieces(written, 4);
  const std::vector<std::string> all = told(written.frames);
  for (const std::size_t block : blocksOf(good)) {
    const JournalBlockHead head = journalBlockHead(std::span(good).subspan(block));
    if (static_cast<JournalBlock>(head.type) != JournalBlock::Frames) continue;
    std::uint64_t first = 0;
    std::memcpy(&first, good.data() + block + kJournalBlockHead, sizeof first);
    const std::uint64_t lost = (head.length - sizeof first) / sizeof(Frame);
    JournalBytes bytes = good;
    bytes[block + kJournalBlockHead + 20] ^= 1;
    Recording read;
    read.read(bytes);
    std::vector<std::string> expected = all;
    expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(first),
                   expected.begin() + static_cast<std::ptrdiff_t>(first + lost));
    EXPECT_EQ(told(read.frames), expected) << "block at " << block;
    // Notes of lost frames stand where those were; all others at their frames.
    std::vector<Note> notes = read.notes.all(), allNotes = written.notes.all();
    std::erase_if(notes, [](const Note& note) {
      const auto* leftOut = std::get_if<note::LeftOut>(&note.value);
      return leftOut != nullptr && leftOut->why == note::LeftOut::Why::Damaged;
    });
    ASSERT_EQ(notes.size(), allNotes.size());
    for (std::size_t i = 0; i < notes.size(); ++i) {
      EXPECT_EQ(notes[i].value, allNotes[i].value);
      const std::uint64_t frame = allNotes[i].frame;
      EXPECT_EQ(notes[i].frame, frame <= first ? frame : frame <= first + lost ? first : frame - lost);
    }
  }
}

TEST(Journal, CountsEachDamagedPlace) {
  Recording written;
  JournalBytes bytes = inPieces(written);
  const std::vector<std::size_t> blocks = blocksOf(bytes);
  ASSERT_GT(blocks.size(), 9u);
  std::uint64_t lost = 0;
  for (const std::size_t i : {2u, 3u, 7u}) {  // two of them side by side
    bytes[blocks[i] + 9] ^= 0x40;
    lost += sizeOfBlock(bytes, blocks[i]);
  }
  Recording read;
  read.read(bytes);
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.result.value().damage.places, 2u);
  EXPECT_EQ(read.result.value().damage.bytes, lost);
  EXPECT_EQ(read.result.value().damage.firstAt, blocks[2]);
}

TEST(Journal, FindsItsBlocksWhereBytesAreMissing) {
  Recording written;
  const JournalBytes good = inPieces(written);
  const std::vector<std::size_t> blocks = blocksOf(good);
  const std::size_t middle = blocks[blocks.size() / 2];
  JournalBytes bytes = good;
  bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(middle) + 5,
              bytes.begin() + static_cast<std::ptrdiff_t>(middle) + 8);
  Recording read;
  read.read(bytes);
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.result.value().damage.places, 1u);
  EXPECT_EQ(read.result.value().damage.bytes, sizeOfBlock(good, middle) - 3);
  EXPECT_FALSE(read.result.value().isOpenEnded);
}

TEST(Journal, SaysOfAChannelThatItsNameIsLost) {
  Recording written;
  JournalBytes bytes = inPieces(written);
  bytes[blocksOf(bytes).front() + kJournalBlockHead + 1] ^= 1;
  Recording read;
  read.read(bytes);
  EXPECT_EQ(read.frames.count(), written.frames.count());
  ASSERT_EQ(read.frames.channelCount(), 2u);
  EXPECT_EQ(read.frames.channelName(0), "name-lost-0");
  EXPECT_EQ(read.frames.channelName(1), "can1");
}

TEST(Journal, ATimeBehindALostClockGoesOnFromTheFrameBefore) {
  // Stamps of the wall clock, log times since the machine began.
  constexpr std::int64_t kWall = 1'796'000'000'000'000'000, kSecond = 1'000'000'000;
  JournalBytes bytes;
  appendJournalHead(bytes, {});
  appendChannelBlock(bytes, 0, "can0");
  const std::size_t clock = bytes.size();
  const auto clockAt = [&](std::uint64_t frame) {
    const auto at = static_cast<std::int64_t>(frame) * kSecond + 5'000 * kSecond;
    const ChannelOffset offset{0, {frame, 5'000 * kSecond - kWall, at}};
    appendClockBlocks(bytes, {&offset, 1});
  };
  for (std::uint64_t i = 0; i < 3; ++i) {
    if (i != 1) clockAt(i);
    Frame frame = test::frame("123", "00");
    frame.stamp = kWall + static_cast<std::int64_t>(i) * kSecond;
    appendFrameBlock(bytes, i, {&frame, 1});
  }
  appendEndBlock(bytes);
  bytes[clock + kJournalBlockHead] ^= 1;
  Recording read;
  read.read(bytes);
  ASSERT_EQ(read.frames.count(), 3u);
  EXPECT_EQ(read.frames.timeAt(0).ns, 0);
  EXPECT_EQ(read.frames.timeAt(1).ns, kSecond);
  EXPECT_EQ(read.frames.timeAt(2).ns, 5'002 * kSecond) << "as the next block tells";
}

TEST(Journal, IsCutOnlyWhereItEnds) {
  Recording written;
  const JournalBytes good = inPieces(written);
  const std::vector<std::size_t> blocks = blocksOf(good);
  JournalBytes bytes = good;
  bytes[blocks.back() + 8] ^= 1;  // the end itself
  Recording read;
  read.read(bytes);
  EXPECT_EQ(read.result.value().damage.places, 1u);
  EXPECT_EQ(read.result.value().cutBytes, 0u);
  EXPECT_TRUE(read.result.value().isOpenEnded);

  bytes = good;
  bytes.pop_back();
  bytes[blocks[4] + 8] ^= 1;
  Recording both;
  both.read(bytes);
  EXPECT_EQ(both.result.value().damage.places, 1u);
  EXPECT_EQ(both.result.value().cutBytes, kJournalBlockHead - 1);
}

TEST(Journal, OfBytesThatAllLookLikeBlocksIsReadInLinearTime) {
  Recording written;
  JournalBytes bytes = inPieces(written);
  const std::size_t middle = blocksOf(bytes)[4];
  JournalBytes noise;
  while (noise.size() < 3'000'000) {
    for (const std::uint8_t byte : std::initializer_list<std::uint8_t>{4, 0, 0, 0, 4, 0, 0x0F, 0})
      noise.push_back(byte);
  }
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(middle), noise.begin(), noise.end());
  Recording read;
  read.read(bytes);
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.result.value().damage, (Damage{1, noise.size(), middle, 0}));
  EXPECT_EQ(contentOf(read.frames), contentOf(written.frames));
}

TEST(Journal, TakesZeroesBehindItsEndForNoBlock) {
  Recording written;
  written.fill();
  JournalBytes bytes = journalOf(written, false);
  bytes.resize(bytes.size() + 5'000);
  Recording read;
  read.read(bytes);
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.result.value().cutBytes, 5'000u);
  expectSame(read, written);
}

TEST(Journal, IsReadWhereOnlyItsHeadIsDamaged) {
  Recording written;
  written.fill();
  const JournalBytes good = journalOf(written);
  for (std::size_t at = 0; at < JournalHead::kBytes; ++at) {
    JournalBytes bytes = good;
    bytes[at] ^= 2;
    JournalHead head{.begin = 7};
    EXPECT_FALSE(takeJournalHead(bytes, head));
    EXPECT_EQ(head, (JournalHead{.begin = 7})) << "nothing of it counts";
    Recording read;
    read.read(bytes);
    ASSERT_TRUE(read.result) << at;
    EXPECT_EQ(read.result.value().damage, (Damage{1, JournalHead::kBytes, 0, 0})) << at;
    EXPECT_EQ(contentOf(read.frames), contentOf(written.frames)) << at;
  }
  JournalBytes bytes = good;
  std::fill_n(bytes.begin(), 60, std::uint8_t{0});
  Recording read;
  read.read(bytes);
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.frames.count(), written.frames.count());
}

TEST(Journal, OfWhichNothingIsWholeIsRefused) {
  JournalBytes bytes;
  appendJournalHead(bytes, {});
  bytes[20] ^= 1;
  bytes.resize(500, 7);
  Recording read;
  read.read(bytes);
  ASSERT_FALSE(read.result);
  EXPECT_EQ(read.result.error(), (ReadError{ReadError::Kind::Damaged, {}, "Deckpipe recording"}));
}

TEST(Journal, OfANewerVersionIsRefusedByName) {
  JournalBytes bytes;
  appendJournalHead(bytes, {.major = JournalHead::kMajor + 1});
  Recording read;
  read.read(bytes);
  ASSERT_FALSE(read.result);
  EXPECT_EQ(read.result.error(), (ReadError{ReadError::Kind::NewerVersion, "2", "Deckpipe recording"}));
}

// Changes type or version of a block, with the CRC that belongs to it.
JournalBytes withBlock(JournalBytes bytes, std::size_t at, std::size_t byte, std::uint8_t value) {
  bytes[at + byte] = value;
  const std::uint32_t length = journalBlockHead(std::span(bytes).subspan(at)).length;
  const std::uint32_t crc = journalBlockCrc(std::span(bytes).subspan(at, kJournalBlockHead + length));
  std::memcpy(bytes.data() + at + 8, &crc, sizeof crc);
  return bytes;
}

TEST(Journal, SkipsAndCountsWhatANewerMinorVersionAdded) {
  Recording written;
  written.fill();
  const JournalBytes bytes = journalOf(written);
  const std::vector<std::size_t> blocks = blocksOf(bytes);
  const auto notes = std::ranges::find_if(blocks, [&](std::size_t at) {
    return journalBlockHead(std::span(bytes).subspan(at)).type ==
           static_cast<std::uint16_t>(JournalBlock::Notes);
  });
  ASSERT_NE(notes, blocks.end());
  for (const std::size_t byte : {0u, 2u}) {  // the type, its version
    Recording read;
    read.read(withBlock(bytes, *notes, byte, 77));
    ASSERT_TRUE(read.result);
    EXPECT_EQ(told(read.frames), told(written.frames));
    EXPECT_EQ(read.notes.count(), 0u);
    EXPECT_EQ(read.result.value().newerParts, 1u);
  }
  // A kind of note.
  Recording read;
  read.read(withBlock(bytes, *notes, kJournalBlockHead + 2, 250));
  EXPECT_EQ(read.notes.count() + 1, written.notes.count());
  EXPECT_EQ(read.result.value().newerParts, 1u);
}

TEST(Journal, EndsAtANewerVersionOfWhatTheRestNeedsAndSaysSo) {
  Recording written;
  test::FakeDisk disk;
  JournalWriter writer(written.frames, written.notes, disk.maker(), test::someHead);
  for (int i = 0; i < 3; ++i) {
    writer.timeCame({i * 2'000'000'000ll});
    written.fill();
  }
  writer.end();
  const std::vector<std::size_t> blocks = blocksOf(disk.bytes);
  for (const JournalBlock type : {JournalBlock::Channel, JournalBlock::Clock, JournalBlock::Frames}) {
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const std::size_t at = blocks[i];
      if (journalBlockHead(std::span(disk.bytes).subspan(at)).type != static_cast<std::uint16_t>(type))
        continue;
      const std::string what = "block " + std::to_string(i);
      Recording before, read;
      before.read(std::span(disk.bytes).first(at));
      read.read(withBlock(disk.bytes, at, 2, 1));
      ASSERT_TRUE(read.result) << what;
      EXPECT_EQ(told(read.frames), told(before.frames)) << what;
      EXPECT_EQ(read.result.value().cutBytes, 0u) << what << ": newer, not damaged";
      EXPECT_EQ(read.result.value().newerParts, blocks.size() - 1 - i) << what << ": all but the end";
      EXPECT_FALSE(read.result.value().isOpenEnded) << what;
    }
  }
}

// To look at all that wait for each block would take minutes.
TEST(Journal, OfManyNotesInFallingOrderBeforeTheirFramesIsRead) {
  Recording written;
  written.fill();
  JournalBytes bytes = journalOf(written, false);
  constexpr std::uint64_t kNotes = 60'000;
  for (std::uint64_t i = kNotes; i > 0; --i) {
    const std::vector<Note> note{{.frame = written.frames.count() + i, .value = note::Locked{}}};
    appendNoteBlocks(bytes, note);
  }
  Recording read;
  read.read(bytes);
  expectSame(read, written);
}

TEST(Journal, LeavesOutNotesOfFramesThatWereNotWritten) {
  Recording written;
  written.fill();
  JournalBytes bytes = journalOf(written, false);
  const std::vector<Note> beyond{{.frame = written.frames.count() + 5, .value = note::Mark{"of nothing"}}};
  appendNoteBlocks(bytes, beyond);
  Recording read;
  read.read(bytes);
  expectSame(read, written);
}

TEST(Journal, IsKnownByItsFirstBytes) {
  Recording written;
  written.fill();
  const JournalBytes bytes = journalOf(written);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_EQ(kJournalFormat.sniff(text, true), Sniff::Yes);
  EXPECT_EQ(kJournalFormat.sniff(text.substr(0, 5), false), Sniff::Open);
  EXPECT_EQ(kJournalFormat.sniff(text.substr(0, 5), true), Sniff::No);
  EXPECT_EQ(kJournalFormat.sniff("(1.0) can0 123#11\n", false), Sniff::No);
}

TEST(Journal, IsReadFromAPipeHoweverItIsCut) {
  Recording written;
  written.fill(3);
  const JournalBytes bytes = journalOf(written);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const std::size_t piece : {1u, 7u, 1'000u, 1'000'000u}) {
    Recording read;
    LogStream stream(read.target());
    for (std::size_t at = 0; at < text.size(); at += piece) EXPECT_TRUE(stream.feed(text.substr(at, piece)));
    const auto result = stream.finish();
    ASSERT_TRUE(result) << piece;
    EXPECT_EQ(result.value(), (ReadSummary{.frames = written.frames.count(), .isOwn = true}));
    expectSame(read, written);
  }
}

TEST(Journal, FromAPipeThatBreaksOffOrIsDamagedIsReadAsAFileIs) {
  Recording written;
  written.fill();
  JournalBytes bytes = journalOf(written);
  const auto expectAsFile = [](std::span<const std::uint8_t> part, const std::string& what) {
    Recording file, pipe;
    file.read(part);
    LogStream stream(pipe.target());
    const std::string_view text(reinterpret_cast<const char*>(part.data()), part.size());
    for (std::size_t at = 0; at < text.size(); at += 100) stream.feed(text.substr(at, 100));
    const auto result = stream.finish();
    ASSERT_EQ(bool(result), bool(file.result)) << what;
    if (!result) {
      EXPECT_EQ(result.error(), file.result.error()) << what;
      return;
    }
    EXPECT_EQ(result.value(), file.result.value()) << what;
    EXPECT_EQ(told(pipe.frames), told(file.frames)) << what;
    EXPECT_EQ(pipe.notes.all(), file.notes.all()) << what;
  };
  for (std::size_t size = kJournalMagic.size(); size <= bytes.size(); ++size)
    expectAsFile(std::span(bytes).first(size), "cut at " + std::to_string(size));
  for (std::size_t at = kJournalMagic.size(); at < bytes.size(); at += 13) {
    bytes[at] ^= 0x10u;
    expectAsFile(bytes, "damaged at " + std::to_string(at));
    bytes[at] ^= 0x10u;
  }
}

// Written as whoever saves a log writes it.
JournalBytes exportOf(const Recording& recording) {
  const auto writer = kJournalFormat.makeWriter();
  std::string out;
  writer->begin(out);
  const FrameStore& frames = recording.frames;
  for (std::uint8_t i = 0; i < frames.channelCount(); ++i) writer->channel(frames.channelName(i), out);
  std::vector<Note> notes = recording.notes.all();
  auto note = notes.begin();
  for (std::uint64_t i = 0; i <= frames.count(); ++i) {
    for (; note != notes.end() && note->frame == i; ++note) writer->note(*note, out);
    if (i < frames.count()) writer->frame(frames[i], frames.timeAt(i), out);
  }
  writer->end(out);
  EXPECT_EQ(writer->beside(), "");
  return {out.begin(), out.end()};
}

TEST(Journal, OfALogThatIsSavedBringsBackFramesNotesAndLogTimes) {
  Recording live;
  live.fill(4);
  Recording file;
  ASSERT_TRUE(readLog(BytesInMemory("(100.0) can0 123#11\n(5000.0) can0 123#12\n(100.1) can0 123#13\n"
                                    "(3.0) can0 123#14\n(3.5) can0 123#15\n(3.6) can1 123#16\n"),
                      file.target()));
  Recording timeless;
  ASSERT_TRUE(readLog(BytesInMemory("  can0  123   [1]  11\n  can0  123   [1]  12\n"), timeless.target()));
  Recording many;
  many.frames.channel("can0");
  std::vector<Frame> frames(2 * kMaxJournalFrames + 5, test::frame("123", "00"));
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].stamp = static_cast<std::int64_t>(i) * 1'000'000;
  ASSERT_TRUE(many.frames.append(frames));
  many.notes.append({.frame = kMaxJournalFrames + 1, .time = {4}, .value = note::Mark{"between"}});
  for (const Recording* written : {&live, &file, &timeless, &many}) {
    Recording read;
    read.read(exportOf(*written));
    ASSERT_TRUE(read.result);
    EXPECT_EQ(read.result.value(), (ReadSummary{.frames = written->frames.count(), .isOwn = true}));
    expectSame(read, *written);
  }
}

}  // namespace
}  // namespace deckpipe
