// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include "log/note_codec.h"

namespace deckpipe {
namespace {

static_assert(std::endian::native == std::endian::little,
              "frames and numbers are copied as they lie in memory");
static_assert(std::has_unique_object_representations_v<Frame>, "a frame has no byte that is not written");

constexpr std::size_t kCrcBytes = 4;
constexpr std::size_t kClockBytes = 25;
constexpr std::size_t kFirstBytes = 8;
constexpr std::uint32_t kSimulated = 1, kSaved = 2;
static_assert(kFirstBytes + kMaxJournalFrames * sizeof(Frame) <= kMaxJournalContent);

std::uint32_t crcOf(std::span<const std::uint8_t> bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(crc32(before, bytes.data(), static_cast<uInt>(bytes.size())));
}

template <typename T>
void put(JournalBytes& out, T number) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(&number);
  out.insert(out.end(), bytes, bytes + sizeof number);
}

// From the front of `bytes`, which has so many.
template <typename T>
T take(std::span<const std::uint8_t>& bytes) {
  T number;
  std::memcpy(&number, bytes.data(), sizeof number);
  bytes = bytes.subspan(sizeof number);
  return number;
}

// The head of a block at its beginning, and length and CRC where its end is known.
class OpenBlock {
 public:
  OpenBlock(JournalBytes& out, JournalBlock type) : m_out(out), m_begin(out.size()) {
    put(out, static_cast<std::uint16_t>(type));
    put(out, std::uint16_t{0});
    put(out, std::uint64_t{0});  // length and CRC
  }
  std::size_t size() const { return m_out.size() - m_begin - kJournalBlockHead; }
  void close() {
    const auto length = static_cast<std::uint32_t>(size());
    std::uint8_t* const head = m_out.data() + m_begin;
    std::memcpy(head + 4, &length, sizeof length);
    const std::uint32_t crc = journalBlockCrc({head, kJournalBlockHead + length});
    std::memcpy(head + 8, &crc, sizeof crc);
  }

 private:
  JournalBytes& m_out;
  std::size_t m_begin;
};

}  // namespace

void appendJournalHead(JournalBytes& out, const JournalHead& head) {
  const std::size_t begin = out.size();
  out.insert(out.end(), kJournalMagic.begin(), kJournalMagic.end());
  put(out, head.major);
  put(out, JournalHead::kMinor);
  put(out, (head.isSimulated ? kSimulated : 0) | (head.isSaved ? kSaved : 0));
  put(out, head.begin);
  put(out, crcOf(std::span(out).subspan(begin)));
}

bool takeJournalHead(std::span<const std::uint8_t> bytes, JournalHead& head) {
  if (bytes.size() < JournalHead::kBytes ||
      !std::ranges::equal(bytes.first(kJournalMagic.size()), kJournalMagic, {}, {},
                          [](char c) { return static_cast<std::uint8_t>(c); }))
    return false;
  const std::uint32_t crc = crcOf(bytes.first(JournalHead::kBytes - kCrcBytes));
  bytes = bytes.subspan(kJournalMagic.size());
  JournalHead read{.major = take<std::uint16_t>(bytes)};
  take<std::uint16_t>(bytes);
  const auto flags = take<std::uint32_t>(bytes);
  read.isSimulated = (flags & kSimulated) != 0;
  read.isSaved = (flags & kSaved) != 0;
  read.begin = take<std::int64_t>(bytes);
  if (take<std::uint32_t>(bytes) != crc) return false;
  head = read;
  return true;
}

void appendChannelBlock(JournalBytes& out, std::uint8_t index, std::string_view name) {
  OpenBlock block(out, JournalBlock::Channel);
  out.push_back(index);
  out.insert(out.end(), name.begin(), name.end());
  block.close();
}

void appendClockBlocks(JournalBytes& out, std::span<const ChannelOffset> offsets) {
  while (!offsets.empty()) {
    OpenBlock block(out, JournalBlock::Clock);
    const std::size_t n = std::min(offsets.size(), kMaxJournalContent / kClockBytes);
    for (const auto& [channel, offset] : offsets.first(n)) {
      out.push_back(channel);
      put(out, offset.frame);
      put(out, offset.offset);
      put(out, offset.at);
    }
    block.close();
    offsets = offsets.subspan(n);
  }
}

void appendNoteBlocks(JournalBytes& out, std::span<const Note> notes) {
  constexpr std::size_t kMaxOfOne = 2 + 0xFFFF;
  while (!notes.empty()) {
    OpenBlock block(out, JournalBlock::Notes);
    for (; !notes.empty() && block.size() + kMaxOfOne <= kMaxJournalContent; notes = notes.subspan(1))
      appendNote(out, notes.front());
    block.close();
  }
}

void appendFrameBlock(JournalBytes& out, std::uint64_t first, std::span<const Frame> frames) {
  if (frames.empty()) return;
  OpenBlock block(out, JournalBlock::Frames);
  put(out, first);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(frames.data());
  out.insert(out.end(), bytes, bytes + frames.size_bytes());
  block.close();
}

void appendEndBlock(JournalBytes& out) { OpenBlock(out, JournalBlock::End).close(); }

JournalBlockHead journalBlockHead(std::span<const std::uint8_t> bytes) {
  JournalBlockHead head;
  head.type = take<std::uint16_t>(bytes);
  head.version = take<std::uint16_t>(bytes);
  head.length = take<std::uint32_t>(bytes);
  head.crc = take<std::uint32_t>(bytes);
  return head;
}

std::uint32_t journalBlockCrc(std::span<const std::uint8_t> block) {
  return crcOf(block.subspan(kJournalBlockHead), crcOf(block.first(8)));
}

bool takeChannelBlock(std::span<const std::uint8_t> content, std::uint8_t& index, std::string_view& name) {
  if (content.empty()) return false;
  index = content.front();
  name = {reinterpret_cast<const char*>(content.data()) + 1, content.size() - 1};
  return true;
}

bool takeClockBlock(std::span<const std::uint8_t> content, std::vector<ChannelOffset>& offsets) {
  if (content.size() % kClockBytes != 0) return false;
  while (!content.empty()) {
    ChannelOffset read;
    read.channel = take<std::uint8_t>(content);
    read.offset.frame = take<std::uint64_t>(content);
    read.offset.offset = take<std::int64_t>(content);
    read.offset.at = take<std::int64_t>(content);
    offsets.push_back(read);
  }
  return true;
}

bool takeFrameBlock(std::span<const std::uint8_t> content, std::uint64_t& first, std::vector<Frame>& frames) {
  if (content.size() <= kFirstBytes || (content.size() - kFirstBytes) % sizeof(Frame) != 0) return false;
  first = take<std::uint64_t>(content);
  frames.resize(content.size() / sizeof(Frame));
  std::memcpy(frames.data(), content.data(), content.size());
  return std::ranges::all_of(frames, [](const Frame& frame) { return frame.length <= 8; });
}

}  // namespace deckpipe
