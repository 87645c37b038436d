// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept beside a log: every note comes back at its place and on its channel, and a sidecar that is cut,
// changed or of another log is told with its line and leaves the log as it is.
#include "log/sidecar.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "log/candump.h"
#include "log/note_text.h"
#include "support/journals.h"

namespace deckpipe {
namespace {

using Kind = SidecarFault::Kind;
using test::Recording;

struct Saved {
  std::string log, sidecar;
};

Saved savedAs(const LogFormat& format, const Recording& recording) {
  const auto writer = format.makeWriter();
  Saved saved;
  const FrameStore& frames = recording.frames;
  for (std::uint8_t i = 0; i < frames.channelCount(); ++i) writer->channel(frames.channelName(i), saved.log);
  const std::vector<Note> notes = recording.notes.all();
  auto note = notes.begin();
  for (std::uint64_t i = 0; i <= frames.count(); ++i) {
    for (; note != notes.end() && note->frame == i; ++note) writer->note(*note, saved.log);
    if (i < frames.count()) writer->frame(frames[i], frames.timeAt(i), saved.log);
  }
  saved.sidecar = writer->beside();
  return saved;
}

// Frames a second apart on two channels, and a note of every kind.
void fill(Recording& recording) {
  const std::uint8_t first = recording.frames.channel("can 0"), second = recording.frames.channel("can1");
  std::vector<Frame> frames;
  for (int i = 0; i < 20; ++i) {
    Frame frame = test::frame("18EFFF80", "0102", 0, (1'700'000'000 + i) * std::int64_t{1'000'000'000});
    frame.channel = i % 3 == 0 ? second : first;
    frames.push_back(frame);
  }
  ASSERT_TRUE(recording.frames.append(frames));
  std::vector<NoteValue> samples = test::noteSamples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    setChannel(samples[i], {i % 2 == 0 ? first : second});
    const std::uint64_t place = std::min<std::uint64_t>(i, 20);
    const Instant before = i == 0 ? Instant{} : recording.frames.timeAt(place - 1);
    recording.notes.append({.frame = place,
                            .time = i == 0 ? recording.frames.timeAt(0) - 5s : before + Duration{123'456'789},
                            .value = samples[i]});
  }
  recording.notes.append({.frame = 20, .time = recording.frames.lastTime() + 3s, .value = note::Mark{}});
}

struct SidecarTest : testing::Test {
  void SetUp() override { fill(written); }
  void TearDown() override {
    std::filesystem::remove(path);
    std::filesystem::remove(sidecarPath(path));
  }
  void put(const Saved& files) const {
    std::ofstream(path, std::ios::binary) << files.log;
    std::ofstream(sidecarPath(path), std::ios::binary) << files.sidecar;
  }
  // The log with its sidecar.
  void open(Recording& read) const { read.result = openLog(path, read.target()); }
  std::optional<SidecarFault> faultOf(const Saved& files) const {
    put(files);
    Recording read;
    open(read);
    EXPECT_TRUE(read.result);
    EXPECT_EQ(read.frames.count(), 20u);
    const auto& fault = read.result.value().sidecarFault;
    if (fault) {
      EXPECT_EQ(fault->path, sidecarPath(path));
      EXPECT_EQ(read.notes.count(), 0u) << "not even a part of it";
    }
    return fault;
  }

  const std::string path = testing::TempDir() + "/sidecar-" + std::to_string(::getpid()) + ".log";
  Recording written;
};

TEST_F(SidecarTest, BringsBackEveryNoteAtItsPlace) {
  const Saved files = savedAs(kCandumpFormat, written);
  put(files);
  Recording read;
  open(read);
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.result.value().sidecarFault, std::nullopt);
  EXPECT_TRUE(read.result.value().hasSidecar);
  EXPECT_EQ(read.result.value().newerParts, 0u);
  std::vector<Note> expected = written.notes.all();
  for (Note& note : expected) {
    // The file's channels are in the order of their first frames.
    if (const auto channel = channelOf(note.value))
      setChannel(note.value, {read.frames.channel(candumpName(written.frames.channelName(channel->value)))});
  }
  EXPECT_EQ(read.notes.all(), expected);
  EXPECT_EQ(read.frames.channelCount(), 2u);
  EXPECT_EQ(read.notes.ranUntil(), kNotYet) << "the samples alone hold it";
  EXPECT_NE(files.sidecar.find("mark text=\"water on\""), std::string::npos) << "a person can read it";
}

