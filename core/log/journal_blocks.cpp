// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/journal_blocks.h"

#include <zlib.h>

#include <algorithm>
#include <utility>

namespace deckpipe {
namespace {

constexpr std::size_t kStep = 256;
// The CRC of a block as short as this is calculated anew.
constexpr std::size_t kShort = 2'048;

std::uint32_t crcAfter(std::span<const std::uint8_t> bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(crc32(before, bytes.data(), static_cast<uInt>(bytes.size())));
}

std::uint32_t crcOfBoth(std::uint32_t first, std::uint32_t second, std::size_t sizeOfSecond) {
  return static_cast<std::uint32_t>(crc32_combine(first, second, static_cast<z_off_t>(sizeOfSecond)));
}

// With its head; 0 if the head is not whole, or no block is so long.
std::size_t sizeOf(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kJournalBlockHead) return 0;
  const std::uint32_t length = journalBlockHead(bytes).length;
  return length <= kMaxJournalContent ? kJournalBlockHead + length : 0;
}

// Whether a block that this version writes may begin here.
bool mayBegin(std::span<const std::uint8_t> bytes) {
  const JournalBlockHead head = journalBlockHead(bytes);
  return head.type >= 1 && head.type <= static_cast<std::uint16_t>(JournalBlock::End) && head.version == 0 &&
         head.length <= kMaxJournalContent;
}

}  // namespace

JournalBlocks::JournalBlocks(From from) : m_from(from), m_isBegun(from == From::Anywhere) {
  if (m_isBegun) m_bad = Bad{};
}

void JournalBlocks::append(std::string_view bytes) {
  const std::size_t steps = m_at / kStep;
  const auto gone = static_cast<std::ptrdiff_t>(steps * kStep);
  m_pending.erase(m_pending.begin(), m_pending.begin() + gone);
  if (m_crcs.size() > steps) {
    m_crcs.erase(m_crcs.begin(), m_crcs.begin() + static_cast<std::ptrdiff_t>(steps));
  } else {
    m_crcs.clear();
  }
  m_base += steps * kStep;
  m_at -= steps * kStep;
  m_pending.insert(m_pending.end(), bytes.begin(), bytes.end());
}

std::span<const std::uint8_t> JournalBlocks::next() {
  if (m_newer || (!m_isBegun && !takeHead())) return {};
  if (!m_bad) {
    const std::size_t size = sizeOf(rest());
    const bool isOpen = rest().size() < kJournalBlockHead || rest().size() < size;
    if (isOpen && (!m_isEnd || rest().empty())) return {};
    if (!isOpen && size > 0 && journalBlockCrc(rest().first(size)) == journalBlockHead(rest()).crc)
      return taken(size);
    const bool isNoZero = size > 0 && journalBlockHead(rest()).type != 0;
    m_bad = Bad{.begin = place(), .claimed = isNoZero ? size : 0};
  }
  if (!search()) return {};
  endBad(false);
  return taken(sizeOf(rest()));
}

std::span<const std::uint8_t> JournalBlocks::taken(std::size_t size) {
  const Bytes block = rest().first(size);
  m_at += size;
  m_taken = size;
  return block;
}

// False if it is not there yet, or of a newer version.
bool JournalBlocks::takeHead() {
  if (rest().size() < JournalHead::kBytes && !m_isEnd) return false;
  JournalHead head;
  m_isBegun = true;
  m_isHeadWhole = takeJournalHead(rest(), head);
  if (!m_isHeadWhole) {
    if (!rest().empty()) m_bad = Bad{.begin = 0, .claimed = JournalHead::kBytes};
    return true;
  }
  if (head.major > JournalHead::kMajor) {
    m_newer = head.major;
    return false;
  }
  m_at = JournalHead::kBytes;
  return true;
}

// Moves on to the next whole block. False if none is there yet; after the end the bad stretch ends with the
// file.
bool JournalBlocks::search() {
  const auto pass = [&] {
    if (m_pending[m_at++] != 0) m_bad->isZero = false;
  };
  while (rest().size() >= kJournalBlockHead) {
    if (mayBegin(rest())) {
      const std::size_t size = sizeOf(rest());
      if (size > rest().size() && !m_isEnd) return false;
      if (size <= rest().size() && crcOfBlock(size) == journalBlockHead(rest()).crc) return true;
    }
    pass();
  }
  if (!m_isEnd) return false;
  while (!rest().empty()) pass();
  endBad(true);
  return false;
}

void JournalBlocks::endBad(bool isAtEnd) {
  const Bad bad = std::exchange(m_bad, {}).value_or(Bad{});
  m_crcs.clear();
  const std::uint64_t size = place() - bad.begin;
  if (size == 0 || (m_from == From::Anywhere && m_taken == 0)) return;
  if (isAtEnd && (size < kJournalBlockHead || size < bad.claimed || bad.isZero)) {
    m_cutBytes = size;
  } else {
    addDamage(bad.begin, size);
  }
}

void JournalBlocks::addDamage(std::uint64_t at, std::uint64_t bytes) {
  if (m_damage.places == 0) m_damage.firstAt = at;
  if (m_damage.places == 0 || m_damageEnd != at) ++m_damage.places;
  m_damage.bytes += bytes;
  m_damageEnd = at + bytes;
}

// Of the pending bytes before `at`, and of what went before them.
std::uint32_t JournalBlocks::crcUpTo(std::size_t at) {
  const Bytes all(m_pending);
  if (m_crcs.empty()) m_crcs.push_back(0);
  while (m_crcs.size() <= at / kStep)
    m_crcs.push_back(crcAfter(all.subspan((m_crcs.size() - 1) * kStep, kStep), m_crcs.back()));
  const std::size_t step = at / kStep;
  return crcAfter(all.subspan(step * kStep, at - step * kStep), m_crcs[step]);
}

// journalBlockCrc() of the block here. The CRC of a long one comes from those up to its begin and its end, so that many
// overlapping candidates cost little.
std::uint32_t JournalBlocks::crcOfBlock(std::size_t size) {
  if (size <= kShort) return journalBlockCrc(rest().first(size));
  const std::size_t length = size - kJournalBlockHead, begin = m_at + kJournalBlockHead;
  const std::uint32_t content = crcOfBoth(crcUpTo(begin), crcUpTo(begin + length), length);
  return crcOfBoth(crcAfter(rest().first(8), 0), content, length);
}

}  // namespace deckpipe
