// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the whole blocks of a journal (journal_bytes.h) in bytes that come in pieces. Behind damage it looks for
// the next place where a block begins whose CRC holds. The reader and the glance at a journal's end use it.
//
//  1. The work is linear in the number of bytes, whatever they are.
//  2. It holds no more than one block and the piece that came last.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "log/journal_bytes.h"
#include "log/reading.h"

namespace deckpipe {

class JournalBlocks {
 public:
  enum class From : bool {
    Head,
    Anywhere
  };  // Anywhere: what stands before the first whole block is no damage

  explicit JournalBlocks(From from = From::Head);

  void append(std::string_view bytes);
  // No more bytes come.
  void end() { m_isEnd = true; }
  // The next whole block with its head, valid until append(). Empty if more bytes are needed, and after end()
  // if there is none.
  std::span<const std::uint8_t> next();
  // No version writes the content of the block that next() gave last: it is damage too.
  void reject() { addDamage(place() - m_taken, m_taken); }

  // Behind the last block that was taken.
  std::uint64_t place() const { return m_base + m_at; }
  const Damage& damage() const { return m_damage; }
  // Of a block whose end is missing, or zeroes that a power cut left; known after end().
  std::uint64_t cutBytes() const { return m_cutBytes; }
  // The major version, if that is newer than this program's: no block is given then.
  std::optional<std::uint16_t> newerVersion() const { return m_newer; }
  // The head is damaged, and no whole block was found so far.
  bool isNothingWhole() const { return !m_isHeadWhole && m_taken == 0 && m_damage.places > 0; }

 private:
  // A stretch without a whole block.
  struct Bad {
    std::uint64_t begin = 0;
    std::uint64_t claimed = 0;  // size of what seems to begin there
    bool isZero = true;         // all that was passed so far
  };

  using Bytes = std::span<const std::uint8_t>;
  Bytes rest() const { return Bytes(m_pending).subspan(m_at); }
  Bytes taken(std::size_t size);
  bool takeHead();
  bool search();
  void endBad(bool isAtEnd);
  void addDamage(std::uint64_t at, std::uint64_t bytes);
  std::uint32_t crcUpTo(std::size_t at);
  std::uint32_t crcOfBlock(std::size_t size);

  const From m_from;
  std::vector<std::uint8_t> m_pending;
  std::uint64_t m_base = 0;  // of the first pending byte
  std::size_t m_at = 0;      // in the pending bytes
  std::size_t m_taken = 0;   // size of the last block
  bool m_isBegun = false;    // the head was looked at
  bool m_isHeadWhole = false;
  bool m_isEnd = false;
  std::optional<std::uint16_t> m_newer;
  std::optional<Bad> m_bad;
  std::vector<std::uint32_t> m_crcs;  // of the pending bytes up to each kStep, while searching
  Damage m_damage;
  std::uint64_t m_damageEnd = 0;
  std::uint64_t m_cutBytes = 0;
};

}  // namespace deckpipe