TEST_F(SidecarTest, IsNotWantedWithoutANote) {
  Recording bare;
  ASSERT_TRUE(readLog(BytesInMemory("(1.0) can0 123#11\n"), bare.target()));
  EXPECT_EQ(savedAs(kCandumpFormat, bare).sidecar, "");
}

TEST_F(SidecarTest, OfAnEmptyLogHasItsNotes) {
  Recording empty;
  empty.notes.append({.frame = 0, .time = {7}, .value = note::Mark{"nothing came"}});
  put(savedAs(kCandumpFormat, empty));
  Recording read;
  open(read);
  ASSERT_TRUE(read.result);
  EXPECT_EQ(read.notes.all(), empty.notes.all());
}

TEST_F(SidecarTest, CutAtAnyByteIsToldAndCostsOnlyItself) {
  Saved files = savedAs(kCandumpFormat, written);
  const std::string whole = files.sidecar;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    files.sidecar = whole.substr(0, size);
    const auto line =
        static_cast<std::uint64_t>(std::count(files.sidecar.begin(), files.sidecar.end(), '\n'));
    const SidecarFault expected{line == 0 ? Kind::NoSidecar : Kind::Cut, line + 1, {}, {}};
    const auto sidecar = parseSidecar(files.sidecar);
    ASSERT_FALSE(sidecar) << size;
    EXPECT_EQ(sidecar.error(), expected) << size;
    if (size % 50 == 0) {
      EXPECT_EQ(faultOf(files).value().kind, expected.kind) << size;
    }
  }
}

TEST_F(SidecarTest, WithAnyByteChangedIsTold) {
  std::string text = savedAs(kCandumpFormat, written).sidecar;
  for (std::size_t at = 0; at < text.size(); ++at) {
    text[at] = static_cast<char>(text[at] ^ 1);
    EXPECT_FALSE(parseSidecar(text)) << at;
    text[at] = static_cast<char>(text[at] ^ 1);
  }
}

TEST_F(SidecarTest, OfAnotherLogIsToldWithTheLineThatDoesNotFit) {
  const Saved files = savedAs(kCandumpFormat, written);
  put(files);
  std::ofstream(path, std::ios::app) << "(1700000020.000000) can1 123#\n";
  Recording longer;
  open(longer);
  ASSERT_TRUE(longer.result);
  EXPECT_EQ(longer.frames.count(), 21u);
  EXPECT_EQ(longer.notes.count(), 0u);
  EXPECT_EQ(longer.result.value().sidecarFault,
            (SidecarFault{Kind::OtherCount, 2, sidecarPath(path), "20, 21"}));

  Saved other = files;
  other.log[other.log.find("18EFFF80")] = '0';
  EXPECT_EQ(faultOf(other).value().kind, Kind::OtherFrame);
  EXPECT_EQ(faultOf(other).value().line, 3u);
  other = files;
  other.log[other.log.rfind("18EFFF80")] = '0';
  EXPECT_EQ(faultOf(other).value().line, 4u);
}

// Its checksum is right, so that nothing but what it says is wrong.
std::string sealed(std::string text) {
  const auto lines = std::count(text.begin(), text.end(), '\n');
  char end[64];
  std::snprintf(end, sizeof end, "end %ld %08lX\n", static_cast<long>(lines) + 1,
                crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
  return text + end;
}

TEST_F(SidecarTest, ThatSaysSomethingTwiceIsBad) {
  Saved files = savedAs(kCandumpFormat, written);
  const std::string head = files.sidecar.substr(0, files.sidecar.find("note "));
  const std::string mark = "note 900000 0 6 mark text=\"far\"\n";
  std::string many = head;
  many.replace(many.find("frames 20"), 9, "frames 1000000");
  for (const char* line : {"frames 20\n", "first x\n", "last x\n"}) {
    files.sidecar = sealed(many + mark + line);
    const auto fault = faultOf(files);
    ASSERT_TRUE(fault) << line;
    EXPECT_EQ(fault->kind, Kind::BadLine) << line;
    EXPECT_EQ(fault->line, static_cast<std::uint64_t>(std::count(many.begin(), many.end(), '\n')) + 2)
        << line;
  }
  files.sidecar = sealed(head);
  EXPECT_FALSE(faultOf(files));
}

TEST_F(SidecarTest, WhoseNotesAreInDisorderIsReadInOrder) {
  Saved files = savedAs(kCandumpFormat, written);
  const std::string head = files.sidecar.substr(0, files.sidecar.find("note "));
  files.sidecar = sealed(head + "note 9 0 6 mark text=\"b\"\nnote 2 0 6 mark text=\"a\"\n");
  put(files);
  Recording read;
  open(read);
  ASSERT_EQ(read.notes.count(), 2u);
  EXPECT_EQ(read.notes.all()[0].frame, 2u);
}

TEST_F(SidecarTest, OfANewerVersionIsTold) {
  Saved files = savedAs(kCandumpFormat, written);
  files.sidecar.replace(0, files.sidecar.find('\n'), "Deckpipe notes 2");
  const auto fault = faultOf(files);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->kind, Kind::NewerVersion);
  EXPECT_EQ(fault->line, 1u);
}

