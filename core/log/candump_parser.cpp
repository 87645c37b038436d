// SPDX-License-Identifier: GPL-3.0-or-later
#include "log/candump_parser.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "log/candump_line.h"

namespace deckpipe {
namespace {

static_assert(std::endian::native == std::endian::little, "words are loaded as they lie");

constexpr std::uint64_t kOnes = 0x0101'0101'0101'0101;
// The fast path looks no further than this beyond a line's start.
constexpr std::size_t kFastReach = 80;

std::uint64_t load(const char* p) {
  std::uint64_t word = 0;
  std::memcpy(&word, p, sizeof word);
  return word;
}

// The lowest `bytes` bytes of a word; all of them from 8 on.
constexpr std::uint64_t lowBytes(std::size_t bytes) { return bytes >= 8 ? ~0ull : (1ull << 8 * bytes) - 1; }

using Bytes16 [[gnu::vector_size(16)]] = unsigned char;
using Words8 [[gnu::vector_size(16)]] = unsigned short;
using Bytes8 [[gnu::vector_size(8)]] = unsigned char;

struct HexDigits {
  std::uint64_t bytes = 0;  // of the pairs, first pair lowest
  std::size_t count = 0;    // digits before the first character that is none, up to 16
};

// Sixteen characters at once; GCC and clang make SSE2 or NEON of it.
inline HexDigits hexDigits(const char* p) {
  Bytes16 text;
  std::memcpy(&text, p, sizeof text);
  const Bytes16 digit = text - static_cast<unsigned char>('0');
  const Bytes16 letter = (text | static_cast<unsigned char>(0x20)) - static_cast<unsigned char>('a');
  const Bytes16 isDigit = std::bit_cast<Bytes16>(digit < static_cast<unsigned char>(10));
  const Bytes16 isLetter = std::bit_cast<Bytes16>(letter < static_cast<unsigned char>(6));
  const Bytes16 value = (digit & isDigit) | ((letter + static_cast<unsigned char>(10)) & isLetter);
  const Words8 pairs = std::bit_cast<Words8>(value);
  const Words8 bytes = ((pairs << 4) | (pairs >> 8)) & static_cast<unsigned short>(0xFF);

  const auto bad = std::bit_cast<std::array<std::uint64_t, 2>>(~(isDigit | isLetter));
  const std::size_t low = static_cast<std::size_t>(std::countr_zero(bad[0])) / 8;
  const std::size_t high = static_cast<std::size_t>(std::countr_zero(bad[1])) / 8;
  return {std::bit_cast<std::uint64_t>(__builtin_convertvector(bytes, Bytes8)), low < 8 ? low : 8 + high};
}

// "123456) " as microseconds; above 999,999 where it is anything else.
inline std::uint64_t microseconds(const char* p) {
  constexpr std::uint64_t kNone = 1'000'000;
  const std::uint64_t text = load(p);
  if (text >> 48 != (')' | ' ' << 8)) return kNone;
  std::uint64_t digits = text << 16 | 0x3030;  // two leading zeros instead of what follows
  const std::uint64_t above9 = (digits + 0x06 * kOnes) ^ 0x30 * kOnes;
  if (((digits ^ 0x30 * kOnes) | above9) & 0xF0 * kOnes) return kNone;
  digits -= 0x30 * kOnes;
  digits = digits * 10 + (digits >> 8);
  constexpr std::uint64_t pairs = 0x0000'00FF'0000'00FF;
  return ((digits & pairs) * (100 + (1'000'000ull << 32)) +
          (digits >> 16 & pairs) * (1 + (10'000ull << 32))) >>
         32;
}

// Letters up to the first blank; 8 where there is none among the first eight.
inline std::size_t nameLength(std::uint64_t text) {
  const std::uint64_t blanks = text ^ ' ' * kOnes;
  const std::uint64_t found = (blanks - kOnes) & ~blanks & 0x80 * kOnes;
  return static_cast<std::size_t>(std::countr_zero(found)) / 8;
}

constexpr std::size_t namePlace(std::uint64_t letters) { return letters * 0x9E37'79B9'7F4A'7C15 >> 60; }

inline unsigned hexDigit(char c) {
  static constexpr auto table = [] {
    std::array<unsigned char, 256> values{};
    values.fill(0xFF);
    for (unsigned i = 0; i < 10; ++i) values['0' + i] = static_cast<unsigned char>(i);
    for (unsigned i = 0; i < 6; ++i) {
      values['a' + i] = values['A' + i] = static_cast<unsigned char>(10 + i);
    }
    return values;
  }();
  return table[static_cast<unsigned char>(c)];
}

}  // namespace

// (SECOND.123456) NAME 18EFFF80#011D940371000041, or with an 11-bit identifier, fewer bytes, ' R' or ' T'
// behind it, a carriage return; SECOND and NAME as learned from a line before. The place behind the line
// feed, or null for any other line; then `frame` may hold anything.
const char* CandumpParser::fastFrame(const char* p, Frame& frame) {
  if (((load(p) ^ m_prefix[0]) & m_prefixMask[0]) | ((load(p + 8) ^ m_prefix[1]) & m_prefixMask[1])) {
    return nullptr;
  }
  p += m_prefixLength;
  const std::uint64_t fraction = microseconds(p);
  if (fraction > 999'999) return nullptr;
  p += 8;

  // Guessed, so that the processor need not wait for the length before it goes on with the identifier; a
  // wrong guess finds no name.
  const std::uint64_t text = load(p);
  std::size_t length = m_nameLength;
  if (p[length] != ' ') [[unlikely]] {
    length = nameLength(text);
    if (length == 0 || length > 7) return nullptr;
    m_nameLength = length;
  }
  const std::uint64_t letters = text & lowBytes(length);
  const Name& name = m_shortNames[namePlace(letters)];
  if (name.letters != letters) return nullptr;
  p += length + 1;

  if (p[8] == '#') {
    const HexDigits id = hexDigits(p);
    frame.id = __builtin_bswap32(static_cast<std::uint32_t>(id.bytes)) | kExtendedBit;
    if (id.count != 8 || static_cast<unsigned char>(id.bytes) > (kIdMask >> 24)) return nullptr;
    p += 9;
  } else {
    const unsigned first = hexDigit(p[0]), second = hexDigit(p[1]), third = hexDigit(p[2]);
    if (p[3] != '#' || first > 7 || (second | third) > 15) return nullptr;
    frame.id = first << 8 | second << 4 | third;
    p += 4;
  }

  const HexDigits data = hexDigits(p);
  frame.stamp = m_second + static_cast<std::int64_t>(fraction) * 1000;
  frame.channel = static_cast<std::uint8_t>(name.channel);
  frame.spare = static_cast<std::uint8_t>(name.channel >> 8);
  frame.flags = 0;
  if (p[16] == '\n' && data.count == 16) [[likely]] {  // as above: what follows is nothing to wait for
    frame.data = std::bit_cast<Payload>(data.bytes);
    frame.length = 8;
    return p + 17;
  }
  if (data.count % 2 != 0) return nullptr;
  frame.data = std::bit_cast<Payload>(data.bytes & lowBytes(data.count / 2));
  frame.length = static_cast<std::uint8_t>(data.count / 2);
  p += data.count;

  if (*p == ' ' && (p[1] == 'R' || p[1] == 'T')) {
    if (p[1] == 'T') frame.flags = Frame::kSent;
    p += 2;
  }
  if (*p == '\r') ++p;
  if (*p != '\n') return nullptr;
  return p + 1;
}

const char* CandumpParser::readUsual(const char* p, const char* end, const char* readable, Frame*& to,
                                     const Frame* full) {
  if (!m_fastPath) return p;
  Frame* frame = to;
  while (p < end && frame < full && static_cast<std::size_t>(readable - p) >= kFastReach) {
    const char* next = fastFrame(p, *frame);
    if (!next) break;
    p = next;
    ++frame;
  }
  to = frame;
  return p;
}

TextLine CandumpParser::readLine(std::string_view line) { return readCandumpLine(line, m_scratch); }

void CandumpParser::learn(std::string_view line, const TextLine& read, LocalChannel channel) {
  learnSecond(line, read.frame);
  learnName(read.interface, channel);
}

void CandumpParser::learnSecond(std::string_view line, const Frame& frame) {
  const std::size_t dot = line.find('.');
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  // The last second of all is left to the slow path: not every microsecond in it fits.
  constexpr std::int64_t kSecond = 1'000'000'000, kLastSecond = 9'223'372'036;
  if (line.front() != '(' || dot == 1 || dot > 14 || frame.stamp < 0 ||
      frame.stamp / kSecond >= kLastSecond ||
      !std::all_of(line.begin() + 1, line.begin() + static_cast<std::ptrdiff_t>(dot), isDigit)) {
    return;
  }
  m_prefixLength = dot + 1;
  m_prefixMask = {lowBytes(m_prefixLength), lowBytes(m_prefixLength > 8 ? m_prefixLength - 8 : 0)};
  std::array<char, 16> letters{};
  std::copy_n(line.begin(), m_prefixLength, letters.begin());
  m_prefix = {load(letters.data()), load(letters.data() + 8)};
  m_second = frame.stamp / kSecond * kSecond;
}

void CandumpParser::learnName(std::string_view name, LocalChannel channel) {
  if (name.size() > 7) return;
  std::array<char, 8> letters{};
  std::copy(name.begin(), name.end(), letters.begin());
  const std::uint64_t word = load(letters.data());
  m_shortNames[namePlace(word)] = {word, channel};
  m_nameLength = name.size();
}

}  // namespace deckpipe
