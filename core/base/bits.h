// SPDX-License-Identifier: GPL-3.0-or-later
// Bit ranges of an eight-byte payload, in the two orders that the protocols use. The only shifts in the tree
// that take a message apart are here; every field of the catalogue goes through them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace deckpipe {

using Payload = std::array<std::uint8_t, 8>;

static_assert(std::endian::native == std::endian::little, "loadLittle is a plain load");

constexpr std::uint64_t loadLittle(const Payload& bytes) { return std::bit_cast<std::uint64_t>(bytes); }
constexpr std::uint64_t loadBig(const Payload& bytes) {
  return __builtin_bswap64(std::bit_cast<std::uint64_t>(bytes));
}

// Big: offset 0 is the most significant bit of byte 1 and a field's offset is its most significant bit.
// Little: the payload is one little-endian 64-bit number and a field's offset is its least significant bit.
enum class ByteOrder : std::uint8_t { Big, Little };

struct BitRange {
  ByteOrder order = ByteOrder::Big;
  std::uint8_t offset = 0;
  std::uint8_t width = 0;

  // Where the range lies in a 64-bit number loaded in its own order.
  constexpr unsigned shift() const {
    return order == ByteOrder::Big ? 64u - offset - width : static_cast<unsigned>(offset);
  }
  constexpr std::uint64_t mask() const { return width == 64 ? ~0ull : (1ull << width) - 1; }
  // Number of whole payload bytes that must be there for the range to be there.
  constexpr unsigned bytesNeeded() const { return (offset + width + 7u) / 8u; }
};

constexpr std::uint64_t readBits(const Payload& bytes, BitRange r) {
  const std::uint64_t word = r.order == ByteOrder::Big ? loadBig(bytes) : loadLittle(bytes);
  return (word >> r.shift()) & r.mask();
}

// A payload loaded once, for reading many ranges that are known at compile time: the hot path's way.
struct LoadedPayload {
  std::uint64_t little, big;

  explicit constexpr LoadedPayload(const Payload& bytes) : little(loadLittle(bytes)), big(loadBig(bytes)) {}
  template <BitRange R>
  constexpr std::uint64_t read() const {
    return ((R.order == ByteOrder::Big ? big : little) >> R.shift()) & R.mask();
  }
};

constexpr void writeBits(Payload& bytes, BitRange r, std::uint64_t value) {
  std::uint64_t word = r.order == ByteOrder::Big ? loadBig(bytes) : loadLittle(bytes);
  word = (word & ~(r.mask() << r.shift())) | ((value & r.mask()) << r.shift());
  bytes = std::bit_cast<Payload>(r.order == ByteOrder::Big ? __builtin_bswap64(word) : word);
}

constexpr std::int64_t signExtend(std::uint64_t value, unsigned width) {
  const unsigned unused = 64 - width;
  return static_cast<std::int64_t>(value << unused) >> unused;
}

}  // namespace deckpipe