TEST_F(SidecarTest, ThatCannotBeReadIsToldAndTheLogIsRead) {
  const Saved files = savedAs(kCandumpFormat, written);
  using Make = void (*)(const std::string&);
  for (const auto& [name, make] :
       {std::pair<const char*, Make>("folder", [](const auto& at) { std::filesystem::create_directory(at); }),
        {"link to nothing", [](const auto& at) { std::filesystem::create_symlink("/no/such/file", at); }},
        {"pipe", [](const auto& at) { ASSERT_EQ(mkfifo(at.c_str(), 0600), 0); }},
        {"not ours", [](const auto& at) {
           std::ofstream(at) << "x";
           std::filesystem::permissions(at, std::filesystem::perms::none);
         }}}) {
    SCOPED_TRACE(name);
    put(files);
    std::filesystem::remove(sidecarPath(path));
    make(sidecarPath(path));
    Recording read;
    open(read);
    std::filesystem::remove(sidecarPath(path));
    ASSERT_TRUE(read.result);
    EXPECT_EQ(read.frames.count(), 20u);
    const auto& fault = read.result.value().sidecarFault;
    ASSERT_TRUE(fault);
    // Whoever runs this may read everything.
    if (fault->kind == Kind::NoSidecar && name == std::string_view("not ours")) continue;
    EXPECT_EQ(fault->kind, Kind::CannotRead);
    EXPECT_EQ(fault->path, sidecarPath(path));
    EXPECT_FALSE(fault->detail.empty());
  }
}

TEST_F(SidecarTest, IsNotLookedForBesideARecording) {
  const Saved files = savedAs(kJournalFormat, written);
  EXPECT_EQ(files.sidecar, "");
}

TEST(NoteText, ReadsBackWhatItWrote) {
  std::vector<NoteValue> values = test::noteSamples();
  values.push_back(note::Mark{"a \"quoted\" \\ word\n\x7F und Übung"});
  values.push_back(note::Asked{});
  for (const NoteValue& value : values) {
    std::string text;
    appendNoteText(text, value);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const auto read = noteOfText(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(read.value(), std::optional(value)) << text;
    const auto ofNewer = noteOfText(text + " added=12");
    ASSERT_TRUE(ofNewer) << text;
    EXPECT_EQ(ofNewer.value(), std::optional(value)) << "a later version adds fields at the end";
    for (std::size_t size = 0; size < text.size(); ++size) {
      const auto part = noteOfText(std::string_view(text).substr(0, size));
      EXPECT_TRUE(!part || part.value() != value || text.substr(size).find(' ') == std::string::npos) << size;
    }
  }
}

TEST(NoteText, IsWrittenAsEveryVersionDoes) {
  std::string text;
  appendNoteText(text,
                 note::RequestEnded{{1}, {0x5A}, test::kNotedPin, Request::Vista, RequestEnd::AnsweredLate});
  EXPECT_EQ(text, "10 ask_ended channel=1 address=0x5A pin=\"1032AE100801035\" ask=4 end=7");
}

TEST(NoteText, TellsWhatIsOfANewerVersion) {
  EXPECT_EQ(noteOfText("250 whatever a=1").value(), std::nullopt);
  EXPECT_EQ(noteOfText("8 own_address channel=0 address=0x5A how=99").value(), std::nullopt);
  for (const char* damaged :
       {"", "x", "0 nothing", "6 mark", "6 mark text=water", "6 mark text=\"water", "4 locked channel=256",
        "4 locked channel=1x", "7 drive_said channel=0 address=90 is_drive=1",
        "7 drive_said channel=0 address=0x5A is_drive=2", "9 asked channel=0 address=0x5A pin=\"12\" ask=0"})
    EXPECT_FALSE(noteOfText(damaged)) << damaged;
}

}  // namespace
}  // namespace deckpipe
